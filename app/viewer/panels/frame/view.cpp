// The view of the scene: the overlays in the order in which they take room, the lasso, and what a
// click or a drag means.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/comparison.h"
#include "document/actions.h"
#include "document/alert_actions.h"
#include "document/ask_actions.h"
#include "document/ui_state.h"
#include "input/view_drag.h"
#include "layers/layer.h"
#include "lesson/lesson_walk.h"
#include "paint/labels.h"
#include "panel_state/settings.h"
#include "panel_state/side_panels.h"
#include "panel_state/view_tools.h"
#include "panels/panel.h"
#include "panels/widgets/screen_painter.h"
#include "panels/widgets/widgets.h"
#include "run/model.h"
#include "scene/motion.h"
#include "scene/palette.h"
#include "scene/picking.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

// The Layers panel: a row per layer, with a pin that holds it on or off.

namespace {

/// A pin: upright and filled if the layer is pinned, a ring if the stage decides.
void drawPin(const PanelContext& context, glm::vec2 center, LayerMode mode) {
    const float em = context.em;
    ScreenPainter p(context);
    if (mode == LayerMode::Automatic)
        return p.circle(center, 0.26F * em, p.ink(&Palette::textDim, 0.6F).line(p.px(0.1F)));
    const Ink ink = p.ink(&Palette::accent);
    p.circle(center - glm::vec2(0.0F, 0.16F * em), 0.28F * em, ink);
    p.line(center, center + glm::vec2(0.0F, 0.45F * em), ink.line(p.px(0.1F)));
}

/// By LayerMode.
constexpr std::array<const char*, 3> kPinTexts = {
    "Automatic: the stage decides.\nClick to pin it as it is now.",
    "Pinned: shown in every stage.\nClick to unpin.",
    "Pinned: hidden in every stage.\nClick to unpin."};
static_assert(static_cast<std::size_t>(LayerMode::PinnedOff) + 1 == kPinTexts.size());

/// True if the content of the layer is derived, not from the input.
bool isDerived(const Session& session, LayerId layer) {
    if (!session.ready()) return false;
    const PrepareReport& report = session.model().report;
    if (layer == LayerId::Normals) return report.derived.normals || report.derived.orientation;
    if (layer == LayerId::Links) return report.neighborsComputed;
    return layer == LayerId::Walls && report.derived.types;
}

void drawSwitch(const PanelContext& context, const Layer& layer, bool shown) {
    const Session& session = context.session();
    LayerModes& modes = context.settings().layers;
    LayerMode& mode = modeOf(modes, layer.id);
    ImGui::PushID(static_cast<int>(layer.id));
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("##pin", {side, side})) {
        mode = mode != LayerMode::Automatic ? LayerMode::Automatic
               : shown                      ? LayerMode::PinnedOn
                                            : LayerMode::PinnedOff;
    }
    tooltip(kPinTexts[static_cast<std::size_t>(mode)]);
    drawPin(context, {corner.x + 0.5F * side, corner.y + 0.5F * side}, mode);
    ImGui::SameLine(0.0F, 0.2F * context.em);
    const bool rests = mode == LayerMode::Automatic && !shown;
    if (rests) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.textDim));
    bool value = shown;
    std::string title(layer.title);
    if (isDerived(session, layer.id)) title += " (derived)";
    if (ImGui::Checkbox(title.c_str(), &value)) toggleLayer(modes, layer.id, session.stage());
    nameItem(context, "layer " + std::string(layer.name));
    if (rests) ImGui::PopStyleColor();
    if (const Command* command = findCommand("layer." + std::string(layer.name))) {
        dimAtRight(context.key(*command));
    }
    ImGui::PopID();
}

