#include "app_page.h"

#include <algorithm>
#include <array>
#include <utility>

#include "jobs/open_lesson.h"
#include "link.h"
#include "paint/svg_text.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/sampling/volume.h"
#include "teach/lesson_read.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

constexpr ByteLimit kLimit{std::uint64_t{64} << 20U, "a page has no room for more"};

/// The files of a page, by their paths below a folder.
class PageFiles {
  public:
    explicit PageFiles(const fs::path& folder) : folder_(folder.lexically_normal()) {}

    /// Path of a file in the page.
    std::string nameOf(const fs::path& path) const {
        return path.lexically_normal().lexically_relative(folder_).generic_string();
    }
    bool has(const fs::path& path) const {
        const std::string name = nameOf(path);
        return std::any_of(files.begin(), files.end(),
                           [&](const PackedFile& each) { return each.name == name; });
    }
    /// Reads a file. Fails with a sentence.
    Status add(const fs::path& path) {
        const std::string name = nameOf(path);
        if (name.empty() || name.starts_with(".."))
            return Error{path.string() + ": a page has files of the folder " + folder_.string() +
                         " alone, and of those in it."};
        if (has(path)) return success();
        if (isUnfit(path)) return Error{path.string() + ": expected a regular file."};
        Result<std::string> bytes = readBytes(path, kLimit);
        if (!bytes) return bytes.error();
        files.push_back({name, std::move(bytes.value())});
        return success();
    }

    std::vector<PackedFile> files;

  private:
    fs::path folder_;
};

/// Adds the file of an input of a lesson; of another lesson, also the input of that.
Status addInput(PageFiles& files, std::string source) {
    while (!isScene(source) && !isPractice(source) && !files.has(source)) {
        if (const Status added = files.add(source); !added) return added;
        if (!isLessonFile(source)) return success();
        const Result<teach::LessonReading> other = teach::readLessonFile(source);
        if (!other) return other.error();
        source = teach::lessonSource(other.value().lesson.input, fs::path(source).parent_path());
    }
    return success();
}

/// A lesson that is a file.
Result<PageContent> ofLessonFile(PageContent content, const OpenedLesson& opened) {
    const auto& [source, folder, lesson, right] = opened;
    PageFiles files(folder);
    if (const Status added = files.add(source); !added) return added.error();
    std::vector<std::string> inputs{lesson.input};
    for (const teach::LessonStep& each : lesson.steps) inputs.push_back(each.input);
    for (const std::string& each : inputs) {
        if (each.empty()) continue;
        const Status added = addInput(files, teach::lessonSource(each, folder));
        if (!added) return added.error();
    }
    content.options.lesson = files.nameOf(source);
    content.files = std::move(files.files);
    return content;
}

Result<PageContent> ofLesson(const Options& o) {
    const std::string& source = o.input.source;
    if (!o.given.empty())
        return Error{std::string(o.given.front().field->key) +
                     " does not go with a lesson, which has its own options"};
    PageContent content{o, source, {}};
    content.options.input = {};
    const SharedLesson& opened = o.exported->lesson;
    if (opened) content.title = opened->lesson.title;
    if (opened && isLessonFile(source)) return ofLessonFile(std::move(content), *opened);
    content.options.lesson = isLesson(source) ? source : embeddedLessonSource(source);
    return content;
}

/// Files that lie side by side in a page, wherever they were.
class GatheredFiles {
  public:
    /// Adds a file. Its path in the page.
    std::string add(const std::string& path) {
        PageFiles beside(fs::path(path).parent_path());
        Status added = beside.add(path);
        const fs::path data = isVolumePath(path) ? dataFileOf(path) : fs::path();
        if (added && !data.empty()) added = beside.add(data);
        if (!added && status) status = added;
        for (PackedFile& each : beside.files) addOnce(std::move(each));
        return beside.nameOf(path);
    }

    std::vector<PackedFile> files;
    Status status = success();  ///< The first failure.

  private:
    void addOnce(PackedFile file) {
        for (const PackedFile& each : files) {
            if (each.name != file.name) continue;
            if (each.bytes != file.bytes && status)
                status = Error{"Two files are called " + file.name +
                               ", and a page has them in one folder: rename one."};
            return;
        }
        files.push_back(std::move(file));
    }
};

/// A run. What a link cannot name, notes and given starts, goes into a session.
Result<PageContent> ofRun(const Options& o) {
    if (isStandardInput(o.input.source))
        return Error{"--app needs the points as a file, not from standard input"};
    const fs::path named = o.session && !o.sessionPath.empty() ? o.sessionPath : o.input.source;
    PageContent content{
        o, isSample(o.input.source) ? o.input.source : named.filename().string(), {}};
    GatheredFiles files;
    const auto move = [&files](const std::string& path) { return files.add(path); };
    RunSpec& input = content.options.input;
    input.source = movedSource(input.source, move);
    if (o.with && o.with->isFile()) content.options.withText = move(o.with->path);
    if (o.session || !input.start.empty()) {
        SessionFile session = o.session.value_or(SessionFile{});
        session.input = std::exchange(input, {});
        if (session.with.isFile()) session.with.path = move(session.with.path);
        input.source = "page" + std::string(kSessionExtension);
        files.files.push_back({input.source, sessionToJson(session, {})});
    }
    if (!files.status) return files.status.error();
    content.files = std::move(files.files);
    return content;
}

/// Replaces the only occurrence of a text. False if there is none.
bool replace(std::string& page, std::string_view old, const std::string& text) {
    const std::size_t at = page.find(old);
    if (at != std::string::npos) page.replace(at, old.size(), text);
    return at != std::string::npos;
}

}  // namespace

Result<PageContent> contentOf(const Options& options) {
    const bool lesson = options.exported->lesson || isLesson(options.input.source);
    return lesson ? ofLesson(options) : ofRun(options);
}

Result<std::string> pageWith(const PageContent& content, std::string page) {
    std::string start =
        "<meta name=\"start\" content=\"" + escapedXml(linkText(content.options)) + "\">";
    for (const PackedFile& each : content.files)
        start += "\n<script type=\"text/plain\" data-file=\"" + escapedXml(each.name) + "\">" +
                 base64Of(deflated(each.bytes)) + "</script>";
    if (!replace(page, "<meta name=\"start\" content=\"\">", start) ||
        !replace(page, "<title>Spiraling Edge</title>",
                 "<title>" + escapedXml(content.title) + "</title>"))
        return Error{"it is no page of this version of the program"};
    return page;
}

Result<fs::path> findPage(const fs::path& programFolder) {
    const std::array folders{programFolder,
                             programFolder.parent_path() / "share" / "spiraling-edge"};
    std::error_code error;
    for (const fs::path& each : folders) {
        if (fs::is_regular_file(each / kPageName, error)) return each / kPageName;
    }
    return Error{
        std::string(kPageName) + ", the program as one page, is neither in " + folders[0].string() +
        " nor in " + folders[1].string() +
        ". Install the package spiraling-edge-web, which has it; or app/web/build.sh makes it in "
        "build-web/: copy it to one of these."};
}

}  // namespace se::view
