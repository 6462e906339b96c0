// The menu bar: a table of rows for each menu, the box with the address, and what is open.
#include <imgui_internal.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "document/actions.h"
#include "document/document.h"
#include "document/link_actions.h"
#include "document/ui_state.h"
#include "layers/layer.h"
#include "panels/widgets/widgets.h"
#include "scene/camera.h"
#include "session/session.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::view {

// The box with the address in the menu bar.

namespace {

/// The line in which an address is typed.
void drawTyped(const PanelContext& context, GoToBox& box) {
    const bool entered =
        textField("##typed", "", box.typed,
                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CharsNoBlank);
    if (context.state<TypingWait>().takeFocus(TypedField::GoTo)) {
        // What was typed at another time is not undone.
        ImGuiInputTextState* before = ImGui::GetInputTextState(ImGui::GetItemID());
        if (before != nullptr && !ImGui::IsItemActive()) before->ID = 0;
        // Dear ImGui's own request for the keyboard focus leaves out menu bars.
        ImGui::GetCurrentContext()->NavNextActivateId = ImGui::GetItemID();
        ImGui::GetCurrentContext()->NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    }
    if (ImGui::IsItemActive()) context.state<TypingWait>().takesKeys();
    const bool left = ImGui::IsItemDeactivated();
    if (entered) actions::goToTyped(context.commands);
    if (left) box.open = false;
    // The view gets the keyboard back.
    if (entered || left) context.ui().closesPopups = true;
}

/// The box with the address.
void drawGoTo(const PanelContext& context, float width) {
    GoToBox& box = context.state<GoToBox>();
    const float em = context.em;
    ImGui::PushFont(context.fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.5F * em, 0.12F * em});
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0F, 0.5F});
    ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.panelRaised));
    ImGui::PushStyleColor(ImGuiCol_Text,
                          toVec4(box.open ? context.palette.text : context.palette.textDim));
    ImGui::SetNextItemWidth(width);
    if (box.open) {
        drawTyped(context, box);
    } else {
        const std::string shown = fitted(addressText(context.session()), width - em);
        if (ImGui::Button((shown + "##goto").c_str(), {width, 0.0F}))
            actions::openGoTo(context.commands);
    }
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
    tooltip(withKeys(context, "Go to", "step.goto") +
            ": 137, 137.sphere.3, +10, -10, 50%, or p812 to select a point");
}

/// Width of the box with the address, and of the window from which it is there, in em.
constexpr float kGoTo = 16.0F;
constexpr float kGoToFrom = 46.0F;

void drawRecent(const PanelContext& context) {
    const std::vector<std::string>& recent = context.ui().recent;
    if (!ImGui::BeginMenu("Recent", !recent.empty())) return;
    for (const std::string& path : recent) {
        const std::string shown = isSample(path) ? recentName(path) : path;
        const std::string name = fittedName(shown, 30.0F * context.em) + "##" + path;
        if (ImGui::MenuItem(name.c_str())) context.document().open(path);
    }
    ImGui::EndMenu();
}

