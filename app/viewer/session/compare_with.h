/// The counterpart of a comparison with the open run.
#pragma once

#include <string>
#include <string_view>

#include "scene/palette.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se::view {

struct CompareWith {
    enum class Kind : std::uint8_t { Nothing, Run, Mesh, Trace };
    Kind kind = Kind::Nothing;
    RunSpec run;       ///< The same source, with other rules or other preparation.
    std::string path;  ///< Of a mesh that was made from the same points, or of a trace.

    static CompareWith otherRun(RunSpec spec) { return {Kind::Run, std::move(spec), {}}; }
    static CompareWith otherMesh(std::string path) { return {Kind::Mesh, {}, std::move(path)}; }
    static CompareWith otherTrace(std::string path) { return {Kind::Trace, {}, std::move(path)}; }
    /// A trace by its extension, otherwise a mesh.
    static CompareWith otherFile(std::string path);
    bool isFile() const { return kind == Kind::Mesh || kind == Kind::Trace; }
};

/// Parses the value of `--with` for a run of `base`: options as those of the run, "--rules robust
/// -k 16", in which it differs; otherwise the path of a mesh. Fails with a sentence.
Result<CompareWith> compareWithFromText(const std::string& text, const RunSpec& base);

/// Label of A beside B: "paper rules", with what else is set.
std::string runTitle(const RunSpec& spec);
/// The most informative rule set beside those of `spec`: robust, or paper if that is on.
RunSpec usualOther(RunSpec spec);
/// Name of the mesh or of the trace, without folders.
std::string fileTitle(const CompareWith& with);
/// True for the file name of a trace.
bool isTraceFile(std::string_view path);

/// The title of one of two views.
struct ComparedTitle {
    std::string letter;     ///< "A" or "B".
    std::string name;       ///< "paper rules", and what B has instead.
    std::string note;       ///< "212.sphere.3   12 only here"; empty: not known yet.
    Color Palette::*color;  ///< Of the triangles that are only in this one.

    /// "A, paper rules"
    std::string text() const { return letter + ", " + name; }
};

}  // namespace se::view
