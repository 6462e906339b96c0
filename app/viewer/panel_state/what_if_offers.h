/// What-ifs available at the cursor. Plain values, no ImGui.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "spiraling_edge/spec/run_spec.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

class Session;

struct WhatIfOffer {
    WhatIf what;
    std::string label;  ///< Label of its button: "Keep point 812".
};

/// The possible overrides of an event's test; `pivot` is the point of the pivot.
std::vector<WhatIfOffer> offersAt(const Event& event, Index pivot);

/// The possible overrides at the cursor.
std::vector<WhatIfOffer> offersHere(const Session& session);
/// Reason why there are none, or the place of the actual decision.
std::string noOfferText(const Event& event);

/// The possible overrides of the tests of a point in this pivot, each once; then the continuation
/// at it after the pivot. For the context menu.
std::vector<WhatIfOffer> offersAbout(const Session& session, Index point);

/// The user's input for a point: its position and its neighbor list.
struct WhatIfForm {
    Index point = kNone;
    std::uint32_t generation = 0;
    bool dragged = false;  ///< The fields have the place of a point that is being dragged.
    std::array<std::string, 3> to;
    std::string list;

    /// Loads the values of the point, if the point or the run is another one, or it is dragged.
    void take(const Session& session, Index point);
    /// Parses the fields, for a change from the pivot of the cursor on. Fails with a sentence.
    Result<WhatIf> move(std::uint32_t pivot) const;
    Result<WhatIf> neighbors(std::uint32_t pivot) const;
};

/// The pivot from which a change of the points at the cursor applies: its own, or the first.
std::uint32_t forkPivot(const Session& session);
/// `rules` with one more what-if; it replaces one about the same thing at the same place.
RunSpec withWhatIf(const RunSpec& rules, const WhatIf& what);

}  // namespace se::view