void drawScene(const PanelContext& context, const Scene& scene) {
    if (ImGui::MenuItem(std::string(scene.title).c_str()))
        context.document().open(sceneSource(scene.id));
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

/// Whether an action that switches something shows a check; empty: it is none.
std::optional<bool> checkOf(const PanelContext& context, const Command& command) {
    const UiState& ui = context.ui();
    const std::string_view id = command.id;
    if (id == "view.orthographic") return context.camera().orthographic();
    if (id == "view.spotlight") return ui.spotlight;
    if (id == "view.legend") return ui.settings.legend;
    if (id == "view.names") return ui.settings.names;
    if (id == "view.follow") return ui.follow == Follow::EachDecision;
    if (id == "view.column") return ui.settings.panels.folded;
    if (id == "view.strips") return ui.navigation.stripFolded;
    if (!id.starts_with("layer.")) return std::nullopt;
    const LayerSwitches shown = shownLayers(ui.settings.layers, context.session().stage());
    const std::string_view name = id.substr(std::string_view("layer.").size());
    for (const Layer& layer : layers()) {
        if (layer.name == name) return shown.test(static_cast<std::size_t>(layer.id));
    }
    return std::nullopt;
}

void drawItem(const PanelContext& context, std::string_view id) {
    const Command& command = *findCommand(id);
    const std::string key = context.key(command);
    const bool check = checkOf(context, command).value_or(false);
    const std::string reason(whyUnavailable(command, context.commands));
    if (ImGui::MenuItem(std::string(command.title).c_str(), key.c_str(), check, reason.empty()))
        runCommand(command, context.commands);
    nameItem(context, "item " + std::string(id), reason);
}

void drawLayouts(const PanelContext& context) {
    drawChoices(context, "Layout", "view.layout.", layoutPresets(), context.ui().layoutPreset);
}

void drawMeshStyles(const PanelContext& context) {
    drawChoices(context, "Mesh", "view.mesh.", meshStyles(), context.settings().meshStyle);
}

void drawPointTints(const PanelContext& context) {
    drawChoices(context, "Points", "view.points.", pointTints(), context.settings().pointTint);
}

/// The tasks of the rail, with a check at the open one.
void drawTasks(const PanelContext& context) {
    if (!ImGui::BeginMenu("Panels")) return;
    const bool folded = context.settings().panels.folded;
    for (const TaskRow& row : taskRows()) {
        const bool here = !folded && context.state<Column>().task == row.id;
        if (ImGui::MenuItem(std::string(row.title).c_str(), nullptr, here))
            actions::pickTask(context.commands, row.id);
        nameItem(context, "item " + std::string(row.title));
    }
    drawItem(context, "view.column");
    ImGui::EndMenu();
}

/// A menu, or a submenu that draws itself.
struct Menu {
    const char* title;
    /// Ids of commands, titles of submenus, and kLine between parts.
    std::span<const std::string_view> rows = {};
    void (*draw)(const PanelContext& context) = nullptr;
};

constexpr std::string_view kLine;
constexpr std::string_view kDirections[] = {"view.front",    "view.back",         "view.right",
                                            "view.left",     "view.top",          "view.bottom",
                                            "view.opposite", "view.orthographic", "Up axis"};
constexpr std::string_view kLayers[] = {"layer.normals", "layer.labels", "layer.edges",
                                        "layer.spheres", "layer.links",  "layer.stack",
                                        "view.legend",   "view.names"};
constexpr std::string_view kLooks[] = {"view.theme", "view.larger", "view.smaller",
                                       "view.fullscreen", "view.strips"};
constexpr Menu kSubmenus[] = {{"Recent", {}, drawRecent},
                              {"Scenes", {}, drawSceneMenu},
                              {"Direction", kDirections},
                              {"Up axis", {}, drawUpAxes},
                              {"Layers", kLayers},
                              {"Mesh", {}, drawMeshStyles},
                              {"Points", {}, drawPointTints},
                              {"Layout", {}, drawLayouts},
                              {"Panels", {}, drawTasks},
                              {"Window", kLooks}};
constexpr std::string_view kFile[] = {"file.open",
                                      "Recent",
                                      "Scenes",
                                      "file.new.shape",
                                      "file.new.volume",
                                      kLine,
                                      "file.savemesh",
                                      "file.save",
                                      "file.saveas",
                                      "file.export",
                                      "file.screenshot",
                                      "step.copy",
                                      kLine,
                                      "file.restart",
                                      "file.quit"};
constexpr std::string_view kEdit[] = {"edit.undo",  "edit.redo",        kLine,
                                      "edit.piece", "edit.rules.reset", "edit.whatif.clear",
                                      kLine,        "notes.bookmark",   "step.copy",
                                      "step.paste", "file.copycommand"};
constexpr std::string_view kRun[] = {
    "run.play",    "step.event.next",  "step.pivot.next", "run.start", "run.end",   kLine,
    "run.break",   "run.continue",     "step.alert.next", "ask.why",   "ask.query", kLine,
    "run.compare", "run.compare.mesh", "run.compare.stop"};
constexpr std::string_view kView[] = {
    "view.frame", "view.all", "view.home", "view.follow", "Direction", kLine,   "Layers",
    "Mesh",       "Points",   kLine,       "Layout",      "Panels",    "Window"};
constexpr std::string_view kHelp[] = {"help.guide",    "help.tour",    "help.practice",
                                      kLine,           "help.palette", "help.keys",
                                      "help.editkeys", kLine,          "help.about"};
/// On a phone, above the others: what other windows have beside the menus.
constexpr std::string_view kPhone[] = {"step.goto", "view.layers", "view.legend", "notes.show",
                                       kLine};
constexpr Menu kMenus[] = {
    {"File", kFile}, {"Edit", kEdit}, {"Run", kRun}, {"View", kView}, {"Help", kHelp}};

void drawMenu(const PanelContext& context, const Menu& menu);

void drawMenuRows(const PanelContext& context, std::span<const std::string_view> rows) {
    for (const std::string_view row : rows) {
        const Menu* menu = rowWhere(kSubmenus, [&](const Menu& each) { return each.title == row; });
        if (menu != nullptr) {
            drawMenu(context, *menu);
        } else if (row == kLine) {
            ImGui::Separator();
        } else {
            drawItem(context, row);
        }
    }
}

void drawMenu(const PanelContext& context, const Menu& menu) {
    if (menu.draw != nullptr) return menu.draw(context);
    const bool open = ImGui::BeginMenu(menu.title);
    nameItem(context, std::string("menu ") + menu.title);
    if (!open) return;
    drawMenuRows(context, menu.rows);
    ImGui::EndMenu();
}

void drawMenus(const PanelContext& context) {
    for (const Menu& menu : kMenus) drawMenu(context, menu);
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
    return room > 6.0F * context.em ? fittedName(name, room) : std::string{};
}

}  // namespace

