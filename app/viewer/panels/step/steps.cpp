// The Steps panel: pivots, stages and events as a tree.
#include <algorithm>
#include <cmath>

#include "input/tab_order.h"
#include "panel_state/side_panels.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/playback.h"
#include "session/session.h"
#include "step_rows.h"

namespace se::view {

namespace {

void goTo(const PanelContext& context, const StepRow& row) {
    Session& session = context.session();
    StepTree& tree = context.state<Navigation>().steps;
    context.playback().pause();
    if (row.kind == StepRowKind::Component) {
        tree.toggle(row);
    } else if (row.kind == StepRowKind::Pivot) {
        session.moves().goToPivot(row.pivot);
    } else {
        session.moves().goToEvent(row.event);
    }
}

/// Opens or folds a row; another pivot can only be opened by a move there.
void toggle(const PanelContext& context, const StepRow& row) {
    StepTree& tree = context.state<Navigation>().steps;
    if (row.kind == StepRowKind::Pivot && row.pivot != context.session().record().pivot) {
        goTo(context, row);
        tree.openPivot();
    } else {
        tree.toggle(row);
    }
}

/// The user's action on a row.
enum class RowAction : std::uint8_t { None, Go, Toggle };

/// A click, or Enter, Left and Right for keyboard navigation.
RowAction actionOn(const PanelContext& context, const StepRow& row, bool pressed, float left) {
    const StepTree& tree = context.state<Navigation>().steps;
    const bool byMouse = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (pressed) {
        const bool onArrow = byMouse &&
                             ImGui::GetMousePos().x < left + stepArrowEnd(context, row) &&
                             tree.canOpen(row);
        return onArrow ? RowAction::Toggle : RowAction::Go;
    }
    if (!ImGui::IsItemFocused() || !tree.canOpen(row)) return RowAction::None;
    const auto hit = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const bool wanted = tree.isOpen(row) ? hit(ImGuiKey_LeftArrow) : hit(ImGuiKey_RightArrow);
    return ImGui::GetIO().NavVisible && wanted ? RowAction::Toggle : RowAction::None;
}

RowAction drawRow(const PanelContext& context, std::size_t index, bool here, bool takes,
                  const StepColumns& columns) {
    const StepTree& tree = context.state<Navigation>().steps;
    const StepRow row = tree.row(index);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    const bool pressed = ImGui::Selectable("##row", here);
    if (takes) {
        takeKeyboard();
        if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    }
    if (ImGui::IsItemHovered()) {
        if (row.kind >= StepRowKind::Stage) {
            const Index subject = subjectOf(context.session().record().events[row.event]);
            context.state<Navigation>().pointedAt = subject;
            if (subject != kNone && ImGui::IsMouseReleased(ImGuiMouseButton_Right))
                context.state<SubjectMenu>().open(Selection::ofPoint(subject));
        }
        tooltip(stepRowTooltip(context, row));
    }
    drawStepRow(context, row, at, columns);
    const RowAction action = actionOn(context, row, pressed, at.x);
    ImGui::PopID();
    return action;
}

void drawStepFilter(const PanelContext& context) {
    Navigation& nav = context.state<Navigation>();
    ImGui::SetNextItemWidth(-1.0F);
    const bool wide = ImGui::GetContentRegionAvail().x > 16.0F * context.em;
    ImGui::InputTextWithHint("##filter", wide ? "filter: stage, verdict, point, x" : "filter",
                             nav.stepFilter.data(), nav.stepFilter.size());
    context.where()["steps filter"] = lastItem();
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) {
        tooltip(
            "Shows only pivots and tests with all of these words: the beginning of a stage "
            "(sphere), a word of a verdict (removed), the number of a point or pivot, or x for "
            "refused tests.");
    }
    nav.steps.setFilter(nav.stepFilter.data());
}

void drawColumnTitles(const PanelContext& context, const StepColumns& columns) {
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float size = 0.78F * em;
    const ImU32 color = toU32(context.palette.textDim);
    const auto title = [&](float right, const char* text) {
        if (right <= 0.0F) return;
        const float width = context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, text).x;
        list->AddText(context.fonts.text, size, {right - width, at.y}, color, text);
    };
    title(columns.triangles, "triangles");
    title(columns.tests, "tests");
    title(columns.refused, "refused");
    ImGui::Dummy({0.0F, 0.75F * em});
}

/// Scrolls to the cursor's row if the cursor has moved away from it.
void followCursor(const PanelContext& context, float pitch) {
    const Session& session = context.session();
    Navigation& nav = context.state<Navigation>();
    if (!nav.stepsWatch.moved(session.generation(), session.record().pivot, session.cursor()))
        return;
    // The start has no row: it is above the first.
    if (session.event() == nullptr) return ImGui::SetScrollY(0.0F);
    const auto row = nav.steps.rowOfCursor();
    if (!row) return;
    const float top = static_cast<float>(*row) * pitch;
    const float height = ImGui::GetWindowHeight();
    const float scroll = ImGui::GetScrollY();
    if (top < scroll + 2.0F * pitch || top > scroll + height - 3.0F * pitch)
        ImGui::SetScrollY(std::floor(std::max(0.0F, top - 0.4F * height) / pitch) * pitch);
}

void drawStepRows(const PanelContext& context, const StepColumns& columns) {
    const StepTree& tree = context.state<Navigation>().steps;
    const float pitch = ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
    followCursor(context, pitch);
    const auto cursorRow = tree.rowOfCursor();
    RowAction action = RowAction::None;
    StepRow chosen;
    const bool keyboard = context.state<KeyWalk>().offer(KeyStop::Steps);
    const std::size_t first = cursorRow.value_or(0);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(tree.rowCount()), pitch);
    if (keyboard)
        clipper.ForceDisplayRangeByIndices(static_cast<int>(first), static_cast<int>(first) + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto row = static_cast<std::size_t>(i);
            const RowAction wanted =
                drawRow(context, row, cursorRow == row, keyboard && row == first, columns);
            if (wanted == RowAction::None) continue;
            action = wanted;
            chosen = tree.row(row);
        }
    }
    // After all rows: they may change here.
    if (action == RowAction::Go) goTo(context, chosen);
    if (action == RowAction::Toggle) toggle(context, chosen);
}

}  // namespace

void drawSteps(const PanelContext& context) {
    const Session& session = context.session();
    const RunOverview& run = session.overview();
    keepSteps(context);
    partNote(withS(run.ringLength.size(), "pivot") + (run.complete ? "" : "\xE2\x80\xA6"));
    drawStepFilter(context);
    const StepTree& tree = context.state<Navigation>().steps;
    const StepColumns columns =
        stepColumns(context, ImGui::GetCursorScreenPos().x,
                    ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize);
    drawColumnTitles(context, columns);
    if (tree.rowCount() == 0) {
        return dimText(tree.filtered() ? "No pivot has all of these words. Esc in the line above "
                                         "reverts the text."
                                       : "Nothing has happened yet. F10 steps by a pivot, F11 by "
                                         "a single decision.");
    }
    if (ImGui::BeginChild("##rows", {0, 0}, false, ImGuiWindowFlags_AlwaysVerticalScrollbar)) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.2F * context.em});
        drawStepRows(context, columns);
        ImGui::PopStyleVar();
    }
    ImGui::EndChild();
}

}  // namespace se::view