void drawLayerSwitches(const PanelContext& context) {
    LayerModes& modes = context.settings().layers;
    const LayerSwitches shown = shownLayers(modes, context.session().stage());
    heading(context, "Layers", "a pin holds a layer");
    for (const Layer& layer : layers()) {
        drawSwitch(context, layer, shown.test(static_cast<std::size_t>(layer.id)));
    }
    ImGui::Spacing();
    ImGui::BeginDisabled(modes == LayerModes{});
    if (ImGui::Button("Unpin all")) modes = {};
    ImGui::EndDisabled();
    ImGui::Checkbox("Legend", &context.settings().legend);
    bool light = context.settings().theme == Theme::Light;
    if (ImGui::Checkbox("Light theme", &light)) context.run("view.theme");
    dimAtRight("T");
}

// For an audience: a halo at the pointer, and a spotlight on the neighborhood of the pivot, beyond
// which the picture keeps a quarter of its strength.

constexpr float kStrengthBeyond = 0.25F;
/// Radius of the halo, and the least one of the spotlight, in em.
constexpr float kHalo = 1.4F;
constexpr float kLeastSpot = 4.0F;
constexpr float kMarginOfSpot = 1.5F;

void drawSpotlight(const PanelContext& context) {
    const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
    if (marks.empty()) return;
    glm::vec2 low = marks.front().at;
    glm::vec2 high = low;
    for (const LabelMark& each : marks) {
        low = glm::min(low, each.at);
        high = glm::max(high, each.at);
    }
    const glm::vec2 center = 0.5F * (low + high);
    const float em = context.em;
    float radius = kLeastSpot * em;
    for (const LabelMark& each : marks)
        radius = std::max(radius, glm::distance(center, each.at) + kMarginOfSpot * em);
    // A ring that is wide enough to cover the rest of the view.
    const glm::vec2& size = context.rects.view.size;
    const float width = 2.0F * (size.x + size.y) + radius;
    ScreenPainter painter(context);
    painter.circle(center, radius + 0.5F * width,
                   painter.ink(&Palette::background, 1.0F - kStrengthBeyond).line(width));
}

void drawHalo(const PanelContext& context) {
    const glm::vec2 pointer = pointerInWindow();
    if (!context.rects.view.contains(pointer)) return;
    const float radius = kHalo * context.em;
    ScreenPainter painter(context);
    painter.circle(pointer, radius, painter.ink(&Palette::pivot, 0.15F));
    painter.circle(pointer, radius,
                   painter.ink(&Palette::pivot, 0.8F).line(std::max(1.5F, 0.12F * context.em)));
}

/// In Present, the spotlight on the neighborhood of the pivot, if it is on, and the halo at the
/// pointer.
void drawForAudience(const PanelContext& context) {
    if (context.rects.layoutPreset != LayoutPreset::Present || context.beside) return;
    if (context.ui().spotlight) drawSpotlight(context);
    drawHalo(context);
}

// The plane of the panel Section, marked in the view while the panel is open: where it cuts the
// tangent plane, and the normal, named at the end that the panel has on the left: the tested point
// is on the right.

/// Length of the normal, as a share of the reach.
constexpr double kNormalShare = 0.5;
constexpr float kPlaneDash = 0.5F;

void dashedLine(ScreenPainter& painter, glm::vec2 from, glm::vec2 to, const Ink& ink, float dash) {
    const float length = glm::distance(from, to);
    if (length <= 0.0F) return;
    const glm::vec2 way = (to - from) / length;
    for (float done = 0.0F; done < length; done += 2.0F * dash)
        painter.line(from + done * way, from + std::min(done + dash, length) * way, ink);
}

