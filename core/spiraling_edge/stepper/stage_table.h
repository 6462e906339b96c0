/// The stages of a run in one table: their names, sections and tests. A new stage is a value of
/// Stage (event.h) and a row here.
#pragma once

#include <span>
#include <string_view>

#include "spiraling_edge/stepper/event.h"

namespace se {

/// The tests of a stage that a what-if can override (what_if.h).
enum class StageTests : std::uint8_t {
    None,
    OfPoints,  ///< Each tests one point.
    OfFans,    ///< Also of the neighbor ring as a whole: refused, no triangle is made.
};

/// One stage.
struct StageRow {
    Stage id;
    std::string_view name;     ///< "sphere", as shown to users and in addresses.
    std::string_view section;  ///< "6.3"; empty for those beyond the paper (docs/robust.md).
    StageTests tests;
};

/// All stages, in the order of the enum.
std::span<const StageRow> stageTable();
const StageRow& rowOf(Stage stage);

}  // namespace se
