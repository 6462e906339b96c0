#include <cstdio>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

std::string typeText(std::uint8_t type) {
    if (!isBoundary(type)) return "interior";
    constexpr const char* kFaces[] = {"+x",           "+y", "+z", "\xE2\x88\x92x", "\xE2\x88\x92y",
                                      "\xE2\x88\x92z"};
    std::string text = isCorner(type) ? "corner" : "boundary";
    for (unsigned i = 0; i < 6; ++i) {
        if ((type & (1U << i)) != 0) text += std::string(" ") + kFaces[i];
    }
    return text;
}

std::string statusText(PointStatus status) {
    if (status == kUnused) return "UNUSED";
    if (status == kDone) return "DONE";
    return "USED, " + std::to_string(status) + (status == 1 ? " ring entry" : " ring entries");
}

void drawPoint(const PanelContext& context, const char* title, Index point) {
    const Session& session = context.session();
    const PointSet& points = session.model().points;
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    heading(context, title, "point " + std::to_string(point));
    ImGui::PushID(title);
    if (beginValues("##point", context)) {
        const Vec3& p = points.position[point];
        char place[96];
        std::snprintf(place, sizeof place, "%.4g, %.4g, %.4g", p.x, p.y, p.z);
        valueRow(context, "status", statusText(session.picture().status[point]));
        valueRow(context, "type", typeText(points.type[point]));
        valueRow(context, "position", place);
        std::string list;
        for (const Index q : points.neighbors[point]) {
            list += (list.empty() ? "" : ", ") + std::to_string(q);
        }
        valueRow(context, "neighbors", list.empty() ? "none" : list);
        endValues();
    }
    ImGui::PopID();
}

void drawStep(const PanelContext& context, const Event& event) {
    const std::string stage(stageName(event.address.stage));
    heading(context, stage.c_str(), "paper " + std::string(stageSection(event.address.stage)));
    ImGui::PushFont(context.fonts.mono);
    ImGui::TextDisabled("%s", toString(event.address).c_str());
    ImGui::PopFont();
    ImGui::Spacing();
    drawEvidence(context, event);
}

}  // namespace

void drawInspect(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return;
    if (const Event* event = session.event()) {
        drawStep(context, *event);
    } else {
        heading(context, "At the start");
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("%s", session.model().watch.empty()
                                      ? "All points are UNUSED. No triangle has been made."
                                      : session.model().watch.c_str());
        ImGui::PopTextWrapPos();
    }
    if (session.picture().pivot != kNone) drawPoint(context, "Pivot", session.picture().pivot);
    if (session.selected() != kNone) {
        drawPoint(context, "Selected", session.selected());
    } else {
        ImGui::Spacing();
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("Click a point to see its values here.");
        ImGui::PopTextWrapPos();
    }
}

}  // namespace se::view
