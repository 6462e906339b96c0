// The menu bar, filled from the groups of the commands.
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

/// Whether a command is in a submenu.
bool isChoice(const Command& command) {
    const auto among = [&](std::string_view menu) { return command.id.starts_with(menu); };
    return (among("view.layout.") || among("view.mesh.") || among("view.points.") ||
            among("view.up.")) &&
           !command.id.ends_with(".next");
}

void drawItem(const PanelContext& context, const Command& command) {
    const std::string key = context.key(command);
    if (ImGui::MenuItem(std::string(command.title).c_str(), key.c_str()))
        runCommand(command, context.commands);
}

/// One menu from all commands of a group.
void drawMenuGroup(const PanelContext& context, std::string_view group) {
    if (!ImGui::BeginMenu(std::string(group).c_str())) return;
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
