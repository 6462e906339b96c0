/// State and requests of the layout Compare. Plain values.
#pragma once

#include <optional>

#include "compare_form.h"
#include "session/compare/compare_with.h"
#include "session/compare/comparison.h"

namespace se::view {

/// Request by a command or panel, carried out at the end of the frame.
enum class CompareAsk : std::uint8_t {
    Nothing,
    Usual,            ///< Compare with the most informative rules beside those of the run.
    FirstDifference,  ///< Both go to the first decision in which they differ.
    FirstHarmless,    ///< To the first decision that differs without a consequence.
    NextRegion,
    PreviousRegion,
    Swap,  ///< The open run and the other run change places.
    Stop,
};

struct ComparePage {
    const Comparison* now = nullptr;  ///< Current comparison; null if nothing can be compared.
    CompareForm form;
    bool choosing = false;  ///< The form is open although there is a comparison.
    CompareAsk ask = CompareAsk::Nothing;
    std::optional<CompareWith> begin;
    std::optional<std::size_t> show;    ///< The region to be shown.
    std::optional<std::size_t> region;  ///< The region that is shown.
    std::optional<ComparedAddresses> goTo;
    std::optional<Selection> wantsWhy;  ///< Subject of a query to both runs.
    std::optional<Selection> why;       ///< Subject of the last query.
    /// The run as it was before it was opened again with other options.
    std::optional<InputSpec> before;

    const Compared* result() const { return now != nullptr ? now->result() : nullptr; }
};

}  // namespace se::view
