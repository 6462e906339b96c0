/// The layout Compare: the user's choice of the other run, and state. Plain values.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "comparison.h"
#include "panel_state/prepare_form.h"
#include "run/model.h"
#include "session/compare_with.h"
#include "session/layout_preset.h"

namespace se::view {

struct CompareForm {
    RunSpec rules;        ///< Its set, single rules and what-ifs count.
    PrepareForm prepare;  ///< Lists, normals, walls, rims.
    std::string whatIf;   ///< The line of another what-if, while it is typed.
    std::array<char, 64> ruleFilter{};
    std::string complaint;

    /// Starts with the most informative rule set beside `spec`; all else as in `spec`.
    void take(const RunSpec& spec, const Model& model);
    /// Starts with `other`, which is compared with already.
    void takeOther(const RunSpec& other, const Model& model);
    /// The open run was opened again as `now`: its own changes are applied to both.
    void follow(const RunSpec& before, const RunSpec& now, const Model& model);
    /// Adds the line of a what-if to those of the other run; otherwise sets the complaint.
    void addWhatIf();
    /// `base` with these choices. Fails with a sentence.
    Result<RunSpec> spec(const RunSpec& base) const;
};

/// `spec` without its what-ifs.
RunSpec trueRunOf(RunSpec spec);

struct ComparePage {
    const Comparison* now = nullptr;  ///< Current comparison; null if nothing can be compared.
    CompareForm form;
    bool inPresent = false;  ///< Also in the layout Present: a step of a lesson compares.
    bool choosing = false;   ///< The form is open although there is a comparison.
    std::optional<std::size_t> region;  ///< The region that is shown.
    std::optional<Selection> why;       ///< Subject of the last query to both runs.
    /// The run as it was before it was opened again with other options.
    std::optional<RunSpec> before;

    /// A layout shows two views.
    bool isIn(LayoutPreset layout) const {
        return layout == LayoutPreset::Compare || (layout == LayoutPreset::Present && inPresent);
    }
    const Compared* result() const { return now != nullptr ? now->result() : nullptr; }
};

}  // namespace se::view
