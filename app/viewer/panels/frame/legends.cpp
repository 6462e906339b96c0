// The legends over the view: of marks, lines and areas, and of the colors of the mesh and of the
// points.
#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "document/alert_actions.h"
#include "document/new_points.h"
#include "layers/layer.h"
#include "paint/shapes.h"
#include "panel_state/settings.h"
#include "panels/widgets/screen_painter.h"
#include "rows/paper_text.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

constexpr int kParts = 48;
/// Maximum number of components that are named one by one.
constexpr std::size_t kNamedColors = 8;

/// Corners for a plate, the best first; the axes have the other corner.
constexpr std::array kCorners = {Corner::BottomRight, Corner::TopLeft, Corner::TopRight};

/// The background of a plate.
constexpr float kPlateOpacity = 0.94F;

/// Look of a row of the legend: the shape of a point, or one of these.
enum class Stroke : std::uint8_t { None, Ring, Waiting, Line, Round, Area, Hatched };

struct Entry {
    Shape shape;
    Stroke stroke;
    Color Palette::*color;
    const char* text;
    /// Whether it is in the picture, beyond a mark of its shape and color.
    bool (*drawn)(const PanelContext& context) = nullptr;
};

/// Whether a layer has added lines, areas or spheres to the picture.
template <LayerId Id>
bool draws(const PanelContext& context) {
    const DrawList& drawn = context.drawList;
    for (std::size_t i = 0; i < drawn.layers.size(); ++i) {
        const LayerStart& from = drawn.layers[i];
        if (from.title != rowOf(Id).title) continue;
        const LayerStart to = drawn.endOf(i);
        return to.lines > from.lines || to.sheets > from.sheets || to.spheres > from.spheres;
    }
    return false;
}

/// Whether the cloud shows points of a status.
template <std::size_t StatusCounts::*Count>
bool hasPoints(const PanelContext& context) {
    return context.drawList.cloudVisible && context.counts.*Count > 0;
}

constexpr std::array kEntries = {
    Entry{Shape::RingedDisc, Stroke::None, &Palette::pivot, "pivot"},
    Entry{Shape::Forward, Stroke::None, &Palette::first, "start"},
    Entry{Shape::Back, Stroke::None, &Palette::last, "end"},
    Entry{Shape::RingedDisc, Stroke::None, &Palette::test, "under test"},
    Entry{Shape::Disc, Stroke::None, &Palette::used, "USED", hasPoints<&StatusCounts::used>},
    Entry{Shape::Cross, Stroke::None, &Palette::rejected, "rejected"},
    Entry{Shape::Circle, Stroke::None, &Palette::unused, "UNUSED",
          hasPoints<&StatusCounts::unused>},
    Entry{Shape::Dot, Stroke::None, &Palette::done, "DONE", hasPoints<&StatusCounts::done>},
    Entry{Shape::Hidden, Stroke::Ring, &Palette::used, "edge ring", draws<LayerId::EdgeRing>},
    Entry{Shape::Hidden, Stroke::Waiting, &Palette::used, "ring that waits",
          draws<LayerId::StackedRings>},
    Entry{Shape::Hidden, Stroke::Line, &Palette::used, "candidate", draws<LayerId::NeighborRing>},
    Entry{Shape::Hidden, Stroke::Area, &Palette::pivot, "free sector", draws<LayerId::Sector>},
    Entry{Shape::Hidden, Stroke::Round, &Palette::test, "circumsphere", draws<LayerId::Spheres>},
    Entry{Shape::Hidden, Stroke::Hatched, &Palette::test, "new triangle",
          [](const PanelContext& context) { return !context.drawList.faces.empty(); }},
};
constexpr Entry kAsideEntry{Shape::Plus, Stroke::None, &Palette::unused, "not in the run"};

/// Whether the picture has what an entry stands for: points or lines of it, or a mark.
bool isInPicture(const PanelContext& context, const Entry& entry) {
    if (entry.drawn != nullptr && entry.drawn(context)) return true;
    const Color& color = context.palette.*entry.color;
    const auto& sprites = context.drawList.sprites;
    return std::any_of(sprites.begin(), sprites.end(), [&](const Sprite& each) {
        return each.style.shape == entry.shape && each.style.color.withAlpha(1.0F) == color;
    });
}

/// The marks, lines and areas of decisions, except on the finished mesh, and those of points that
/// are set aside: only those in the picture.
std::vector<Entry> entriesOf(const PanelContext& context) {
    std::vector<Entry> entries;
    if (!showsFinishedMesh(context.commands))
        std::copy_if(kEntries.begin(), kEntries.end(), std::back_inserter(entries),
                     [&](const Entry& each) { return isInPicture(context, each); });
    const Session& session = context.session();
    const LayerSwitches on = shownLayers(context.settings().layers, session.stage());
    const bool aside = session.ready() && !session.model().aside.empty() &&
                       on.test(static_cast<std::size_t>(LayerId::Aside));
    if (aside) entries.push_back(kAsideEntry);
    return entries;
}

