/// Decisions as rows that lead to them: of a ledger, of a query, of the closest calls.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "panel_state/query_panel_state.h"
#include "panels/panel.h"
#include "spiraling_edge/explain/ledger.h"

namespace se::view {

/// Something else to say of a line than its numbers.
struct RowNote {
    std::string below;    ///< In its second row.
    std::string tooltip;  ///< Behind the rest.
};

struct DecisionRows {
    std::span<const LedgerLine> lines;
    LineList& list;
    std::optional<std::size_t> cause = {};  ///< The line that settled it.
    bool inOrder = true;  ///< In the order of the run: the cursor has a place among them.
    std::function<RowNote(std::size_t)> note = {};  ///< About a line; none by default.
};

/// Below each other in the window that is being drawn, which scrolls to what the cursor moves to.
/// The line that was chosen, if any.
std::optional<std::size_t> drawDecisionRows(const PanelContext& context, const DecisionRows& rows);
/// What is below is scrolled by itself, so that what one types into stays in sight; in a low window
/// the panel is scrolled as a whole.
class ScrolledBody {
  public:
    ScrolledBody(const PanelContext& context, const char* id);
    ~ScrolledBody();
    ScrolledBody(const ScrolledBody&) = delete;
    ScrolledBody& operator=(const ScrolledBody&) = delete;

  private:
    bool apart_;
};
/// Goes to a decision and frames something once there.
void goToDecision(const PanelContext& context, const Address& address, FrameWish frame);
/// How far a question is, with a button. True if it is to stop.
bool drawAsking(const PanelContext& context, const char* what, double share);

}  // namespace se::view