void drawMenuBar(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    const float em = context.em;
    if (!ImGui::BeginMainMenuBar()) return;
    // In a phone's shape the bar has one menu.
    if (!rects.phone) {
        drawMenus(context);
    } else if (const bool menu = ImGui::BeginMenu("Menu"); nameItem(context, "menu"), menu) {
        const float between = kFinger * em - ImGui::GetTextLineHeight();
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, between});
        drawMenuRows(context, kPhone);
        drawMenus(context);
        ImGui::PopStyleVar();
        ImGui::EndMenu();
    }
    float from = ImGui::GetCursorScreenPos().x;
    const bool runs = context.session().ready() && !context.state<GrowthPage>().open;
    // In a narrow window only while something is typed there.
    if (runs && (rects.window.x > kGoToFrom * em || context.state<GoToBox>().open)) {
        const float left = std::max(from + em, 0.5F * (rects.window.x - kGoTo * em));
        const float width = std::min(kGoTo * em, rects.window.x - left - em);
        ImGui::SetCursorScreenPos({left, rects.menu.min.y + 0.15F * em});
        drawGoTo(context, width);
        from = left + width;
    }
    // Aligned to the right end of the rail.
    const float end = rects.window.x - 0.7F * em;
    const std::string note = fittingNote(context, end - from - em);
    const float width = ImGui::CalcTextSize(note.c_str()).x;
    const float y = 0.5F * (rects.menu.size.y - ImGui::GetTextLineHeight());
    // Text of a menu bar would be lower by its padding.
    ImGui::GetWindowDrawList()->AddText({end - width, rects.menu.min.y + y},
                                        toU32(context.palette.textDim), note.c_str());
    ImGui::EndMainMenuBar();
}

}  // namespace se::view
