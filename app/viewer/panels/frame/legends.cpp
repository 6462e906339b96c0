// The legends over the view: of the marks, and of the colors of the mesh and of the points.
#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "commands/alert_actions.h"
#include "layers/layer.h"
#include "panel_state/settings.h"
#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"
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

struct Entry {
    Shape shape;
    Color Palette::*color;
    const char* text;
};

constexpr std::array kEntries = {
    Entry{Shape::RingedDisc, &Palette::pivot, "pivot p"},
    Entry{Shape::Forward, &Palette::first, "start S"},
    Entry{Shape::Back, &Palette::last, "end E"},
    Entry{Shape::RingedDisc, &Palette::test, "under test, new"},
    Entry{Shape::Disc, &Palette::used, "USED, kept"},
    Entry{Shape::Cross, &Palette::rejected, "rejected"},
    Entry{Shape::Circle, &Palette::unused, "UNUSED"},
    Entry{Shape::Dot, &Palette::done, "DONE"},
};
constexpr Entry kAsideEntry{Shape::Plus, &Palette::unused, "not in the run"};

/// Whether a mark of this shape and color is in the picture.
bool isDrawn(const DrawList& drawn, Shape shape, const Color& color) {
    return std::any_of(drawn.sprites.begin(), drawn.sprites.end(), [&](const Sprite& each) {
        return each.style.shape == shape && each.style.color.withAlpha(1.0F) == color;
    });
}

/// Whether the picture has what an entry stands for: a mark, points of that status, or a triangle.
bool isInPicture(const PanelContext& context, const Entry& entry) {
    const DrawList& drawn = context.drawList;
    const auto points = [&](std::size_t count) { return drawn.cloudVisible && count > 0; };
    if (entry.color == &Palette::used && points(context.counts.used)) return true;
    if (entry.color == &Palette::unused) return points(context.counts.unused);
    if (entry.color == &Palette::done) return points(context.counts.done);
    if (entry.color == &Palette::test && !drawn.faces.empty()) return true;
    return isDrawn(drawn, entry.shape, context.palette.*entry.color);
}

/// The marks of decisions, except on the finished mesh, and those of points that are set aside:
/// only those in the picture.
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

/// The axes have the fourth corner.
constexpr std::array kLegendCorners = {Corner::TopRight, Corner::TopLeft, Corner::BottomRight};

/// A title on a plate in a corner of the view that covers no decision, if there is one; the colors
/// follow below it.
struct Plate {
    /// `below`: height of what follows, in em and one line of text.
    Plate(const PanelContext& context, std::span<const Rect> taken, const std::string& title,
          float wanted, float below)
        : width(std::max(wanted, ImGui::CalcTextSize(title.c_str()).x)) {
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
        const float y = rect.min.y + 0.4F * em;
        top = y + line + 0.2F * em;
        if (!fits) return;
        fill(list, rect, context.palette.panel.withAlpha(kPlateOpacity), 0.3F * em);
        list->AddText({left, y}, toU32(context.palette.text), title.c_str());
    }

    std::optional<Rect> place() const { return fits ? std::optional(rect) : std::nullopt; }

    float width;  ///< Of the content.
    Rect rect;
    float left = 0.0F;
    float top = 0.0F;  ///< Of what follows below the title.
    bool fits = false;
    ImDrawList* list = ImGui::GetWindowDrawList();
};

std::optional<Rect> drawBirth(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::string last = grouped(context.drawList.creationEnd);
    const Plate plate(context, taken, "triangle, in creation order", 12.0F * em, 1.7F);
    if (!plate.fits) return std::nullopt;
    const float left = plate.left;
    const float width = plate.width;
    const float top = plate.top;
    for (int i = 0; i < kParts; ++i) {
        const float from = static_cast<float>(i) / kParts;
        const float to = static_cast<float>(i + 1) / kParts;
        plate.list->AddRectFilledMultiColor(
            {left + from * width, top}, {left + to * width, top + 0.6F * em}, toU32(viridis(from)),
            toU32(viridis(to)), toU32(viridis(to)), toU32(viridis(from)));
    }
    // Position of the cursor on the scale.
    const float share = std::min(1.0F, static_cast<float>(context.drawList.finishedTriangles) /
                                           static_cast<float>(context.drawList.creationEnd));
    const float x = left + share * width;
    plate.list->AddTriangleFilled({x - 0.3F * em, top + 1.0F * em}, {x, top + 0.55F * em},
                                  {x + 0.3F * em, top + 1.0F * em}, toU32(context.palette.text));
    const float below = top + 0.9F * em;
    plate.list->AddText({left, below}, toU32(context.palette.textDim), "1");
    plate.list->AddText({left + width - ImGui::CalcTextSize(last.c_str()).x, below},
                        toU32(context.palette.textDim), last.c_str());
    return plate.place();
}

