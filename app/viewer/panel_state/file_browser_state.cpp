#include "file_browser_state.h"

#include <algorithm>
#include <cstdlib>

#include "mesh_form.h"
#include "run/strings.h"
#include "session/session_file.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

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
           pointFormatOf(path) != nullptr;
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
            return canHoldMesh(path);
        case BrowserTask::SaveMesh:
            return namesMeshFormat(path);
    }
    return false;
}

std::string typedSource(const fs::path& folder, const std::string& text) {
    if (text.empty() || isScene(text) || isSample(text)) return text;
    const char* home = std::getenv("HOME");
    if (home != nullptr && (text == "~" || text.starts_with("~/"))) return home + text.substr(1);
    const fs::path path(text);
    return path.is_relative() ? (folder / path).lexically_normal().string() : text;
}

fs::path withExtension(fs::path path, std::string_view extension) {
    if (lowerExtension(path) != extension) path += extension;
    return path;
}

}  // namespace se::view
