/// State of the panels that query the run. Plain values, no ImGui.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "run/selection.h"
#include "spiraling_edge/explain/ring_history.h"
#include "step_panels_state.h"

namespace se::view {

/// A list of decisions that follows the cursor.
struct LineList {
    CursorWatch watch;
    const void* answer = nullptr;  ///< Line that was drawn last.
    int settling = 0;              ///< Frames without scrolling to the cursor.
};

struct LedgerPanel {
    std::string typed;      ///< Text in the box.
    std::string complaint;  ///< Error of the typed text.
    Selection seen;         ///< Selection when the panel was drawn last.
    bool wantsKeyboard = false;
    LineList list;
};

/// The lists of the panel Query.
enum class QueryList : std::uint8_t { Found, Closest };

struct QueryPanel {
    std::string typed;
    bool typing = false;  ///< The line requests the keyboard focus.
    bool wantsKeyboard = false;
    QueryList shown = QueryList::Found;
    LineList found;
    LineList closest;
};

/// Context menu of a thing in the view or in a list.
struct SubjectMenu {
    Selection what;
    std::optional<RingAddress> ring;  ///< Instead of a selection.
    bool wanted = false;              ///< To be opened in this frame.
    bool other = false;               ///< In the view of the other run (layout Compare).

    void open(const Selection& subject) {
        *this = {subject, std::nullopt, subject.kind != SelectionKind::None};
    }
    /// In the view of the other run, or of a finished mesh, which cannot be queried.
    void openBeside(const Selection& subject) { *this = {subject, std::nullopt, true, true}; }
    void open(const RingAddress& place) { *this = {Selection{}, place, true}; }
};

}  // namespace se::view