/// The sign of an entry, about `at`; `em`: its scale.
void drawSign(ScreenPainter& painter, const Entry& entry, glm::vec2 at, float em) {
    const Ink ink = painter.ink(entry.color);
    const glm::vec2 half(0.6F * em, 0.4F * em);
    const glm::vec2 left(half.x, 0.0F);
    switch (entry.stroke) {
        case Stroke::None:
            return drawShape(painter, at, entry.shape == Shape::Dot ? 0.34F * em : 0.72F * em,
                             entry.shape, ink);
        case Stroke::Ring:
            return drawActiveRing(painter, at - left, 0.75F * em, ink);
        case Stroke::Waiting:
            return drawWaitingRing(painter, at - left, 0.75F * em, ink);
        case Stroke::Line:
            return painter.line(at - left, at + left, ink.line(std::max(1.0F, 0.08F * em)));
        case Stroke::Round:
            painter.circle(at, 0.42F * em, ink.withAlpha(0.2F));
            return painter.circle(at, 0.42F * em, ink.line(std::max(1.0F, 0.12F * em)));
        case Stroke::Area:
            painter.box(at - half, at + half, ink.withAlpha(0.3F));
            return painter.box(at - half, at + half, ink.withAlpha(0.8F).line(1.0F));
        case Stroke::Hatched:
            return painter.polygon(
                {at - glm::vec2(0.0F, half.y), at + half, at + glm::vec2(-half.x, half.y)}, ink);
    }
}

/// The axes have the fourth corner.
constexpr std::array kLegendCorners = {Corner::TopRight, Corner::TopLeft, Corner::BottomRight};

/// A title on a plate in a corner of the view that covers no decision, if there is one; the colors
/// follow below it.
struct Plate {
    /// `below`: height of what follows, in em and one line of text.
    Plate(const PanelContext& context, std::span<const Rect> taken, const std::string& title,
          float wanted, float below)
        : p(context), width(std::max(wanted, textWidth(title))) {
        const float em = context.em;
        const Rect& view = context.rects.view;
        const float line = ImGui::GetTextLineHeight();
        rect.size = {width + 1.2F * em, 2.0F * line + below * em};
        rect.min = view.max() - rect.size - glm::vec2(0.7F * em, 0.7F * em);
        const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
        if (const auto free = freeCorner({view, 0.7F * em, taken, marks}, rect.size, kCorners))
            rect.min = free->min;
        fits = rect.size.x < 0.6F * view.size.x && rect.size.y < 0.3F * view.size.y;
        left = rect.min.x + 0.6F * em;
        type = {ImGui::GetFontSize(), Typeface::Small};
        const float y = rect.min.y + 0.4F * em;
        top = y + line + 0.2F * em;
        if (!fits) return;
        p.box(rect, p.ink(&Palette::panel, kPlateOpacity), 0.3F * em);
        p.text({left, y}, title, p.ink(&Palette::text), type);
    }

    void note(glm::vec2 at, const std::string& text, Align align = Align::Left) {
        p.text(at, text, p.ink(&Palette::textDim), {type.size, type.face, align});
    }

    std::optional<Rect> place() const { return fits ? std::optional(rect) : std::nullopt; }

    ScreenPainter p;
    Type type;
    float width;  ///< Of the content.
    Rect rect;
    float left = 0.0F;
    float top = 0.0F;  ///< Of what follows below the title.
    bool fits = false;
};

std::optional<Rect> drawCreation(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::string last = grouped(context.drawList.creationEnd);
    Plate plate(context, taken, "triangle, in creation order", 12.0F * em, 1.7F);
    if (!plate.fits) return std::nullopt;
    const float left = plate.left;
    const float width = plate.width;
    const float top = plate.top;
    for (int i = 0; i < kParts; ++i) {
        const float from = static_cast<float>(i) / kParts;
        const float to = static_cast<float>(i + 1) / kParts;
        plate.p.box({left + from * width, top}, {left + to * width, top + 0.6F * em},
                    Ink(viridis(0.5F * (from + to))));
    }
    // Position of the cursor on the scale.
    const float share = std::min(1.0F, static_cast<float>(context.drawList.finishedTriangles) /
                                           static_cast<float>(context.drawList.creationEnd));
    const float x = left + share * width;
    plate.p.polygon(
        {{x - 0.3F * em, top + 1.0F * em}, {x, top + 0.55F * em}, {x + 0.3F * em, top + 1.0F * em}},
        plate.p.ink(&Palette::text));
    plate.note({left, top + 0.9F * em}, "1");
    plate.note({left + width, top + 0.9F * em}, last, Align::Right);
    return plate.place();
}

