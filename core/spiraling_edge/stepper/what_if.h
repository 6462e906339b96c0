/// What a person lets happen at one place of a run instead of what the rules say: the run forks
/// there. A what-if is data among the Params, so that everything that runs points under params runs
/// the fork as well; the one stepper carries it out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_set.h"
#include "spiraling_edge/stepper/event.h"

namespace se {

/// What is done.
enum class WhatIfKind : std::uint8_t {
    Keep,   ///< A tested candidate stays, whatever the test says.
    Drop,   ///< A tested candidate goes; at `limits`: start and end do not advance to it.
    Pivot,  ///< The traversal goes on at another point of the rings.
    Move,   ///< A point is moved, from this pivot on.
    List,   ///< A point has another neighbor list, from this pivot on.
};

/// One what-if. Its place is a stage of a pivot: whatever is tested there more than once is decided
/// alike.
struct WhatIf {
    WhatIfKind kind = WhatIfKind::Keep;
    std::uint32_t pivot = 0;
    Stage stage = Stage::Pivot;  ///< Of Keep and Drop; Advance for Pivot; else Pivot.
    Index point = kNone;
    Vec3 to{0.0};             ///< Of Move: the position, in scene units.
    std::vector<Index> list;  ///< Of List; by distance in the run, whatever its order here.
    friend bool operator==(const WhatIf&, const WhatIf&) = default;
};

/// "137.sphere keep 812", "137.sphere drop 812", "137.advance pivot 640", "137 move 812 0.1 0.2
/// 0.3", "137 list 812 5 7 9": reads back as the same what-if.
std::string lineOf(const WhatIf& whatIf);
/// One sentence for a person.
std::string describe(const WhatIf& whatIf);
/// Reads what lineOf() wrote; a test's number behind the stage is passed over. Fails with a
/// sentence that says what is expected.
Result<WhatIf> whatIfFromText(std::string_view text);
/// Where the run forks: the first event that can differ is behind it.
Address placeOf(const WhatIf& whatIf);

}  // namespace se
