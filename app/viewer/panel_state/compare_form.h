/// What a person wants the other run to be. Plain values.
#pragma once

#include <array>
#include <string>

#include "prepare_form.h"
#include "run/model.h"

namespace se::view {

struct CompareForm {
    RuleSet rules;        ///< Set, single rules and what-ifs.
    PrepareForm prepare;  ///< Lists, normals, walls, rims.
    std::string whatIf;   ///< The line of one more what-if, while it is typed.
    std::array<char, 64> ruleFilter{};
    std::string complaint;

    /// Begins with the set that says most beside `spec`; all else as there.
    void take(const InputSpec& spec, const Model& model);
    /// Begins with `other`, which is compared with already.
    void takeOther(const InputSpec& other, const Model& model);
    /// The run that is open was opened anew as `now`: what it changed itself counts for both.
    void follow(const InputSpec& before, const InputSpec& now, const Model& model);
    /// Adds the line of a what-if to those of the other run; else says what is wrong with it.
    void addWhatIf();
    /// `base` with all that. Fails with a sentence.
    Result<InputSpec> spec(const InputSpec& base) const;
};

/// `spec` without its what-ifs.
InputSpec trueRunOf(InputSpec spec);

}  // namespace se::view
