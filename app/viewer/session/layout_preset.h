/// The ways the window can be arranged: for working, for learning, for showing to others.
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
    Compare,  ///< Two runs, or a run and a mesh, side by side; F2 passes it over.
};

/// One row of the table of arrangements.
struct ArrangementRow {
    Arrangement id;
    std::string_view name;   ///< As in --layout.
    std::string_view title;  ///< For people.
    std::string_view help;   ///< What is there, and the way back.
};

/// All of them; F2 goes through the first three in this order.
std::span<const ArrangementRow> arrangements();
const ArrangementRow& rowOf(Arrangement arrangement);
/// Nothing if there is none of that name.
std::optional<Arrangement> arrangementFromName(std::string_view name);
/// The one after it on F2; after the last, and from Compare, the first.
Arrangement following(Arrangement arrangement);

}  // namespace se::view
