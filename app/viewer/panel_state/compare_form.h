/// The user's choice of the other run. Plain values.
#pragma once

#include <array>
#include <string>

#include "prepare_form.h"
#include "run/model.h"

namespace se::view {

struct CompareForm {
    RuleSet rules;        ///< Set, single rules and what-ifs.
    PrepareForm prepare;  ///< Lists, normals, walls, rims.
    std::string whatIf;   ///< The line of another what-if, while it is typed.
    std::array<char, 64> ruleFilter{};
    std::string complaint;

    /// Starts with the most informative rule set beside `spec`; all else as in `spec`.
    void take(const InputSpec& spec, const Model& model);
    /// Starts with `other`, which is compared with already.
    void takeOther(const InputSpec& other, const Model& model);
    /// The open run was opened again as `now`: its own changes are applied to both.
    void follow(const InputSpec& before, const InputSpec& now, const Model& model);
    /// Adds the line of a what-if to those of the other run; otherwise sets the complaint.
    void addWhatIf();
    /// `base` with these choices. Fails with a sentence.
    Result<InputSpec> spec(const InputSpec& base) const;
};

/// `spec` without its what-ifs.
InputSpec trueRunOf(InputSpec spec);

}  // namespace se::view
