/// The counterpart of a comparison with the open run.
#pragma once

#include <string>

#include "run/model.h"

namespace se::view {

struct CompareWith {
    enum class Kind : std::uint8_t { Nothing, Run, Mesh };
    Kind kind = Kind::Nothing;
    InputSpec run;     ///< The same source, with other rules or other preparation.
    std::string mesh;  ///< Path of a mesh that was made from the same points.

    static CompareWith otherRun(InputSpec spec) { return {Kind::Run, std::move(spec), {}}; }
    static CompareWith otherMesh(std::string path) { return {Kind::Mesh, {}, std::move(path)}; }
};

/// Differences of `b` from `a`: "robust rules", "flip off, 16 nearest"; "the same" if there are
/// none.
std::string differenceText(const InputSpec& a, const InputSpec& b);
/// Label of A beside B: "paper rules", with single rules that differ.
std::string runTitle(const InputSpec& spec);
/// The most informative rule set beside those of `spec`: robust, or paper if that is on.
InputSpec usualOther(InputSpec spec);
/// File name without folders.
std::string meshTitle(const CompareWith& with);

}  // namespace se::view
