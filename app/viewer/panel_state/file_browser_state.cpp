#include "file_browser_state.h"

#include <algorithm>
#include <cstdlib>

#include "export/formats.h"
#include "jobs/open_lesson.h"
#include "run/strings.h"
#include "session/compare_with.h"
#include "session/session_file.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/volume.h"
#include "teach/result.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

std::string countText(std::size_t count, const char* one, const char* many) {
    return grouped(count) + " " + (count == 1 ? one : many);
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
        if (isFolder || isListed(item.path(), task)) entries.push_back({name, isFolder});
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

bool isListed(const fs::path& path, BrowserTask task) {
    switch (task) {
        case BrowserTask::Open:
            return canBeOpened(path);
        case BrowserTask::SaveSession:
            return lowerExtension(path) == kSessionExtension;
        case BrowserTask::Volume:
            return isVolumePath(path);
        case BrowserTask::SavePoints:
            return lowerExtension(path) == ".ply";
        case BrowserTask::Mesh:
            return canHoldMesh(path) || isTraceFile(path.string());
        case BrowserTask::SaveMesh:
            return namesMeshFormat(path);
        case BrowserTask::SaveResult:
            return path.string().ends_with(teach::kResultExtension);
        case BrowserTask::SaveLesson:
            return isLessonFile(path.string());
        case BrowserTask::Export:
            return !lowerExtension(path).empty() && exportFormatOf(path) != nullptr;
    }
    return false;
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

void MeshForm::open() {
    clearLines();
    question.clear();
}

void MeshForm::clearLines() {
    complaint.clear();
    note.clear();
}

bool namesMeshFormat(const fs::path& path) {
    return !lowerExtension(path).empty() && meshFormatOf(path) != nullptr;
}

void MeshForm::followName(const std::string& name) {
    if (!namesMeshFormat(name)) return;
    format = static_cast<std::size_t>(meshFormatOf(name) - meshFormats().data());
}

void MeshForm::choose(std::size_t place, std::string& name) {
    format = place;
    if (namesMeshFormat(name)) {
        name = fs::path(name).replace_extension(meshFormats()[format].extension).string();
    }
}

std::string MeshForm::withFormat(const std::string& typed) const {
    if (namesMeshFormat(typed)) return typed;
    return withExtension(typed, meshFormats()[format].extension).string();
}

std::string sizeText(const MeshSize& size, bool usedOnly) {
    std::string text = countText(size.triangles, "triangle", "triangles") + ", ";
    if (!usedOnly || size.usedPoints == size.points)
        return text + countText(size.points, "point", "points");
    return text + grouped(size.usedPoints) + " of " + countText(size.points, "point", "points");
}

std::string savedText(const SavedMesh& saved) {
    std::string text = "Saved " + countText(saved.triangles, "triangle", "triangles");
    if (lowerExtension(saved.target.path) != ".stl")
        text += " and " + countText(saved.points, "point", "points");
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

}  // namespace se::view
