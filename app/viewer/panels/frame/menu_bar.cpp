// The menu bar, filled from the groups of the commands.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "commands/command_actions.h"
#include "layers/layer.h"
#include "panel_state/ui_state.h"
#include "panels/widgets/widgets.h"
#include "scene/camera.h"
#include "scene/up_axis.h"
#include "session/session.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

namespace {

void drawRecent(const PanelContext& context) {
    const std::vector<std::string>& recent = context.ui().recent;
    if (!ImGui::BeginMenu("Recent", !recent.empty())) return;
    for (const std::string& path : recent) {
        const std::string shown = isSample(path) ? recentName(path) : path;
        const std::string name = fitted(shown, 30.0F * context.em) + "##" + path;
        if (ImGui::MenuItem(name.c_str())) context.requests().open = path;
    }
    ImGui::EndMenu();
}

void drawScene(const PanelContext& context, const Scene& scene) {
    if (ImGui::MenuItem(std::string(scene.title).c_str()))
        context.requests().open = sceneSource(scene.id);
    tooltip(std::string(scene.watch));
}

/// Built-in inputs: those that succeed, and those that fail.
void drawSceneMenu(const PanelContext& context) {
    if (ImGui::BeginMenu("Scenes")) {
        for (const Scene& scene : scenes()) drawScene(context, scene);
        ImGui::EndMenu();
    }
    if (!ImGui::BeginMenu("What goes wrong")) return;
    for (const FailureScene& each : failureScenes()) drawScene(context, each.scene);
    ImGui::EndMenu();
}

/// A submenu of the rows of a table, with a check at the current one. Each row is a command as
/// well, "view.layout.NAME", which the menu around it leaves out.
template <class Rows, class Id>
void drawChoices(const PanelContext& context, const char* menu, const std::string& commands,
                 const Rows& rows, Id current) {
    if (!ImGui::BeginMenu(menu)) return;
    for (const auto& row : rows) {
        if (ImGui::MenuItem(std::string(row.title).c_str(), nullptr, row.id == current))
            context.run(commands + std::string(row.name));
    }
    ImGui::EndMenu();
}

/// The submenu Up axis, with a check at the axis of the view.
void drawUpAxes(const PanelContext& context) {
    if (!ImGui::BeginMenu("Up axis")) return;
    const bool chosen = context.settings().up.has_value();
    if (ImGui::MenuItem("Automatic", nullptr, !chosen)) context.run("view.up.auto");
    for (const UpAxis axis : {UpAxis::X, UpAxis::Y, UpAxis::Z}) {
        const std::string name(upAxisName(axis));
        if (ImGui::MenuItem(name.c_str(), nullptr, context.camera().up() == axis))
            context.run("view.up." + name);
    }
    ImGui::EndMenu();
}

/// Commands that open a panel are in the submenus of its group.
bool opensPanel(const Command& command) {
    const auto panels = sidePanels();
    return command.group == "View" &&
           std::any_of(panels.begin(), panels.end(),
                       [&](const SidePanel& each) { return command.title == each.title; });
}

/// Whether a command is in a submenu.
bool isChoice(const Command& command) {
    const auto among = [&](std::string_view menu) { return command.id.starts_with(menu); };
    return opensPanel(command) || ((among("view.layout.") || among("view.mesh.") ||
                                    among("view.points.") || among("view.up.")) &&
                                   !command.id.ends_with(".next"));
}

/// The panels of a group, with a check at the open one.
void drawPanelMenu(const PanelContext& context, const char* menu, PanelGroup group) {
    if (!ImGui::BeginMenu(menu)) return;
    const std::string& open = context.state<OpenTab>().open[static_cast<std::size_t>(group)];
    bool first = open.empty();
    for (const SidePanel& panel : sidePanels()) {
        if (panel.group != group || placeOf(context.rects, panel) != PanelPlace::Tab) continue;
        if (ImGui::MenuItem(panel.title, nullptr,
                            std::exchange(first, false) || open == panel.title))
            actions::openTab(context.commands, panel.title);
        nameItem(context, std::string("item ") + panel.title);
    }
    ImGui::EndMenu();
}

/// Whether an action that switches something shows a check; empty: it is none.
std::optional<bool> checkOf(const PanelContext& context, const Command& command) {
    const UiState& ui = context.ui();
    const std::string_view id = command.id;
    if (id == "view.orthographic") return context.camera().orthographic();
    if (id == "view.verdict") return !ui.verdict.closed;
    if (id == "view.spotlight") return ui.spotlight;
    if (id == "view.legend") return ui.settings.legend;
    if (id == "view.names") return ui.settings.names;
    if (id == "view.groups") return ui.settings.panels.folded || ui.panelsQuiet;
    if (id == "view.drawer") return ui.navigation.drawerFolded;
    if (!id.starts_with("layer.")) return std::nullopt;
    const LayerSwitches shown = shownLayers(ui.settings.layers, context.session().stage());
    const std::string_view name = id.substr(std::string_view("layer.").size());
    for (const Layer& layer : layers()) {
        if (layer.name == name) return shown.test(static_cast<std::size_t>(layer.id));
    }
    return std::nullopt;
}

void drawItem(const PanelContext& context, const Command& command) {
    // Actions that begin a part of the menu View.
    constexpr std::array<std::string_view, 5> kMenuParts = {
        "view.front", "view.fullscreen", "view.layout.next", "view.verdict", "view.panel.next"};
    if (std::find(kMenuParts.begin(), kMenuParts.end(), command.id) != kMenuParts.end())
        ImGui::Separator();
    const std::string key = context.key(command);
    const bool check = checkOf(context, command).value_or(false);
    if (ImGui::MenuItem(std::string(command.title).c_str(), key.c_str(), check))
        runCommand(command, context.commands);
    nameItem(context, "item " + std::string(command.id));
}

/// One menu from all commands of a group.
void drawMenuGroup(const PanelContext& context, std::string_view group) {
    const bool open = ImGui::BeginMenu(std::string(group).c_str());
    nameItem(context, "menu " + std::string(group));
    if (!open) return;
    const UiState& ui = context.ui();
    for (const Command& command : commands()) {
        if (command.group != group) continue;
        if (command.id == "view.up.auto") drawUpAxes(context);
        if (isChoice(command)) continue;
        drawItem(context, command);
        if (command.id == "file.open") {
            drawRecent(context);
            drawSceneMenu(context);
        }
        if (command.id == "view.legend") {
            ImGui::Separator();
            drawPanelMenu(context, "Understand", PanelGroup::Understand);
            drawPanelMenu(context, "Find", PanelGroup::Find);
            drawPanelMenu(context, "Change", PanelGroup::Change);
        }
        if (command.id == "view.layout.next")
            drawChoices(context, "Layout", "view.layout.", layoutPresets(), ui.layoutPreset);
        if (command.id == "view.mesh.next") {
            drawChoices(context, "Mesh", "view.mesh.", meshStyles(), ui.settings.meshStyle);
            drawChoices(context, "Points", "view.points.", pointTints(), ui.settings.pointTint);
        }
    }
    ImGui::EndMenu();
}

/// Description of the open input, as many whole words of it as fit.
std::string fittingNote(const PanelContext& context, float room) {
    const Session& session = context.session();
    if (!session.ready() || context.state<GrowthPage>().open) return {};
    const std::string& name = session.model().name;
    // For new points the name has their number.
    const std::string number = isSample(session.input().spec().source)
                                   ? std::string{}
                                   : "   " + grouped(session.model().points.size()) + " points";
    const std::string points = name + number;
    for (const std::string& note :
         {points + "   " + session.input().spec().rules + " rules", points, name}) {
        if (ImGui::CalcTextSize(note.c_str()).x <= room) return note;
    }
    return room > 6.0F * context.em ? fitted(name, room) : std::string{};
}

}  // namespace

void drawMenuBar(const PanelContext& context) {
    if (!ImGui::BeginMainMenuBar()) return;
    std::string_view last;
    for (const Command& command : commands()) {
        if (command.group == last) continue;
        last = command.group;
        drawMenuGroup(context, last);
    }
    // Aligned to the right end of the headings below.
    const float end = context.rects.menu.max().x - 0.7F * context.em;
    const float room = end - ImGui::GetCursorScreenPos().x;
    const std::string note = fittingNote(context, room - context.em);
    const float width = ImGui::CalcTextSize(note.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
    ImGui::TextDisabled("%s", note.c_str());
    ImGui::EndMainMenuBar();
}

}  // namespace se::view
