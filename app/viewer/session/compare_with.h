/// What the run that is open is compared with.
#pragma once

#include <string>

#include "run/model.h"

namespace se::view {

struct CompareWith {
    enum class Kind : std::uint8_t { Nothing, Run, Mesh };
    Kind kind = Kind::Nothing;
    InputSpec run;     ///< The same source, with other rules or prepared in another way.
    std::string mesh;  ///< Path of a mesh that was made on the same points.

    static CompareWith otherRun(InputSpec spec) { return {Kind::Run, std::move(spec), {}}; }
    static CompareWith otherMesh(std::string path) { return {Kind::Mesh, {}, std::move(path)}; }
};

/// In what `b` differs from `a`: "robust rules", "flip off, 16 nearest"; "the same" if in nothing.
std::string differenceText(const InputSpec& a, const InputSpec& b);
/// What A is called beside it: "paper rules", with single rules that differ.
std::string runTitle(const InputSpec& spec);
/// The set of rules that says most beside those of `spec`: robust, or paper if that is on.
InputSpec usualOther(InputSpec spec);
/// The name without folders.
std::string meshTitle(const CompareWith& with);

}  // namespace se::view