/// The plane of the panel Section, while that is open.
void drawSectionPlane(const PanelContext& context) {
    const SectionPanel& panel = context.state<SectionPanel>();
    const NormalSection& section = panel.made;
    const bool shown = ImGui::GetFrameCount() - panel.shownIn <= 1;
    if (context.beside || !shown || section.empty()) return;
    const Model& model = context.session().shown();
    const ScreenProjection screen(context);
    const Vec3& pivot = model.points.position[section.pivot];
    const auto at = [&](const Vec3& offset) { return screen.at(model.toView(pivot + offset)); };
    const auto left = at(-section.reach * section.along);
    const auto right = at(section.reach * section.along);
    const auto foot = at(Vec3(0.0));
    const auto tip = at(kNormalShare * section.reach * section.normal);
    if (!left || !right || !foot || !tip) return;
    const float em = context.em;
    ScreenPainter painter(context);
    const float width = painter.px(0.1F);
    const Ink rim = painter.ink(&Palette::background, 0.7F).line(3.0F * width);
    const Ink ink = painter.ink(&Palette::text);
    for (const auto& [from, to] : {std::pair{*left, *right}, {*foot, *tip}}) {
        dashedLine(painter, from, to, rim, kPlaneDash * em);
        dashedLine(painter, from, to, ink.line(width), kPlaneDash * em);
    }
    const Type type{0.84F * em};
    const Rect& view = context.rects.view;
    const glm::vec2 room = painter.textSize("section", type) + glm::vec2(0.4F * em, 0.0F);
    const glm::vec2 corner =
        glm::clamp(*left - glm::vec2(0.2F * em + room.x, 0.4F * em), view.min, view.max() - room);
    painter.box({corner, room}, painter.ink(&Palette::background, 0.75F), 0.15F * em);
    painter.text({corner.x + 0.2F * em, corner.y}, "section", ink, type);
}

// The pins of places with faults that are too small to be seen.

/// On a head of this strength a text in the color of the background can be read.
constexpr float kReadableFrom = 0.6F;

/// A pin of places with faults, and where it is.
struct FaultPin {
    Pin pin;
    Rect head;
    bool hovered = false;
};

Type pinType(const PanelContext& context) {
    return {0.9F * context.em, Typeface::Strong, Align::Middle};
}

/// "3 places, first place 4: 1 hole of 3 edges."
std::string tipOf(const Pin& pin, const RunFailureSearch& found) {
    return (pin.count == 1 ? "Place " : withS(pin.count, "place") + ", the most severe: place ") +
           grouped(pin.place + 1) + ", " + describe(found.places[pin.place], found.all) +
           ".\nClick to show it.";
}

/// "×5": no number of a place.
std::string countText(const Pin& pin) { return "\u00d7" + std::to_string(pin.count); }

void drawHead(const PanelContext& context, const FaultPin& each) {
    const float em = context.em;
    ScreenPainter p(context);
    const float alpha = each.hovered ? 1.0F : each.pin.strength;
    const Rect& head = each.head;
    const glm::vec2 foot(each.pin.tip.x, std::clamp(each.pin.tip.y, head.min.y, head.max().y));
    const float line = std::max(1.5F, 0.12F * em);
    const Ink ink = p.ink(&Palette::rejected, alpha);
    // With a rim of the background, so that it stands out from loops of the same color.
    const Ink rim = p.ink(&Palette::background, alpha);
    p.line(each.pin.tip, foot, rim.line(3.0F * line));
    p.line(each.pin.tip, foot, ink.line(line));
    const float round = 0.5F * head.size.y;
    p.box(head.min - line, head.max() + line, rim, round + line);
    p.box(head, ink, round);
    if (each.hovered) p.box(head, p.ink(&Palette::text).line(line), round);
    if (each.pin.count == 1) return;
    const Type type = pinType(context);
    p.text({head.min.x + 0.5F * head.size.x,
            std::round(head.min.y + 0.5F * (head.size.y - type.size))},
           countText(each.pin),
           p.ink(alpha > kReadableFrom ? &Palette::background : &Palette::rejected), type);
}

