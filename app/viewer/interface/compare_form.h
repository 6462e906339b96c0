/// What a person wants the other run to be. Plain values.
#pragma once

#include <string>

#include "run/model.h"

namespace se::view {

struct CompareForm {
    enum class Reach : std::uint8_t { AsHere, Nearest, Radius };

    std::string rules = "robust";
    Rules switches;  ///< As they will be; those of the set, and what was turned over.
    Reach reach = Reach::AsHere;
    std::string count = "16";
    std::string radius = "0.1";
    std::string complaint;

    /// Begins with the set that says most beside `spec`.
    void take(const InputSpec& spec);
    /// Another set: all switches are those of that set.
    void chooseRules(const std::string& name);
    /// How many rules are not as in the set.
    int turnedOver() const;
    /// `base` with these rules and neighbors. Fails with a sentence.
    Result<InputSpec> spec(InputSpec base) const;
};

}  // namespace se::view
