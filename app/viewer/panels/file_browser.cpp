#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

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
};

bool isPointFile(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array kKnown = {".ply", ".xyz", ".obj", ".off", ".noff", ".txt"};
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
    InputSpec spec = context.session().spec();
    spec.source = source;
    context.playback().pause();
    context.session().open(std::move(spec));
    context.ui().fileBrowser = false;
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

void drawFiles(const PanelContext& context, BrowserState& state) {
    heading(context, "Files", fitted(state.folder.string(), 18.0F * context.em));
    ImGui::SetNextItemWidth(-5.0F * context.em);
    const bool entered =
        ImGui::InputTextWithHint("##path", "path of a file or folder", state.path.data(),
                                 state.path.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if (ImGui::Button("Open", {-1.0F, 0.0F}) || entered) {
        const fs::path path(state.path.data());
        std::error_code error;
        if (fs::is_directory(path, error)) {
            readFolder(state, path);
        } else if (!path.empty()) {
            openSource(context, path.string());
        }
    }
    if (!state.error.empty())
        ImGui::TextColored(toVec4(context.palette.rejected), "%s", state.error.c_str());
    if (ImGui::BeginChild("##files", {0, 0}, false)) {
        if (ImGui::Selectable("..")) readFolder(state, fs::path(state.folder).parent_path());
        const std::vector<Entry> entries = state.entries;
        for (const Entry& entry : entries) {
            const std::string shown = entry.folder ? entry.name + "/" : entry.name;
            if (!ImGui::Selectable(shown.c_str())) continue;
            const fs::path path = state.folder / entry.name;
            entry.folder ? readFolder(state, path) : openSource(context, path.string());
        }
    }
    ImGui::EndChild();
}

}  // namespace

void drawFileBrowser(const PanelContext& context) {
    bool& open = context.ui().fileBrowser;
    if (!open) return;
    static BrowserState state;
    std::error_code error;
    if (state.folder.empty()) readFolder(state, fs::current_path(error));
    const float em = context.em;
    const Layout& l = context.layout;
    const glm::vec2 screen(l.status.size.x, l.status.max().y);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(48.0F * em, screen.x - 2.0F * em), std::min(32.0F * em, screen.y - 2.0F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown =
        ImGui::Begin("Open", &open,
                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (shown && ImGui::BeginTable("##open", 2, ImGuiTableFlags_BordersInnerV)) {
        ImGui::TableSetupColumn("scenes", ImGuiTableColumnFlags_WidthStretch, 0.42F);
        ImGui::TableSetupColumn("files", ImGuiTableColumnFlags_WidthStretch, 0.58F);
        ImGui::TableNextColumn();
        drawScenes(context);
        ImGui::TableNextColumn();
        drawFiles(context, state);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace se::view
