/// Decisions as rows that lead to them: of a ledger, of a query, of the closest decisions.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "document/ui_state.h"
#include "jobs/questions.h"
#include "panel_state/side_panels.h"
#include "spiraling_edge/why/ledger.h"
#include "widgets.h"

namespace se::view {

/// Replacement for the numbers of a line.
struct RowNote {
    std::string below;    ///< In its second row.
    std::string tooltip;  ///< After the rest.
};

struct DecisionRows {
    std::span<const LedgerLine> lines;
    LineList& list;
    std::optional<std::size_t> cause = {};  ///< The decisive line.
    bool inOrder = true;  ///< In the order of the run: the cursor has a position among them.
    std::function<RowNote(std::size_t)> note = {};  ///< About a line; none by default.
    std::span<const LineFold> folds = {};           ///< Repeats, each a row until it is clicked.
};

/// Draws them below each other in the current window, which scrolls to the line of the cursor,
/// and to the decisive one of a new list. A click goes to the decision of a line and frames `frame`
/// there.
void drawDecisionRows(const PanelContext& context, const DecisionRows& rows, FrameRequest frame);
/// A part that scrolls by itself, so that the input above stays visible; in a low window
/// the panel is scrolled as a whole.
class ScrolledBody {
  public:
    ScrolledBody(const PanelContext& context, const char* id)
        : apart_(ImGui::GetContentRegionAvail().y >= kLeastBody * context.em) {
        if (apart_) ImGui::BeginChild(id, {0.0F, 0.0F}, false, ImGuiWindowFlags_NavFlattened);
    }
    ~ScrolledBody() {
        if (apart_) ImGui::EndChild();
    }
    ScrolledBody(const ScrolledBody&) = delete;
    ScrolledBody& operator=(const ScrolledBody&) = delete;

  private:
    /// Minimum height of a scrolling body, in em.
    static constexpr float kLeastBody = 4.0F;
    bool apart_;
};
/// Buttons for a change that prevents what is asked about: to run again with it, and to see that
/// run beside this one. True if it runs again.
bool drawPreventing(const PanelContext& context, const FieldValue& change);
/// Goes to a decision and frames a selection there.
void goToDecision(const PanelContext& context, const Address& address, FrameRequest frame);
/// Progress of a query, with a button that stops it. False if it is not busy.
template <class Answer>
bool drawAsking(const PanelContext& context, BackgroundQuery<Answer>& query) {
    if (!query.busy()) return false;
    ImGui::TextDisabled("Re-running ...");
    if (progressAndStop(context, query.share(), nullptr, "stop asking")) query.stop();
    return true;
}

}  // namespace se::view