std::optional<Rect> drawComponents(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::size_t count = context.drawList.components;
    const std::string title = withS(count, "component");
    const std::size_t named = std::min(count, kNamedColors);
    const float cells = static_cast<float>(named + (count > named ? 1 : 0));
    Plate plate(context, taken, title, cells * 2.0F * em, 1.2F);
    if (!plate.fits) return std::nullopt;
    const float y = plate.top + 0.1F * em;
    for (std::size_t i = 0; i < named; ++i) {
        const float x = plate.left + 2.0F * em * static_cast<float>(i);
        plate.p.box({x, y + 0.2F * em}, {x + 0.7F * em, y + 0.9F * em}, Ink(componentColor(i)),
                    0.1F * em);
        plate.note({x + 0.85F * em, y}, std::to_string(i + 1));
    }
    if (count > named)
        plate.note({plate.left + 2.0F * em * static_cast<float>(named), y}, "\xE2\x80\xA6");
    return plate.place();
}

/// The steps of least margins, from small to large.
std::optional<Rect> drawMargins(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const float cell = ImGui::CalcTextSize("< 1e-6").x + 0.4F * em;
    Plate plate(context, taken, "points: least margin of any test",
                cell * static_cast<float>(kMarginSteps), 1.7F);
    if (!plate.fits) return std::nullopt;
    const float top = plate.top;
    const float step = plate.width / static_cast<float>(kMarginSteps);
    for (std::size_t i = 0; i < kMarginSteps; ++i) {
        const float x = plate.left + step * static_cast<float>(i);
        plate.p.box({x, top}, {x + step, top + 0.6F * em},
                    Ink(marginColor(i, context.settings().theme)));
        plate.note({x, top + 0.75F * em}, marginStepText(i));
    }
    return plate.place();
}

}  // namespace

std::optional<Rect> drawColorBar(const PanelContext& context, std::span<const Rect> taken) {
    if (!context.session().ready()) return std::nullopt;
    const DrawList& drawn = context.drawList;
    std::optional<Rect> place;
    ImGui::PushFont(context.fonts.small);
    if (drawn.cloudVisible && drawn.marginTint) {
        place = drawMargins(context, taken);
    } else if (drawn.meshVisible && drawn.meshStyle == MeshStyle::CreationOrder) {
        place = drawCreation(context, taken);
    } else if (drawn.meshVisible && drawn.meshStyle == MeshStyle::Component) {
        place = drawComponents(context, taken);
    }
    ImGui::PopFont();
    return place;
}

namespace {

/// A plate with the entries, in a corner of the view where it covers nothing of `taken` and no
/// mark; nothing if there is none.
std::optional<Rect> drawEntries(const PanelContext& context, std::span<const Entry> entries,
                                std::span<const Rect> taken, std::span<const LabelMark> marks) {
    const Rect& view = context.rects.view;
    const float em = 0.84F * context.em;
    const float row = 1.32F * em;
    if (entries.empty()) return std::nullopt;
    const glm::vec2 size(9.6F * em, row * static_cast<float>(entries.size()) + 0.7F * em);
    // Omitted where it would cover too much of the picture; on a phone it is there on request.
    const bool phone = context.rects.phone;
    const float least = phone ? size.y : size.y + 8.0F * em;
    if (view.size.y < least || (!phone && view.size.x < 3.8F * size.x)) return std::nullopt;
    const std::optional<Rect> place =
        freeCorner({view, 0.7F * em, taken, marks}, size, kLegendCorners);
    if (!place) return std::nullopt;
    const glm::vec2 at = place->min;
    context.where()["legend"] = *place;
    ScreenPainter painter(context);
    painter.box(*place, painter.ink(&Palette::panel, kPlateOpacity), 0.3F * em);
    float y = at.y + 0.35F * em;
    std::string defined;
    const Type type{em, Typeface::Small};
    for (const Entry& entry : entries) {
        drawSign(painter, entry, {at.x + 0.95F * em, y + 0.5F * row}, em);
        painter.text({at.x + 1.9F * em, y + 0.5F * (row - em)}, entry.text,
                     painter.ink(&Palette::text), type);
        const Rect whole{{at.x, y}, {size.x, row}};
        context.where()[std::string("legend ") + entry.text] = whole;
        if (ImGui::IsWindowHovered() && whole.contains(pointerInWindow()) &&
            !ImGui::IsAnyMouseDown()) {
            // The entries are no items: the view takes the mouse.
            if (const std::string text = definitionOf(entry.text); !text.empty()) defined = text;
        }
        y += row;
    }
    if (!defined.empty()) showTooltip(defined);
    return place;
}

}  // namespace

std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken) {
    return drawEntries(context, entriesOf(context), taken,
                       ScreenProjection(context).neighborhood());
}

void drawGrowthLegend(const PanelContext& context) {
    const GrowthPicture* picture = context.commands.sampling.growth().picture();
    if (picture == nullptr || picture->onWalls == 0) return;
    constexpr std::array kShapes = {
        Entry{Shape::Disc, Stroke::None, &Palette::used, "inside"},
        Entry{Shape::Square, Stroke::None, &Palette::first, "on a wall"},
        Entry{Shape::Diamond, Stroke::None, &Palette::last, "in a corner"}};
    drawEntries(context, std::span(kShapes).first(picture->corners > 0 ? 3 : 2), {}, {});
}

}  // namespace se::view
