/// State of the file browser: a folder, the files that can be opened in it, the typed text. No
/// ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace se::view {

/// Purpose of the file browser.
enum class BrowserTask : std::uint8_t { Open, SaveSession, Volume, SavePoints, Mesh, SaveMesh };

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

/// By extension: files that can be opened, or would be overwritten.
bool isListed(const std::filesystem::path& path, BrowserTask task);
/// By extension: points in a format that can be read, a volume, or a session.
bool canBeOpened(const std::filesystem::path& path);
/// By extension: files that can have triangles.
bool canHoldMesh(const std::filesystem::path& path);
/// Meaning of a text typed while `folder` is shown: `~` is the home folder, `scene:ID` and
/// `sample:...` are no paths.
std::string typedSource(const std::filesystem::path& folder, const std::string& text);
/// File name with `extension` (".ply") at its end, regardless of other dots in it.
std::filesystem::path withExtension(std::filesystem::path path, std::string_view extension);

}  // namespace se::view
