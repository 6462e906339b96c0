/// Layouts of the window: for debugging, for learning, for presenting, for comparing.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace se::view {

enum class Arrangement : std::uint8_t {
    Debug,    ///< Everything.
    Learn,    ///< The paper's rule on the left, a large view and a large caption.
    Present,  ///< View, caption and the strip of the run.
    Compare,  ///< Two runs, or a run and a mesh, side by side; F2 skips it.
};

/// One row of the table of layouts.
struct ArrangementRow {
    Arrangement id;
    std::string_view name;   ///< Name for --layout.
    std::string_view title;  ///< Name for the user.
    std::string_view help;   ///< Content of the layout, and how to leave it.
};

/// All layouts; F2 cycles through the first three in this order.
std::span<const ArrangementRow> arrangements();
const ArrangementRow& rowOf(Arrangement arrangement);
/// Empty if there is none of that name.
std::optional<Arrangement> arrangementFromName(std::string_view name);
/// The next layout for F2; after the last, and from Compare, the first.
Arrangement following(Arrangement arrangement);

}  // namespace se::view
