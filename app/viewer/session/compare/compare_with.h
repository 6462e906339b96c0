/// The counterpart of a comparison with the open run.
#pragma once

#include <string>
#include <string_view>

#include "run/model.h"

namespace se::view {

struct CompareWith {
    enum class Kind : std::uint8_t { Nothing, Run, Mesh, Trace };
    Kind kind = Kind::Nothing;
    InputSpec run;     ///< The same source, with other rules or other preparation.
    std::string path;  ///< Of a mesh that was made from the same points, or of a trace.

    static CompareWith otherRun(InputSpec spec) { return {Kind::Run, std::move(spec), {}}; }
    static CompareWith otherMesh(std::string path) { return {Kind::Mesh, {}, std::move(path)}; }
    static CompareWith otherTrace(std::string path) { return {Kind::Trace, {}, std::move(path)}; }
    /// A trace by its extension, otherwise a mesh.
    static CompareWith otherFile(std::string path);
    bool isFile() const { return kind == Kind::Mesh || kind == Kind::Trace; }
};

/// Differences of `b` from `a`: "robust rules", "flip off, 16 nearest"; "the same" if there are
/// none.
std::string differenceText(const InputSpec& a, const InputSpec& b);
/// Label of A beside B: "paper rules", with single rules that differ.
std::string runTitle(const InputSpec& spec);
/// The most informative rule set beside those of `spec`: robust, or paper if that is on.
InputSpec usualOther(InputSpec spec);
/// Name of the mesh or of the trace, without folders.
std::string fileTitle(const CompareWith& with);
/// True for the file name of a trace.
bool isTraceFile(std::string_view path);

}  // namespace se::view
