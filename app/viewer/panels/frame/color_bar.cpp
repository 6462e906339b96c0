#include <algorithm>
#include <array>
#include <vector>

#include "layout/corner.h"
#include "panel_state/settings.h"
#include "panels/widgets/widgets.h"
#include "scene/draw_list.h"
#include "scene/mesh_style.h"
#include "screen_projection.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

constexpr int kParts = 48;
/// Maximum number of components that are named one by one.
constexpr std::size_t kNamedColors = 8;

/// Corners for a plate, the best first; the axes have the other corner.
constexpr std::array kCorners = {Corner::BottomRight, Corner::TopLeft, Corner::TopRight};

/// Text on a plate in a corner of the view that covers no decision, if there is one.
struct Plate {
    Plate(const PanelContext& context, std::span<const Rect> taken, glm::vec2 wanted)
        : em(context.em), size(wanted) {
        const Rect& view = context.rects.view;
        at = view.max() - size - glm::vec2(0.7F * em, 0.7F * em);
        const std::vector<LabelMark> marks = ScreenProjection(context).neighborhood();
        if (const auto free = freeCorner({view, 0.7F * em, taken, marks}, size, kCorners))
            at = free->min;
        fits = size.x < 0.6F * view.size.x && size.y < 0.3F * view.size.y;
        list = ImGui::GetWindowDrawList();
        if (!fits) return;
        list->AddRectFilled(toVec2(at), toVec2(at + size),
                            toU32(context.palette.panel.withAlpha(0.94F)), 0.3F * em);
    }
    float em;
    glm::vec2 size;
    glm::vec2 at{0.0F};
    bool fits = false;
    ImDrawList* list = nullptr;
};

std::optional<Rect> drawBirth(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::string last = grouped(context.drawList.creationEnd);
    const std::string title = "triangle, in creation order";
    const float width = std::max(12.0F * em, ImGui::CalcTextSize(title.c_str()).x);
    const float line = ImGui::GetTextLineHeight();
    const Plate plate(context, taken, {width + 1.2F * em, 2.0F * line + 1.7F * em});
    if (!plate.fits) return std::nullopt;
    const glm::vec2 at = plate.at + glm::vec2(0.6F * em, 0.4F * em);
    plate.list->AddText(toVec2(at), toU32(context.palette.text), title.c_str());
    const float top = at.y + line + 0.2F * em;
    for (int i = 0; i < kParts; ++i) {
        const float from = static_cast<float>(i) / kParts;
        const float to = static_cast<float>(i + 1) / kParts;
        plate.list->AddRectFilledMultiColor(
            {at.x + from * width, top}, {at.x + to * width, top + 0.6F * em}, toU32(viridis(from)),
            toU32(viridis(to)), toU32(viridis(to)), toU32(viridis(from)));
    }
    // Position of the cursor on the scale.
    const float share = std::min(1.0F, static_cast<float>(context.drawList.finishedTriangles) /
                                           static_cast<float>(context.drawList.creationEnd));
    const float x = at.x + share * width;
    plate.list->AddTriangleFilled({x - 0.3F * em, top + 1.0F * em}, {x, top + 0.55F * em},
                                  {x + 0.3F * em, top + 1.0F * em}, toU32(context.palette.text));
    const float below = top + 0.9F * em;
    plate.list->AddText({at.x, below}, toU32(context.palette.textDim), "1");
    plate.list->AddText({at.x + width - ImGui::CalcTextSize(last.c_str()).x, below},
                        toU32(context.palette.textDim), last.c_str());
    return Rect{plate.at, plate.size};
}

std::optional<Rect> drawComponents(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::size_t count = context.drawList.components;
    const std::string title = count == 1 ? "1 component" : grouped(count) + " components";
    const std::size_t named = std::min(count, kNamedColors);
    const float line = ImGui::GetTextLineHeight();
    const float width = std::max(ImGui::CalcTextSize(title.c_str()).x,
                                 static_cast<float>(named + (count > named ? 1 : 0)) * 2.0F * em);
    const Plate plate(context, taken, {width + 1.2F * em, 2.0F * line + 1.2F * em});
    if (!plate.fits) return std::nullopt;
    const glm::vec2 at = plate.at + glm::vec2(0.6F * em, 0.4F * em);
    plate.list->AddText(toVec2(at), toU32(context.palette.text), title.c_str());
    for (std::size_t i = 0; i < named; ++i) {
        const float x = at.x + 2.0F * em * static_cast<float>(i);
        const float y = at.y + line + 0.3F * em;
        plate.list->AddRectFilled({x, y + 0.2F * em}, {x + 0.7F * em, y + 0.9F * em},
                                  toU32(componentColor(i)), 0.1F * em);
        plate.list->AddText({x + 0.85F * em, y}, toU32(context.palette.textDim),
                            std::to_string(i + 1).c_str());
    }
    if (count > named) {
        plate.list->AddText({at.x + 2.0F * em * static_cast<float>(named), at.y + line + 0.3F * em},
                            toU32(context.palette.textDim), "\xE2\x80\xA6");
    }
    return Rect{plate.at, plate.size};
}

/// The steps of least margins, from small to large.
std::optional<Rect> drawMargins(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    const std::string title = "points: least margin of any test";
    const float cell = ImGui::CalcTextSize("< 1e-6").x + 0.4F * em;
    const float width =
        std::max(ImGui::CalcTextSize(title.c_str()).x, cell * static_cast<float>(kMarginSteps));
    const float line = ImGui::GetTextLineHeight();
    const Plate plate(context, taken, {width + 1.2F * em, 2.0F * line + 1.7F * em});
    if (!plate.fits) return std::nullopt;
    const glm::vec2 at = plate.at + glm::vec2(0.6F * em, 0.4F * em);
    plate.list->AddText(toVec2(at), toU32(context.palette.text), title.c_str());
    const float top = at.y + line + 0.2F * em;
    const float step = width / static_cast<float>(kMarginSteps);
    for (std::size_t i = 0; i < kMarginSteps; ++i) {
        const float x = at.x + step * static_cast<float>(i);
        plate.list->AddRectFilled({x, top}, {x + step, top + 0.6F * em},
                                  toU32(marginColor(i, context.settings().theme)));
        plate.list->AddText({x, top + 0.75F * em}, toU32(context.palette.textDim),
                            marginStepText(i).c_str());
    }
    return Rect{plate.at, plate.size};
}

}  // namespace

std::optional<Rect> drawColorBar(const PanelContext& context, std::span<const Rect> taken) {
    if (!context.session().ready()) return std::nullopt;
    std::optional<Rect> place;
    ImGui::PushFont(context.fonts.small);
    if (context.drawList.cloudVisible && context.drawList.marginTint) {
        place = drawMargins(context, taken);
        ImGui::PopFont();
        return place;
    }
    if (!context.drawList.meshVisible) {
        ImGui::PopFont();
        return std::nullopt;
    }
    if (context.drawList.meshStyle == MeshStyle::CreationOrder) place = drawBirth(context, taken);
    if (context.drawList.meshStyle == MeshStyle::Component) place = drawComponents(context, taken);
    ImGui::PopFont();
    return place;
}

}  // namespace se::view
