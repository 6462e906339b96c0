#include <cstdio>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

/// Whether to scroll to the cursor: only when it moved, else nobody could scroll away. Asked once a
/// frame; the height of the list is known one frame late, hence the second time.
bool cursorMoved(const Session& session) {
    static std::uint32_t seenRevision = 0;
    static std::size_t seenCursor = 0;
    static int again = 0;
    if (seenRevision != session.revision() || seenCursor != session.cursor()) again = 2;
    seenRevision = session.revision();
    seenCursor = session.cursor();
    return again > 0 && again-- > 0;
}

/// Brings the row just drawn into view, if it is not.
void scrollToRow() {
    const float top = ImGui::GetCursorPosY() - ImGui::GetScrollY();
    const float margin = 2.0F * ImGui::GetTextLineHeight();
    if (top < 2.0F * margin || top > ImGui::GetWindowHeight() - margin) ImGui::SetScrollHereY(0.5F);
}

std::string subjectText(const Event& event) {
    const Index subject = subjectOf(event);
    return subject == kNone ? std::string{} : std::to_string(subject);
}

/// Digits of the largest point number.
std::size_t widestSubject(const Session& session) {
    return std::to_string(session.model().points.size()).size();
}

std::string outcomeText(const Event& event) {
    if (const auto verdict = verdictOf(event)) return std::string(verdictText(*verdict));
    if (const auto* ring = std::get_if<RingEvidence>(&event.evidence)) {
        return ring->inserted ? "in" : "out";
    }
    return {};
}

Shape markOf(const Event& event) {
    if (rejects(event)) return Shape::Cross;
    if (const auto* ring = std::get_if<RingEvidence>(&event.evidence)) {
        return ring->inserted ? Shape::Disc : Shape::Dot;
    }
    return verdictOf(event) ? Shape::Disc : Shape::Dot;
}

/// At the right end of the present column, whose left end is at `left`.
void rightAligned(const std::string& text, float left, float room, const Color& color) {
    if (text.empty()) return;
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::SetCursorPosX(left + room - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextColored(toVec4(color), "%s", text.c_str());
}

void drawRow(const PanelContext& context, std::size_t index) {
    Session& session = context.session();
    const Event& event = session.record().events[index];
    const bool later = index > session.cursor();
    const Color color = verdictColor(context, event);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    float left = ImGui::GetCursorPosX();
    float room = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(static_cast<int>(index));
    if (ImGui::Selectable("##row", index == session.cursor(),
                          ImGuiSelectableFlags_SpanAllColumns)) {
        context.playback().pause();
        session.goToEvent(index);
    }
    if (ImGui::IsItemHovered()) {
        tooltip(toString(event.address) + "\n" + describe(event));
    }
    ImGui::SameLine(0.0F, 0.0F);
    const float alpha = later ? 0.55F : 1.0F;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, alpha);
    if (event.address.n <= 1) {
        ImGui::TextUnformatted(std::string(stageName(event.address.stage)).c_str());
    }
    rightAligned(std::to_string(event.address.n), left, room, context.palette.textDim);
    ImGui::TableNextColumn();
    left = ImGui::GetCursorPosX();
    room = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({0.0F, 0.0F});
    rightAligned(subjectText(event), left, room, context.palette.text);
    ImGui::TableNextColumn();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    const Shape mark = markOf(event);
    const float size = mark == Shape::Dot ? 0.28F * context.em : 0.52F * context.em;
    drawShape(ImGui::GetWindowDrawList(), {at.x + 0.4F * context.em, at.y + 0.5F * height}, size,
              mark, toU32(color.withAlpha(alpha)));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.95F * context.em);
    const std::string outcome = fitted(outcomeText(event), ImGui::GetContentRegionAvail().x);
    ImGui::TextColored(toVec4(color), "%s", outcome.c_str());
    ImGui::PopStyleVar();
    ImGui::PopID();
}

}  // namespace

void drawSteps(const PanelContext& context) {
    const Session& session = context.session();
    const bool any = session.ready() && !session.record().events.empty();
    const std::string note = !any ? std::string{} : "pivot " + grouped(session.record().pivot);
    heading(context, "Steps", note);
    if (!any) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextDisabled("%s",
                            "Nothing has been done yet. F10 goes on by a pivot, F11 by a "
                            "single decision.");
        ImGui::PopTextWrapPos();
        return;
    }
    constexpr auto kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("##events", 3, kFlags)) return;
    ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthFixed, 5.4F * context.em);
    const float point =
        ImGui::CalcTextSize("0000000").x * static_cast<float>(widestSubject(session)) / 7.0F;
    ImGui::TableSetupColumn("point", ImGuiTableColumnFlags_WidthFixed, point);
    ImGui::TableSetupColumn("outcome", ImGuiTableColumnFlags_WidthStretch);
    const bool scroll = cursorMoved(session);
    const auto cursor = static_cast<int>(session.cursor());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(session.record().events.size()));
    clipper.ForceDisplayRangeByIndices(cursor, cursor + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(context, static_cast<std::size_t>(i));
            if (scroll && i == cursor) scrollToRow();
        }
    }
    ImGui::EndTable();
}

}  // namespace se::view
