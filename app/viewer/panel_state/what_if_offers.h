/// What a person may let happen otherwise at the cursor. Plain values, no ImGui.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "run/rule_set.h"
#include "spiraling_edge/stepper/event.h"

namespace se::view {

class Session;

struct WhatIfOffer {
    WhatIf what;
    std::string label;  ///< Of its button: "Keep point 812".
};

/// What the test that the event is about could say instead; `pivot` is the point of the pivot.
std::vector<WhatIfOffer> offersAt(const Event& event, Index pivot);

/// What may happen otherwise at the cursor.
std::vector<WhatIfOffer> offersHere(const Session& session);
/// Why nothing may, or what decides it instead.
std::string noOfferText(const Event& event);

/// What the tests of a point in this pivot could say instead, each once; then that the run goes on
/// at it behind the pivot. For the menu of a right click.
std::vector<WhatIfOffer> offersAbout(const Session& session, Index point);

/// What a person types in for a point: its place and its list.
struct WhatIfForm {
    Index point = kNone;
    std::uint32_t generation = 0;
    std::array<std::string, 3> to;
    std::string list;

    /// Takes over what the point has, if it is another one or another run.
    void take(const Session& session, Index point);
    /// What the fields say, from the pivot of the cursor on. Fails with a sentence.
    Result<WhatIf> move(std::uint32_t pivot) const;
    Result<WhatIf> neighbors(std::uint32_t pivot) const;
};

/// The pivot that a change of the points at the cursor begins with: its own, or the first.
std::uint32_t forkPivot(const Session& session);
/// `rules` with one more what-if; one about the same thing at the same place gives way.
RuleSet withWhatIf(const RuleSet& rules, const WhatIf& what);
/// ... without the one at place `i`.
RuleSet withoutWhatIf(const RuleSet& rules, std::size_t i);

}  // namespace se::view
