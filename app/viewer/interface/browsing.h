/// What the file browser knows: a folder, what can be opened in it, what was typed. No ImGui.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace se::view {

struct BrowserEntry {
    std::string name;
    bool folder = false;
    friend bool operator==(const BrowserEntry&, const BrowserEntry&) = default;
};

/// What the browser shows, read once per folder.
struct FileBrowsing {
    std::filesystem::path folder;
    std::vector<BrowserEntry> entries;
    std::string path;  ///< As typed.
    std::string error;
    bool shown = false;
    bool refocus = false;             ///< The line to type into gets the keyboard back.
    std::filesystem::path overwrite;  ///< The file that was asked about: once more, and it goes.

    /// Lists another folder: folders first, then what can be opened. One that cannot be read is
    /// told in `error`, and what was shown stays.
    void readFolder(const std::filesystem::path& next);
};

/// By extension: points in a format that can be read, or a session.
bool canBeOpened(const std::filesystem::path& path);
/// What a person means by a text typed while `folder` is shown: `~` is the home, `scene:ID` is no
/// path.
std::string typedSource(const std::filesystem::path& folder, const std::string& text);
/// With .sesession at its end, whatever other dots are in the name.
std::filesystem::path withSessionExtension(std::filesystem::path path);

}  // namespace se::view
