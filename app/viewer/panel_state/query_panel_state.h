/// What the panels that ask about the run remember. Plain values, no ImGui.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "run/selection.h"
#include "spiraling_edge/explain/ring_history.h"
#include "step_panels_state.h"

namespace se::view {

/// The tabs of those panels.
inline constexpr const char* kLedgerTab = "Ledger";
inline constexpr const char* kQueryTab = "Query";
inline constexpr const char* kChartsTab = "Charts";

/// A list of decisions that follows the cursor.
struct LineList {
    CursorWatch watch;
    const void* answer = nullptr;  ///< What was drawn last.
    int settling = 0;              ///< Frames in which it is not scrolled to the cursor.
};

struct LedgerPanel {
    std::string typed;      ///< In the box.
    std::string complaint;  ///< About what was typed.
    Selection seen;         ///< The selection when the panel was drawn last.
    bool wantsKeyboard = false;
    LineList list;
};

/// The lists of the panel Query.
enum class QueryList : std::uint8_t { Found, Closest };

struct QueryPanel {
    std::string typed;
    bool typing = false;  ///< The line has the keyboard.
    bool wantsKeyboard = false;
    QueryList shown = QueryList::Found;
    LineList found;
    LineList closest;
};

/// The menu of a thing in the view or in a list.
struct SubjectMenu {
    Selection what;
    std::optional<RingPlace> ring;  ///< Instead of a selection.
    bool wanted = false;            ///< To be opened in this frame.
    bool other = false;             ///< In the view of the run beside (layout Compare).

    void open(const Selection& subject) {
        *this = {subject, std::nullopt, subject.kind != SelectionKind::None};
    }
    /// In the view of the other run, or of a finished mesh, which has nothing to be asked.
    void openBeside(const Selection& subject) { *this = {subject, std::nullopt, true, true}; }
    void open(const RingPlace& place) { *this = {Selection{}, place, true}; }
};

}  // namespace se::view
