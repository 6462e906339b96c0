/// What the file browser knows: a folder, what can be opened in it, what was typed. No ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace se::view {

/// What the file browser is for.
enum class BrowserTask : std::uint8_t { Open, SaveSession, Volume, SavePoints, Mesh, SaveMesh };

struct BrowserEntry {
    std::string name;
    bool folder = false;
    friend bool operator==(const BrowserEntry&, const BrowserEntry&) = default;
};

/// What the browser shows, read once per folder.
struct FileBrowsing {
    BrowserTask task = BrowserTask::Open;
    std::filesystem::path folder;
    std::vector<BrowserEntry> entries;
    std::string path;  ///< As typed.
    std::string error;
    bool shown = false;
    int settling = 0;                 ///< Frames in which windows beside it may yet appear.
    bool refocus = false;             ///< The line to type into gets the keyboard back.
    std::filesystem::path overwrite;  ///< The file that was asked about: once more, and it goes.

    /// Lists another folder: folders first, then the files that `task` is about. One that cannot be
    /// read is told in `error`, and what was shown stays.
    void readFolder(const std::filesystem::path& next);
};

/// By extension: what can be opened, or would be written over.
bool isListed(const std::filesystem::path& path, BrowserTask task);
/// By extension: points in a format that can be read, a volume, or a session.
bool canBeOpened(const std::filesystem::path& path);
/// By extension: what can have triangles.
bool canHoldMesh(const std::filesystem::path& path);
/// What a person means by a text typed while `folder` is shown: `~` is the home, `scene:ID` and
/// `sample:...` are no paths.
std::string typedSource(const std::filesystem::path& folder, const std::string& text);
/// With `extension` (".ply") at its end, whatever other dots are in the name.
std::filesystem::path withExtension(std::filesystem::path path, std::string_view extension);

}  // namespace se::view
