#include "file_browser_state.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <utility>

#include "jobs/open_lesson.h"
#include "run/strings.h"
#include "session/compare_with.h"
#include "session/session_file.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/sampling/volume.h"
#include "teach/result.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPly = ".ply";

template <const std::string_view& Extension>
bool endsIn(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.size() > Extension.size() && lowerCase(name).ends_with(Extension);
}

}  // namespace

void FileBrowsing::readFolder(const fs::path& next) {
    std::error_code failed;
    fs::directory_iterator items(next, fs::directory_options::skip_permission_denied, failed);
    if (failed) {
        error = "Cannot read " + next.string() + ".";
        return;
    }
    error.clear();
    folder = next;
    entries.clear();
    for (const fs::directory_entry& item : items) {
        const std::string name = item.path().filename().string();
        if (name.starts_with('.')) continue;
        const bool isFolder = item.is_directory(failed);
        if (isFolder || rowOf(task).lists(item.path())) entries.push_back({name, isFolder});
    }
    std::sort(entries.begin(), entries.end(), [](const BrowserEntry& a, const BrowserEntry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
}

bool canBeOpened(const fs::path& path) {
    return lowerExtension(path) == kSessionExtension || isVolumePath(path) ||
           isLesson(path.string()) || isTraceFile(path.string()) || pointFormatOf(path) != nullptr;
}

bool canHoldMesh(const fs::path& path) {
    const PointFormat* format = pointFormatOf(path);
    return format != nullptr && format->faces;
}

const BrowserTaskRow& rowOf(BrowserTask task) {
    static const std::vector<BrowserTaskRow> kRows = {
        {BrowserTask::Open, "Open", "path of a file or folder",
         "No point files, sessions or lessons in this folder.", canBeOpened},
        {BrowserTask::SaveSession, "Save session", "name of the session file",
         "No sessions in this folder.", endsIn<kSessionExtension>, true, kSessionExtension},
        {BrowserTask::Volume, "New from volume",
         "path of a volume, " + wordList(volumeExtensions(), "or"),
         "No volumes (" + wordList(volumeExtensions(), "") + ") in this folder.",
         [](const fs::path& path) { return isVolumePath(path); }},
        {BrowserTask::SavePoints, "Save new points", "name of the PLY file",
         "No PLY files in this folder.", endsIn<kPly>, true, kPly},
        {BrowserTask::Mesh, "Compare with a mesh or trace",
         "path of a trace (.setrace) or a mesh: " +
             listText(pointFormats(), &PointFormat::name, "or", &PointFormat::faces),
         "No traces, and no files that can hold a mesh, in this folder.",
         [](const fs::path& path) { return canHoldMesh(path) || isTraceFile(path.string()); }},
        {BrowserTask::SaveMesh, "Save mesh", "name of the mesh file",
         "No " + listText(meshFormats(), &MeshFormat::name, "or") + " files in this folder.",
         [](const fs::path& path) { return MeshForm::ofName(path) != nullptr; }, true},
        {BrowserTask::SaveResult, "Save result", "name of the result file",
         "No results in this folder.", endsIn<teach::kResultExtension>, true,
         teach::kResultExtension},
        {BrowserTask::SaveLesson, "Save as lesson", "name of the lesson",
         "No lessons in this folder.",
         [](const fs::path& path) { return isLessonFile(path.string()); }, true,
         teach::kLessonExtension},
        {BrowserTask::Export, "Export", "name of the file: " + exportExtensions(),
         "No exports in this folder.",
         [](const fs::path& path) { return ExportForm::ofName(path) != nullptr; }, true}};
    const auto place = static_cast<std::size_t>(task);
    assert(kRows[place].task == task);
    return kRows[place];
}

std::string typedSource(const fs::path& folder, const std::string& text) {
    if (text.empty() || isScene(text) || isSample(text) || (isLesson(text) && !isLessonFile(text)))
        return text;
    const char* home = std::getenv("HOME");
    if (home != nullptr && (text == "~" || text.starts_with("~/"))) return home + text.substr(1);
    const fs::path path(text);
    return path.is_relative() ? (folder / path).lexically_normal().string() : text;
}

fs::path withExtension(fs::path path, std::string_view extension) {
    if (!path.string().ends_with(extension) && lowerExtension(path) != extension) path += extension;
    return path;
}

void MeshForm::clearLines() {
    complaint.clear();
    note.clear();
}

std::string sizeText(std::size_t triangles, std::size_t points, std::size_t allPoints) {
    return withS(triangles, "triangle") + ", " +
           (points == allPoints ? "" : grouped(points) + " of ") + withS(allPoints, "point");
}

std::string savedText(const SavedMesh& saved) {
    std::string text = "Saved " + withS(saved.triangles, "triangle");
    if (lowerExtension(saved.target.path) != ".stl") text += " and " + withS(saved.points, "point");
    text += " to " + saved.target.path + ".";
    if (saved.shift) {
        text += " Positions are relative to " + shiftText(*saved.shift) +
                ": add this offset to get the input coordinates.";
    }
    if (saved.capped) text += " The run was stopped by the rule cap: the mesh is incomplete.";
    return text;
}

std::string replaceText(const std::string& path, const std::string& source) {
    std::error_code error;
    const std::string name = fs::path(path).filename().string();
    const bool input = fs::equivalent(path, source, error) && !error;
    return name +
           (input ? " is the input itself. Replace the points?" : " exists already. Replace it?");
}

void ExportForm::open() { complaint.clear(); }

bool ExportForm::hasCaptions() const {
    return frames != ExportFrames::Picture || chosen().captioned ||
           chosen().content != FrameContent::Pixels;
}

bool ExportForm::hasSpeed() const { return chosen().animated(); }

/// Adds the range or the steps to an order.
Status ExportForm::addFrames(ExportOrder& order, const std::string& address,
                             const SharedLesson& lesson) const {
    if (frames == ExportFrames::Pivot) {
        Result<FrameRange> range = rangeAround(address);
        if (!range) return Error{"There is no pivot at the start of the run."};
        order.range = range.value();
    }
    if (frames == ExportFrames::Range) {
        if (from.empty() || to.empty()) return Error{"Enter both positions of the range."};
        order.range = FrameRange{from, to, unit};
    }
    if (frames != ExportFrames::Lesson) return success();
    if (lesson == nullptr) return Error{"No lesson is open."};
    order.lesson = lesson;
    if (steps.empty()) return success();
    Result<std::vector<std::size_t>> chosen = stepsFromText(steps, lesson->lesson.steps.size());
    if (!chosen) return chosen.error();
    order.steps = std::move(chosen.value());
    return success();
}

Result<ExportOrder> ExportForm::order(const std::string& address,
                                      const SharedLesson& lesson) const {
    ExportOrder order;
    order.path = path;
    order.captions = captions || !hasCaptions();
    if (!pictureSize(size))
        return Error{size + ": expected a size such as 1280x800, from 320x240 on"};
    const std::optional<double> speed = numberIn<double>(perSecond);
    if (hasSpeed() && (!speed || *speed < kLeastPerSecond || *speed > kMostPerSecond))
        return Error{perSecond + ": expected frames per second, from 0.1 to 60"};
    order.perSecond = speed.value_or(order.perSecond);
    if (const Status added = addFrames(order, address, lesson); !added) return added.error();
    if (const Status possible = checkExport(order, false); !possible) return possible.error();
    return order;
}

}  // namespace se::view
