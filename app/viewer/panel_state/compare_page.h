/// What the layout Compare knows, and what was asked for in it. Plain values.
#pragma once

#include <optional>

#include "compare_form.h"
#include "session/compare_with.h"
#include "session/comparison.h"

namespace se::view {

/// Asked for by a command or panel, carried out at the end of the frame.
enum class CompareAsk : std::uint8_t {
    Nothing,
    Usual,            ///< Begin with the rules that say most beside those of the run.
    FirstDifference,  ///< Both go to the decision at which they part.
    FirstHarmless,    ///< To the first one that fell differently without a consequence.
    NextRegion,
    PreviousRegion,
    Swap,  ///< The other run becomes the one that is open, and the other way round.
    Stop,
};

struct ComparePage {
    const Comparison* now = nullptr;  ///< What there is; null where nothing can be compared.
    CompareForm form;
    bool choosing = false;  ///< The form is open although something is compared.
    CompareAsk ask = CompareAsk::Nothing;
    std::optional<CompareWith> begin;
    std::optional<std::size_t> show;    ///< The region to be shown.
    std::optional<std::size_t> region;  ///< The one that is shown.
    std::optional<ComparedPlace> goTo;
    std::optional<Selection> wantsWhy;  ///< Both runs are to be asked why.
    std::optional<Selection> why;       ///< What they were asked.
    /// The run as it was before it was opened anew with other options.
    std::optional<InputSpec> before;

    const Compared* result() const { return now != nullptr ? now->result() : nullptr; }
};

}  // namespace se::view
