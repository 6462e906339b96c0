/// Decisions as rows that lead to them: of a ledger, of a query, of the closest decisions.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "panel_state/side_panels.h"
#include "panel_state/ui_requests.h"
#include "panels/panel.h"
#include "spiraling_edge/explain/ledger.h"

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
};

/// Draws them below each other in the current window, which scrolls to the line of the cursor.
/// The line that was chosen, if any.
std::optional<std::size_t> drawDecisionRows(const PanelContext& context, const DecisionRows& rows);
/// A part that scrolls by itself, so that the input above stays visible; in a low window
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
/// Goes to a decision and frames a selection there.
void goToDecision(const PanelContext& context, const Address& address, FrameWish frame);
/// Progress of a query, with a button. True if it is to stop.
bool drawAsking(const PanelContext& context, const char* what, double share);

}  // namespace se::view