std::optional<Rect> drawComponents(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::size_t count = context.drawList.components;
    const std::string title = count == 1 ? "1 component" : grouped(count) + " components";
    const std::size_t named = std::min(count, kNamedColors);
    const float cells = static_cast<float>(named + (count > named ? 1 : 0));
    const Plate plate(context, taken, title, cells * 2.0F * em, 1.2F);
    if (!plate.fits) return std::nullopt;
    const float y = plate.top + 0.1F * em;
    for (std::size_t i = 0; i < named; ++i) {
        const float x = plate.left + 2.0F * em * static_cast<float>(i);
        plate.list->AddRectFilled({x, y + 0.2F * em}, {x + 0.7F * em, y + 0.9F * em},
                                  toU32(componentColor(i)), 0.1F * em);
        plate.list->AddText({x + 0.85F * em, y}, toU32(context.palette.textDim),
                            std::to_string(i + 1).c_str());
    }
    if (count > named) {
        plate.list->AddText({plate.left + 2.0F * em * static_cast<float>(named), y},
                            toU32(context.palette.textDim), "\xE2\x80\xA6");
    }
    return plate.place();
}

/// The steps of least margins, from small to large.
std::optional<Rect> drawMargins(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const float cell = ImGui::CalcTextSize("< 1e-6").x + 0.4F * em;
    const Plate plate(context, taken, "points: least margin of any test",
                      cell * static_cast<float>(kMarginSteps), 1.7F);
    if (!plate.fits) return std::nullopt;
    const float top = plate.top;
    const float step = plate.width / static_cast<float>(kMarginSteps);
    for (std::size_t i = 0; i < kMarginSteps; ++i) {
        const float x = plate.left + step * static_cast<float>(i);
        plate.list->AddRectFilled({x, top}, {x + step, top + 0.6F * em},
                                  toU32(marginColor(i, context.settings().theme)));
        plate.list->AddText({x, top + 0.75F * em}, toU32(context.palette.textDim),
                            marginStepText(i).c_str());
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
        place = drawBirth(context, taken);
    } else if (drawn.meshVisible && drawn.meshStyle == MeshStyle::Component) {
        place = drawComponents(context, taken);
    }
    ImGui::PopFont();
    return place;
}

std::optional<Rect> drawLegend(const PanelContext& context, std::span<const Rect> taken) {
    const Rect& view = context.rects.view;
    const float em = 0.84F * context.em;
    const float row = 1.32F * em;
    const std::vector<Entry> entries = entriesOf(context);
    if (entries.empty()) return std::nullopt;
    const glm::vec2 size(9.6F * em, row * static_cast<float>(entries.size()) + 0.7F * em);
    // Omitted where it would cover too much of the picture; F1 shows it as well.
    if (view.size.y < size.y + 8.0F * em || view.size.x < 3.8F * size.x) return std::nullopt;
    const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
    const std::optional<Rect> place =
        freeCorner({view, 0.7F * em, taken, marks}, size, kLegendCorners);
    if (!place) return std::nullopt;
    const glm::vec2 at = place->min;
    context.where()["legend"] = *place;
    ImDrawList* list = ImGui::GetWindowDrawList();
    fill(list, *place, context.palette.panel.withAlpha(kPlateOpacity), 0.3F * em);
    float y = at.y + 0.35F * em;
    ImGui::PushFont(context.fonts.small);
    for (const Entry& entry : entries) {
        const float dot = entry.shape == Shape::Dot ? 0.34F * em : 0.72F * em;
        drawShape(list, {at.x + 0.95F * em, y + 0.5F * row}, dot, entry.shape,
                  toU32(context.palette.*entry.color));
        list->AddText({at.x + 1.9F * em, y + 0.5F * (row - ImGui::GetTextLineHeight())},
                      toU32(context.palette.text), entry.text);
        context.where()[std::string("legend ") + entry.text] = {{at.x, y}, {size.x, row}};
        y += row;
    }
    ImGui::PopFont();
    return place;
}

}  // namespace se::view