/// The pins on the finished mesh; a click on one shows its most severe place. To be called before
/// the scene takes the remaining clicks.
std::vector<FaultPin> offerFaultPins(const PanelContext& context) {
    std::vector<FaultPin> shown;
    const RunFailureSearch* found = context.session().finishedFaults();
    if (context.beside || found == nullptr || !showsFinishedMesh(context.commands)) return shown;
    const Model& model = context.session().model();
    const ScreenProjection projection(context);
    std::vector<PinPlace> places;
    for (const FaultPlace& each : found->places) {
        const glm::vec3 center = model.toView(each.center);
        // Outside of every view where it is behind the eye.
        const glm::vec2 at = projection.at(center).value_or(context.rects.view.min - 1.0F);
        places.push_back({at, projection.pixels(center, sizeOnMesh(model, each))});
    }
    for (const Pin& pin : pinsOf(places, context.rects.view, context.em)) {
        const float width =
            pin.count == 1 ? 0.0F
                           : ScreenPainter(context).textSize(countText(pin), pinType(context)).x;
        FaultPin each{pin, headOf(pin, width, context.rects.view, context.em)};
        const std::string name = "pin " + std::to_string(pin.place + 1);
        ImGui::SetCursorScreenPos(toVec2(each.head.min));
        if (ImGui::InvisibleButton(("##" + name).c_str(), toVec2(each.head.size)))
            showPlace(context.commands, pin.place);
        each.hovered = ImGui::IsItemHovered();
        nameItem(context, name, each.hovered ? tipOf(pin, *found) : "");
        shown.push_back(each);
    }
    return shown;
}

void drawFaultPins(const PanelContext& context, std::span<const FaultPin> pins) {
    // The most severe last, on top.
    for (auto each = pins.rbegin(); each != pins.rend(); ++each) drawHead(context, *each);
}

/// The disc, a large sign of the pivot, and the arrow from its center to the tip, in em.
constexpr float kDisc = 0.85F;
constexpr float kTip = 1.75F;
constexpr float kInset = 2.0F;

/// `way`: from the middle of the arrow to its tip.
void drawArrow(const PanelContext& context, glm::vec2 at, glm::vec2 way, bool hovered) {
    const float em = context.em;
    const glm::vec2 across(-way.y, way.x);
    ScreenPainter p(context);
    const Ink ink = p.ink(&Palette::pivot);
    const glm::vec2 neck = at + kDisc * 0.55F * em * way;
    p.polygon({at + kTip * em * way, neck + 0.8F * em * across, neck - 0.8F * em * across}, ink);
    p.circle(at, kDisc * em, p.ink(hovered ? &Palette::panelRaised : &Palette::background));
    p.circle(at, kDisc * em, ink.line(std::max(1.5F, 0.14F * em)));
    p.circle(at, 0.45F * kDisc * em, ink);
}

/// The arrow to the pivot, if the pivot is outside of the view. Takes clicks, which frame the
/// pivot: to be called before the scene takes the remaining ones.
std::optional<Rect> drawPivotArrow(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready() || session.picture().pivot == kNone) return std::nullopt;
    const Rect& view = context.rects.view;
    const Index pivot = session.picture().pivot;
    const auto arrow =
        edgeArrow(cameraOf(context), session.shown().place[pivot], view.size, kInset * context.em);
    if (!arrow) return std::nullopt;
    const glm::vec2 half(kTip * context.em);
    // Above the caption, which lies on the view's lower edge.
    const float lowest = (1.0F - context.ui().viewPart().coveredBelow) * view.size.y - half.y;
    const glm::vec2 at = view.min + glm::vec2(arrow->at.x, std::min(arrow->at.y, lowest));
    const Rect rect{at - half, 2.0F * half};
    ImGui::SetCursorScreenPos(toVec2(rect.min));
    if (ImGui::InvisibleButton("##pivotArrow", toVec2(rect.size)))
        context.ui().frame = FrameRequest::Decision;
    drawArrow(context, at, arrow->way, ImGui::IsItemHovered());
    tooltip("The pivot, " + nameOf(pivot, session.names()) +
            ", is outside of the view.\nClick to center it.");
    context.where()["pivot arrow"] = rect;
    return rect;
}

