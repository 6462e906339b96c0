/// State of the file browser: a folder, the files that can be opened in it, the typed text; and the
/// choices for saving a mesh in it. No ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "export/formats.h"
#include "jobs/mesh_export.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::view {

/// Purpose of the file browser.
enum class BrowserTask : std::uint8_t {
    Open,
    SaveSession,
    Volume,
    SavePoints,
    Mesh,
    SaveMesh,
    SaveResult,
    SaveLesson,
    Export,
};

/// One row per purpose.
struct BrowserTaskRow {
    BrowserTask task = BrowserTask::Open;
    std::string title;    ///< Of the dialog.
    std::string hint;     ///< In the line of the name, while it is empty.
    std::string nothing;  ///< In place of the files, in a folder without any.
    /// By extension: files that can be opened, or would be overwritten.
    bool (*lists)(const std::filesystem::path& path) = nullptr;
    bool saves = false;
    std::string_view extension = {};  ///< Of the saved file; empty: it has a choice of formats.
};
const BrowserTaskRow& rowOf(BrowserTask task);

struct BrowserEntry {
    std::string name;
    bool folder = false;
    friend bool operator==(const BrowserEntry&, const BrowserEntry&) = default;
};

/// Content of the browser, read once per folder.
struct FileBrowsing {
    BrowserTask task = BrowserTask::Open;
    std::filesystem::path folder;
    std::vector<BrowserEntry> entries;
    std::string path;  ///< As typed.
    std::string error;
    bool shown = false;
    int settling = 0;                 ///< Frames in which windows beside it may still appear.
    bool refocus = false;             ///< The input line gets the keyboard focus back.
    std::filesystem::path overwrite;  ///< The file to be replaced: a second request replaces it.

    /// Lists another folder: folders first, then the files for `task`. If it cannot be
    /// read, `error` has the reason, and the old list stays.
    void readFolder(const std::filesystem::path& next);
};

/// By extension: points in a format that can be read, a volume, or a session.
bool canBeOpened(const std::filesystem::path& path);
/// By extension: files that can have triangles.
bool canHoldMesh(const std::filesystem::path& path);
/// Meaning of a text typed while `folder` is shown: `~` is the home folder, `scene:ID` and
/// `sample:...` are no paths.
std::string typedSource(const std::filesystem::path& folder, const std::string& text);
/// File name with `extension` (".ply") at its end, regardless of other dots in it.
std::filesystem::path withExtension(std::filesystem::path path, std::string_view extension);

/// The format of a file that a dialog saves: one of a table, which is chosen, or that of the
/// extension of the name.
template <auto Formats, auto FormatOf>
struct ChosenFormat {
    std::size_t format = 0;  ///< A position in the table.

    /// The format of the name's extension; null if it has none of them.
    static const auto* ofName(const std::filesystem::path& name) {
        return lowerExtension(name).empty() ? nullptr : FormatOf(name);
    }
    const auto& chosen() const { return Formats()[format]; }
    /// Takes the format of the name's extension, if it has one.
    void followName(const std::string& name) {
        if (const auto* found = ofName(name))
            format = static_cast<std::size_t>(found - Formats().data());
    }
    /// Chooses a format; a name with another extension gets its extension.
    void choose(std::size_t place, std::string& name) {
        format = place;
        if (ofName(name) != nullptr)
            name = std::filesystem::path(name).replace_extension(chosen().extension).string();
    }
    /// The typed name, with the extension of the format unless it has one of those.
    std::string withFormat(const std::string& typed) const {
        if (typed.empty() || ofName(typed) != nullptr) return typed;
        return typed + std::string(chosen().extension);
    }
};

struct MeshForm : ChosenFormat<meshFormats, meshFormatOf> {
    bool usedOnly = false;
    bool faultFields = false;

    // Set by MeshSaving.
    bool saving = false;
    std::string complaint;    ///< Reason why nothing was saved or copied; empty: no problem.
    std::string note;         ///< Note about the copied command.
    std::string savedPath;    ///< File of the last saved mesh of `savedSource`.
    std::string savedSource;  ///< A source, see RunSpec.

    /// Clears the lines about the attempt before, or the previous use of the dialog; choices stay.
    void clearLines();
};

/// The size of a mesh with some of all points, as a line of the dialog: "19 304 triangles, 21 000
/// points".
std::string sizeText(std::size_t triangles, std::size_t points, std::size_t allPoints);
/// The notice after saving: size and path.
std::string savedText(const SavedMesh& saved);
/// The question before a file is replaced; `source` is that of the input.
std::string replaceText(const std::string& path, const std::string& source);

// Choices and progress of the dialog Export. No ImGui.

/// Frames that the dialog offers.
enum class ExportFrames : std::uint8_t {
    Picture,  ///< What the view shows.
    Pivot,    ///< All decisions of the pivot at the cursor.
    Range,    ///< `from` to `to`.
    Lesson,   ///< `steps` of the open lesson.
};

struct ExportForm : ChosenFormat<exportFormats, exportFormatOf> {
    ExportFrames frames = ExportFrames::Picture;
    std::string from;
    std::string to;
    PlayUnit unit = PlayUnit::SubStep;
    std::string steps;  ///< "2,4-6"; empty: all.
    std::string size = "1280x800";
    bool captions = true;
    std::string perSecond = "2";  ///< Frames of an animation.
    std::string path;             ///< The file to write.
    /// The export is to be made, or being made: it ends by itself, or when this is cleared.
    bool working = false;

    // Set by the export.
    std::size_t made = 0;
    std::size_t total = 0;  ///< 0: not known yet.
    std::string complaint;  ///< Reason why nothing was exported; empty: no problem.

    /// Clears the messages of the previous use of the dialog; choices stay.
    void open();
    /// Whether the format has captions with these frames, and frames that follow each other in
    /// time.
    bool hasCaptions() const;
    bool hasSpeed() const;
    /// The order of these choices, for `path`; `address`: of the cursor; `lesson`: the open one, or
    /// null. Fails with a sentence.
    Result<ExportOrder> order(const std::string& address,
                              const SharedLesson& lesson = nullptr) const;

  private:
    Status addFrames(ExportOrder& order, const std::string& address,
                     const SharedLesson& lesson) const;
};

}  // namespace se::view
