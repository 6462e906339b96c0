#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "../session_file.h"
#include "panel.h"
#include "spiraling_edge/scenes.h"
#include "widgets.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

struct Entry {
    std::string name;
    bool folder = false;
};

/// What the browser shows, read once per folder.
struct BrowserState {
    fs::path folder;
    std::vector<Entry> entries;
    std::array<char, 1024> path{};
    std::string error;
    bool shown = false;
    std::string overwrite;  ///< The file that was asked about: once more, and it is replaced.
};

void setPath(BrowserState& state, const std::string& text) {
    const std::size_t length = std::min(text.size(), state.path.size() - 1);
    std::copy_n(text.begin(), length, state.path.begin());
    state.path[length] = '\0';
}

bool isPointFile(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array kKnown = {".ply", ".xyz", ".obj", ".off", ".noff", ".txt", ".sesession"};
    return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

void readFolder(BrowserState& state, const fs::path& folder) {
    std::error_code error;
    fs::directory_iterator items(folder, fs::directory_options::skip_permission_denied, error);
    if (error) {
        state.error = "Cannot read " + folder.string() + ".";
        return;
    }
    state.error.clear();
    state.folder = folder;
    state.entries.clear();
    for (const fs::directory_entry& item : items) {
        const std::string name = item.path().filename().string();
        if (name.starts_with('.')) continue;
        const bool isFolder = item.is_directory(error);
        if (isFolder || isPointFile(item.path())) state.entries.push_back({name, isFolder});
    }
    std::sort(state.entries.begin(), state.entries.end(), [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
}

void openSource(const PanelContext& context, const std::string& source) {
    context.ui().requests.open = source;
    context.ui().fileBrowser = false;
}

/// A name without an extension gets ours; what is there is replaced only at the second time.
void saveTo(const PanelContext& context, BrowserState& state, fs::path path) {
    if (path.is_relative()) path = state.folder / path;
    if (!path.has_extension()) path += kSessionExtension;
    std::error_code error;
    const bool own = path == context.ui().sessionPath;
    if (!own && fs::exists(path, error) && state.overwrite != path) {
        state.overwrite = path;
        state.error = path.filename().string() + " exists already. Save once more to replace it.";
        return;
    }
    context.ui().requests.saveSessionAs = path;
    context.ui().fileBrowser = false;
}

/// A name to begin with: that of the session, else that of the input.
std::string proposedName(const PanelContext& context) {
    const std::string& session = context.ui().sessionPath;
    if (!session.empty()) return fs::path(session).filename().string();
    if (!context.session().ready()) return {};
    std::string name = context.session().model().name;
    if (name.starts_with("scene:")) name = name.substr(6);
    return fs::path(name).stem().string() + std::string(kSessionExtension);
}

/// The folder of what is open, else where the program was started, else home.
fs::path firstFolder(const PanelContext& context) {
    std::error_code error;
    const UiState& ui = context.ui();
    const std::string& source = context.session().spec().source;
    const bool file = !source.empty() && !source.starts_with("scene:");
    const fs::path near = !ui.sessionPath.empty() ? fs::path(ui.sessionPath)
                          : file                  ? fs::path(source)
                                                  : fs::path();
    if (near.empty()) return fs::current_path(error);
    return fs::absolute(near, error).parent_path();
}

void drawScenes(const PanelContext& context) {
    heading(context, "Scenes");
    if (ImGui::BeginChild("##scenes", {0, 0}, false)) {
        for (const Scene& scene : scenes()) {
            if (ImGui::Selectable(std::string(scene.title).c_str())) {
                openSource(context, "scene:" + std::string(scene.id));
            }
            tooltip("scene:" + std::string(scene.id) + "\n" + std::string(scene.watch));
        }
    }
    ImGui::EndChild();
}

bool saving(const PanelContext& context) {
    return context.ui().browser == BrowserTask::SaveSession;
}

/// The line to type into, with its button.
void drawPathLine(const PanelContext& context, BrowserState& state) {
    const bool save = saving(context);
    ImGui::SetNextItemWidth(-5.0F * context.em);
    if (!state.shown) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint(
        "##path", save ? "name of the session file" : "path of a file or folder", state.path.data(),
        state.path.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if (ImGui::Button(save ? "Save" : "Open", {-1.0F, 0.0F}) || entered) {
        const fs::path path(state.path.data());
        std::error_code error;
        if (fs::is_directory(path, error)) {
            readFolder(state, path);
        } else if (path.empty()) {
            state.error = "A name is needed.";
        } else if (save) {
            saveTo(context, state, path);
        } else {
            openSource(context, path.string());
        }
    }
    if (!state.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
        ImGui::TextWrapped("! %s", state.error.c_str());
        ImGui::PopStyleColor();
    }
}

void drawFiles(const PanelContext& context, BrowserState& state) {
    const float room = std::max(6.0F * context.em, ImGui::GetContentRegionAvail().x * 0.75F);
    heading(context, "Files", fitted(state.folder.string(), room));
    drawPathLine(context, state);
    if (ImGui::BeginChild("##files", {0, 0}, false)) {
        if (ImGui::Selectable("..")) readFolder(state, fs::path(state.folder).parent_path());
        const std::vector<Entry> entries = state.entries;
        for (const Entry& entry : entries) {
            const bool session = fs::path(entry.name).extension() == kSessionExtension;
            if (saving(context) && !entry.folder && !session) continue;
            const std::string shown = entry.folder ? entry.name + "/" : entry.name;
            if (!ImGui::Selectable(shown.c_str())) continue;
            const fs::path path = state.folder / entry.name;
            if (entry.folder) {
                readFolder(state, path);
            } else if (saving(context)) {
                setPath(state, entry.name);
            } else {
                openSource(context, path.string());
            }
        }
        if (entries.empty()) ImGui::TextDisabled("No point files or sessions in this folder.");
    }
    ImGui::EndChild();
}

void drawOpen(const PanelContext& context, BrowserState& state) {
    if (!ImGui::BeginTable("##open", 2, ImGuiTableFlags_BordersInnerV)) return;
    ImGui::TableSetupColumn("scenes", ImGuiTableColumnFlags_WidthStretch, 0.42F);
    ImGui::TableSetupColumn("files", ImGuiTableColumnFlags_WidthStretch, 0.58F);
    ImGui::TableNextColumn();
    drawScenes(context);
    ImGui::TableNextColumn();
    drawFiles(context, state);
    ImGui::EndTable();
}

/// Once for every time that the browser opens: files may have come and gone.
void prepare(const PanelContext& context, BrowserState& state) {
    if (state.folder.empty() || saving(context)) state.folder = firstFolder(context);
    readFolder(state, state.folder);
    setPath(state, saving(context) ? proposedName(context) : std::string{});
    state.overwrite.clear();
}

}  // namespace

void drawFileBrowser(const PanelContext& context) {
    bool& open = context.ui().fileBrowser;
    static BrowserState state;
    if (!open) {
        state.shown = false;
        return;
    }
    if (!state.shown) prepare(context, state);
    const float em = context.em;
    const Layout& l = context.layout;
    const glm::vec2 screen(l.status.size.x, l.status.max().y);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(48.0F * em, screen.x - 2.0F * em), std::min(32.0F * em, screen.y - 2.0F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown =
        ImGui::Begin(saving(context) ? "Save session###browser" : "Open###browser", &open,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (shown) saving(context) ? drawFiles(context, state) : drawOpen(context, state);
    state.shown = true;
    ImGui::End();
}

}  // namespace se::view