/// Sets a breakpoint on all events of the enclosed points, and marks them.
void breakWithin(const PanelContext& context, std::span<const glm::vec2> path) {
    Session& session = context.session();
    if (path.empty()) return;
    const std::vector<Index> points =
        pointsWithin(session.model(), cameraOf(context), context.rects.view.size, path);
    if (points.empty())
        return session.messages().say("There is no point inside the lasso that faces this way.");
    addBreakpoint(context.commands,
                  {"lasso, " + grouped(points.size()) + " points", amongLine(points)});
    actions::showPart(context.commands, kBreakpointsPart);
    session.highlights().mark(points);
}

/// Ctrl with a left drag draws a lasso around points; true while it does, and as it ends. To be
/// called right after the scene's own item.
bool handleLasso(const PanelContext& context) {
    BreakLasso& lasso = context.state<BreakLasso>();
    if (ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl &&
        ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        lasso.line.begin(pointerInWindow(), PieceShape::Lasso);
        lasso.beside = context.beside;
        context.playback().pause();
    }
    if (!lasso.line.drawing || lasso.beside != context.beside) return false;
    if (const auto path = followLine(context, lasso.line)) breakWithin(context, *path);
    return true;
}

glm::vec2 localMouse(const Rect& view) { return pointerInWindow() - view.min; }

bool isOn(const PanelContext& context, LayerId layer) {
    return shownLayers(context.settings().layers, context.session().stage())
        .test(static_cast<std::size_t>(layer));
}

/// Tolerance of clicks, in em; larger while a question for points is open.
constexpr float kClickEms = 0.6F;
constexpr float kAnswerEms = 1.0F;

/// A question for points is open in this view.
bool asksForPoints(const PanelContext& context) {
    const LessonPanel& panel = context.state<LessonPanel>();
    return !context.beside && panel.walk.isOpen() && panel.walk.takesPoints();
}

float reachOfClick(const PanelContext& context) {
    return (asksForPoints(context) ? kAnswerEms : kClickEms) * context.em;
}

/// The thing under the mouse. Only visible things can be picked.
Pick underMouse(const PanelContext& context) {
    const Session& session = context.session();
    const Rect& view = context.rects.view;
    const bool mesh = isOn(context, LayerId::Triangles);
    const bool rings = isOn(context, LayerId::EdgeRing);
    const PickScene scene{
        session.shown(), isOn(context, LayerId::Points),
        mesh ? session.shownTriangles() : std::span<const Triangle>{},
        session.picture().repaired ? nullptr : &session.meshIndex(),
        rings ? std::span<const RingPath>(session.picture().rings) : std::span<const RingPath>{}};
    return pick(scene, {cameraOf(context), view.size, localMouse(view), reachOfClick(context)});
}

/// While a question for points is open, a click marks a point.
bool answerByClick(const PanelContext& context, const Selection& picked) {
    LessonPanel& panel = context.state<LessonPanel>();
    if (!asksForPoints(context)) return false;
    if (picked.kind == SelectionKind::Point && !panel.countsRoom())
        panel.walk.toggle(picked.points[0]);
    return true;
}

/// A click selects, a double click centers the orbit and selects nothing. So a click
/// counts only when it can no longer become a double click.
void handleClicks(const PanelContext& context) {
    DoubleClickFilter& click = context.state<DoubleClickFilter>();
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        click.takeBack();
        const Pick found = underMouse(context);
        if (found.what.kind != SelectionKind::None) context.camera().lookAt(found.place);
        return;
    }
    const bool single = io.MouseClickedLastCount[ImGuiMouseButton_Left] == 1;
    if (isClick(context, ImGuiMouseButton_Left) && single) {
        // Counted from the press, like a double click.
        const double until =
            io.MouseClickedTime[ImGuiMouseButton_Left] + double{io.MouseDoubleClickTime};
        click.begin(underMouse(context).what, until);
    }
    const auto picked = click.due(ImGui::GetTime());
    if (picked && !answerByClick(context, *picked)) context.session().select(*picked);
}

