/// An override of the rules at one place of a run, by the user: the run forks there. A what-if is
/// data in the Params, so that everything that runs points under params runs the fork as well; the
/// one stepper applies it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"

namespace se {

/// Kind of override.
enum class WhatIfKind : std::uint8_t {
    Keep,   ///< A tested candidate stays, whatever its test decides.
    Drop,   ///< A tested candidate is dropped; at `limits`: start and end do not advance to it.
    Pivot,  ///< The traversal continues at another point of the rings.
    Move,   ///< A point is moved, from this pivot on.
    List,   ///< A point has another neighbor list, from this pivot on.
};

/// One what-if. Its place is a stage of a pivot: repeated tests there are decided alike.
struct WhatIf {
    WhatIfKind kind = WhatIfKind::Keep;
    std::uint32_t pivot = 0;
    Stage stage = Stage::Pivot;  ///< The stage of Keep and Drop; Advance for Pivot; else Pivot.
    Index point = kNone;
    Vec3 to{0.0};             ///< For Move: the position, in scene units.
    std::vector<Index> list;  ///< For List, in any order; sorted by distance in the run.
    friend bool operator==(const WhatIf&, const WhatIf&) = default;
};

/// "137.sphere keep 812", "137.sphere drop 812", "137.advance pivot 640", "137 move 812 0.1 0.2
/// 0.3", "137 list 812 5 7 9": reads back as the same what-if.
std::string lineOf(const WhatIf& whatIf);
/// One sentence for display.
std::string describe(const WhatIf& whatIf);
/// Reads the text of lineOf(); a test's number after the stage is ignored. Fails with a sentence
/// that names what is expected.
Result<WhatIf> whatIfFromText(std::string_view text);
/// The place of the fork: the first event that can differ follows it.
Address placeOf(const WhatIf& whatIf);

}  // namespace se