/// A right click that was no drag opens the context menu.
void handleRightClick(const PanelContext& context) {
    if (!isClick(context, ImGuiMouseButton_Right)) return;
    const Selection what = underMouse(context).what;
    SubjectMenu& menu = context.state<SubjectMenu>();
    if (!context.beside) return menu.open(what);
    if (what.kind != SelectionKind::None) menu.openBeside(what);
}

/// Highlights the neighbor of the pivot under the pointer, here and on the dial. Only neighbors: a
/// search of all points in every frame would take too long.
void hoverNeighbor(const PanelContext& context) {
    const Session& session = context.session();
    const Index pivot = session.picture().pivot;
    if (pivot == kNone) return;
    const Rect& view = context.rects.view;
    context.state<Navigation>().pointedAt =
        pickAmong(session.shown(), session.shown().points.neighbors[pivot], cameraOf(context),
                  view.size, localMouse(view), reachOfClick(context));
}

void handleMouse(const PanelContext& context) {
    const bool piece = context.state<PieceTool>().on && !context.beside;
    if (context.session().ready() && (piece ? handlePieceTool : handleLasso)(context)) return;
    if (context.session().ready() && !piece && handleMoveTool(context)) return;
    moveCameraByMouse(context);
    if (!context.session().ready()) return;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) hoverNeighbor(context);
    handleClicks(context);
    if (!context.state<LessonPanel>().hides()) handleRightClick(context);
}

/// The name of the shown state, while the user looks back.
std::optional<Rect> drawShownState(const PanelContext& context) {
    const Session& session = context.session();
    if (!context.state<LookBack>().on() || !session.ready() || session.event() == nullptr) {
        return std::nullopt;
    }
    const Rect& view = context.rects.view;
    const float em = context.em;
    const std::string text =
        session.showsEarlierMesh()
            ? "before the change"
            : (session.showsBefore() ? "before " : "after ") + toString(session.address());
    ScreenPainter p(context);
    const Type type{em, Typeface::Strong};
    const glm::vec2 extent = p.textSize(text, type);
    const glm::vec2 at(view.min.x + 0.5F * (view.size.x - extent.x), view.min.y + 0.9F * em);
    const glm::vec2 pad(0.6F * em, 0.25F * em);
    const Rect place{at - pad, extent + 2.0F * pad};
    p.box(place, p.ink(&Palette::panel, 0.94F), 0.3F * em);
    p.text(at, text, p.ink(session.showsBefore() ? &Palette::textDim : &Palette::test), type);
    return place;
}

/// The caption, where it lies in the view; framing knows how much of the view it covers.
std::optional<Rect> drawOwnCaption(const PanelContext& context) {
    if (!context.beside) context.ui().coveredBelow = 0.0F;
    const PictureLook& look = context.ui().picture;
    const bool wanted = !look.viewAlone || look.caption;
    if (!wanted || !context.rects.captionInView()) return std::nullopt;
    const std::optional<Rect> plate = drawCaption(context);
    const Rect& view = context.rects.view;
    if (plate && !context.beside)
        context.ui().coveredBelow = (view.max().y - plate->min.y) / view.size.y;
    return plate;
}

constexpr const char* kLayersTitle = "Layers";

/// The button of the menu of the layers, in a corner of the view, and the menu.
std::optional<Rect> drawLayersMenu(const PanelContext& context) {
    const bool none = context.beside || context.ui().picture.viewAlone ||
                      context.rects.layoutPreset == LayoutPreset::Present;
    if (none || !context.session().ready()) return std::nullopt;
    const float em = context.em;
    const Rect& view = context.rects.view;
    const Rect place{view.min + glm::vec2(0.7F, 0.6F) * em,
                     {textWidth(kLayersTitle) + 1.2F * em, 1.6F * em}};
    ImGui::SetCursorScreenPos(toVec2(place.min));
    // On a phone the menu has it.
    const bool phone = context.rects.phone;
    const bool clicked = !phone && ImGui::InvisibleButton("##layersButton", toVec2(place.size));
    if (!phone) {
        const bool hovered = ImGui::IsItemHovered();
        nameItem(context, "layers menu", "What the view draws, and when");
        ScreenPainter p(context);
        p.box(place, p.ink(hovered ? &Palette::panelRaised : &Palette::panel, 0.9F), 0.3F * em);
        p.text(place.min + glm::vec2(0.6F, 0.25F) * em, kLayersTitle,
               p.ink(hovered ? &Palette::text : &Palette::textDim), {em});
    }
    if (std::exchange(context.state<Navigation>().opensLayers, false) || clicked)
        ImGui::OpenPopup("##layers");
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.7F * em, 0.55F * em));
    ImGui::SetNextWindowPos({place.min.x, place.max().y + 0.2F * em});
    if (ImGui::BeginPopup("##layers")) {
        drawLayerSwitches(context);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
    return phone ? std::nullopt : std::optional(place);
}

/// Channels of the draw list, from below. What takes clicks comes before the scene, which takes
/// the remaining ones, and lies over it.
enum Channel { kSceneChannel, kButtonChannel, kWordChannel, kSignChannel, kChannels };

void noteTaken(std::vector<Rect>& taken, const std::optional<Rect>& place) {
    if (place) taken.push_back(*place);
}

/// Overlays without clicks. Each avoids those before it; labels come last, since they find a place
/// anywhere.
void drawOver(const PanelContext& context, std::vector<Rect> taken) {
    noteTaken(taken, drawOwnCaption(context));
    noteTaken(taken, drawShownState(context));
    noteTaken(taken, drawColorBar(context, taken));
    // In Compare the column beside the views explains the colors.
    const bool compared = context.beside || context.rects.otherView.size.x > 0.0F;
    const bool legend =
        context.rects.phone ? context.state<Navigation>().phoneLegend : context.settings().legend;
    if (legend && !compared) noteTaken(taken, drawLegend(context, taken));
    drawLabels(context, taken);
}

void drawWithOverlays(const PanelContext& context) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(kChannels);
    std::vector<Rect> taken;
    list.ChannelsSetCurrent(kSignChannel);
    noteTaken(taken, drawPivotArrow(context));
    noteTaken(taken, drawAxes(context, taken));
    const std::vector<FaultPin> pins = offerFaultPins(context);
    list.ChannelsSetCurrent(kButtonChannel);
    noteTaken(taken, drawLayersMenu(context));
    list.ChannelsSetCurrent(kSceneChannel);
    offerView(context);
    handleMouse(context);
    drawViewPicture(context);
    drawFaultPins(context, pins);
    drawForAudience(context);
    list.ChannelsSetCurrent(kWordChannel);
    drawOver(context, std::move(taken));
    list.ChannelsMerge();
    if (const auto& lasso = context.state<BreakLasso>(); lasso.beside == context.beside)
        drawEnclosingLine(context, lasso.line);
    drawSectionPlane(context);
    drawMoveWay(context);
    if (!context.beside) drawEnclosingLine(context, context.state<PieceTool>().line);
}

}  // namespace

void drawView(const PanelContext& context, const char* window) {
    if (beginView(context, window)) {
        const PictureLook& look = context.ui().picture;
        if (look.labels && !look.pointLabels) {
            drawWithOverlays(context);
        } else {
            offerView(context);
            handleMouse(context);
            drawViewPicture(context);
            if (look.labels) drawLabels(context, {});
            drawOwnCaption(context);
        }
    }
    ImGui::End();
}

// The two views of the layout Compare: their titles, and the second view.

namespace {

void drawTitle(const PanelContext& context, const Rect& bar, const ComparedTitle& title) {
    if (bar.size.x < context.em) return;
    const std::string window = "##title" + title.letter;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    // Lower than the minimum height of windows, or it would cover the top of the view.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    const bool open =
        beginRegion(window.c_str(), bar, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    if (open) {
        ScreenPainter painter(context);
        drawTitleBar(painter, bar, title);
    }
    ImGui::End();
}

/// The second view before there is anything to compare.
void drawEmptyView(const PanelContext& context) {
    const Rect& view = context.rects.otherView;
    if (beginRegion("##otherEmpty", view)) {
        const Comparison* now = context.state<ComparePage>().now;
        const bool chosen = now != nullptr && now->chosen();
        const float width = std::min(view.size.x - 2.0F * context.em, 20.0F * context.em);
        // The button is visible in a low view as well.
        const float top = std::max(0.3F * context.em,
                                   std::min(0.35F * view.size.y, view.size.y - 5.8F * context.em));
        ImGui::SetCursorPos({0.5F * (view.size.x - width), top});
        ImGui::BeginGroup();
        if (chosen) {
            dimText(now->complaint().empty() ? "Opening and comparing ..." : now->complaint(),
                    width);
        } else {
            dimText("Choose in the panel Compare what to compare this run with, or", width);
            const std::string usual = usualOther(context.session().input().spec()).rules + " rules";
            if (textButton(context, fitted("Compare with the " + usual, width - 0.8F * context.em),
                           "compare usual"))
                context.run("run.compare");
        }
        ImGui::EndGroup();
    }
    ImGui::End();
}

/// The sentence of a mesh or a trace about the decision at the cursor, at the lower edge of its
/// view.
void drawStillSentence(const PanelContext& context) {
    const Compared* found = context.state<ComparePage>().result();
    const Comparison* now = context.state<ComparePage>().now;
    const bool trace = found != nullptr && found->trace && now != nullptr;
    const std::string text =
        trace ? found->trace->replay.sentence(now->tracePosition(*context.otherRun))
              : std::string("A finished mesh: no decisions of its own.");
    const Rect& view = context.rects.view;
    const float width = std::min(30.0F * context.em, view.size.x - 3.0F * context.em);
    drawPlate(context, {context.fonts.text, wrapped(text, width), "", context.palette.border,
                        context.palette.textDim});
}

/// A mesh from a file, or a trace: it can be viewed, but has no decisions.
void drawStill(const PanelContext& context) {
    if (beginView(context, "##otherStill")) {
        offerView(context);
        moveCameraByMouse(context);
        if (isClick(context, ImGuiMouseButton_Right)) context.state<SubjectMenu>().openBeside({});
        drawViewPicture(context);
        if (context.ui().picture.labels) drawLabels(context, {});
        drawStillSentence(context);
    }
    ImGui::End();
}

/// The panel context of the other run.
void drawOther(const PanelContext& context) {
    const OtherView& other = *context.other;
    PanelRects rects = context.rects;
    rects.view = rects.otherView;
    const PanelContext there{other.commands != nullptr ? *other.commands : context.commands,
                             context.palette,
                             context.fonts,
                             rects,
                             other.list,
                             other.counts,
                             context.em,
                             other.texture,
                             nullptr,
                             true,
                             &context.session()};
    if (other.commands == nullptr) return drawStill(there);
    drawView(there, "##otherView");
}

}  // namespace

void drawComparedViews(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    context.where()["region other view"] = rects.otherView;
    const auto titles = comparedTitles(context.session(), context.state<ComparePage>().now);
    drawTitle(context, rects.title, titles[0]);
    drawTitle(context, rects.otherTitle, titles[1]);
    context.other == nullptr ? drawEmptyView(context) : drawOther(context);
}

}  // namespace se::view
