/// Another run, a finished mesh or a trace beside the open run: opened, compared and moved along in
/// the background. Independent of window and OpenGL.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jobs/background_job.h"
#include "jobs/file_watch.h"
#include "panel_state/forms.h"
#include "run/model.h"
#include "session/compare_with.h"
#include "session/layout_preset.h"
#include "session/session.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/why/run_compare.h"
#include "teach/trace/trace_diff.h"

namespace se::view {

// The trace of another implementation as a run to look at: the mesh that its fans lay, pivot by
// pivot, and the rings and statuses that follow from it.

/// A position in a trace.
struct TracePosition {
    std::uint32_t pivot = 0;  ///< From 1; 0: before the first.
    std::size_t laid = 0;     ///< Triangles of its fan so far.
    bool complete = false;    ///< After the pivot: all of the fan is laid.
    friend bool operator==(const TracePosition&, const TracePosition&) = default;
};

class TraceReplay {
  public:
    /// `given`: triangles that the run begins with. Requires that the points of the trace are less
    /// than `pointCount`.
    TraceReplay(teach::Trace trace, std::vector<Triangle> given, std::size_t pointCount);

    std::uint32_t pivots() const { return static_cast<std::uint32_t>(trace_.pivots.size()); }
    const teach::Trace& trace() const { return trace_; }
    /// The mesh at the end, its triangles in the order of the fans; `made`: with the address that
    /// an `emit` of ours would have.
    const MadeMesh& mesh() const { return mesh_; }
    /// Triangles of the fan of a pivot, from 1.
    std::span<const Triangle> fanOf(std::uint32_t pivot) const;
    /// The state at a position, without a decision. The rings are the loops of edges with a single
    /// triangle, or the active ring of the trace; a point is DONE once it was a pivot, or no such
    /// edge has it. O(triangles so far).
    DecisionState stateAt(const TracePosition& position) const;
    /// "Pivot 8 of the trace: point 11 between 1 and 3, fan 1 4 3."
    std::string sentence(const TracePosition& position) const;

  private:
    std::vector<RingPath> ringsAt(std::size_t triangles, std::uint32_t pivots) const;

    teach::Trace trace_;
    std::size_t pointCount_;
    MadeMesh mesh_;
    std::vector<std::size_t> begin_;  ///< First triangle of each pivot's fan, and the end.
};

/// A trace beside the open run, and their first difference.
struct ComparedTrace {
    TraceReplay replay;
    teach::TraceComparison comparison;
    std::string guess;  ///< A sentence on the rules that account for it; empty: no difference.
};

/// The common part of the timelines of two runs A and B.
struct RunAlignment {
    std::uint32_t alike = 0;  ///< Number of equal pivots at the start.
    bool diverge = false;     ///< The runs are not equal to the end.
    std::uint32_t endA = 0;   ///< Number of pivots of each.
    std::uint32_t endB = 0;
};

/// The pivot of B that matches one of A: the same one up to that of the first difference; after
/// it the same share of what is left, so that both ends match. Monotonic in `pivot`.
std::uint32_t matchingPivot(const RunAlignment& alignment, std::uint32_t pivot);
/// True if both are in the same pivot: then B follows stage by stage, otherwise by whole pivots.
bool inStep(const RunAlignment& alignment, std::uint32_t pivot);

/// Result of a comparison. The meshes of the runs are those after the last step.
struct Compared {
    std::shared_ptr<const Model> a;
    std::shared_ptr<const Model>
        b;               ///< For a mesh from a file: A's points, and the vertices on none of them.
    RunComparison runs;  ///< For a file: without decisions.
    std::shared_ptr<const ComparedTrace> trace;  ///< Null: B is no trace.
    MeshDifference meshes;
    TriangleSet setA, setB;
    std::vector<Index> unmatchedVertices;  ///< Vertices of the file that lie on no point.

    RunAlignment alignment() const {
        const bool diverge =
            trace ? trace->comparison.difference.has_value() : runs.first.has_value();
        return {runs.commonPivots, diverge, runs.a.pivots, runs.b.pivots};
    }
};

/// Targets for the cursor of the run and that of the other one.
struct ComparedAddresses {
    std::optional<Address> a;  ///< Empty: that run has ended by then.
    std::optional<Address> b;
};

class Comparison {
  public:
    /// Compares `run` with something else from now on, and again whenever it is opened again. A
    /// trace is read first, and again whenever its file changes; if that fails, the comparison
    /// before stays.
    void start(const Session& run, CompareWith with);
    /// Ends the comparison.
    void cancel();
    /// Takes the results of the threads, and lets the other run follow. True if there is
    /// something new to draw.
    bool poll(const Session& run);
    /// Blocks until no work is in progress.
    void waitUntilDone(Session& run);

    const CompareWith& with() const { return with_; }
    bool chosen() const { return with_.kind != CompareWith::Kind::Nothing; }
    /// Something is being opened or compared.
    bool working() const;
    /// In [0, 1], while working().
    double share() const;
    /// Why there is nothing to show; empty if there is no problem.
    const std::string& complaint() const { return complaint_; }
    /// Why a trace was not read: name, line and field; empty if there is no problem.
    const std::string& refusal() const { return refusal_; }
    /// The position of the trace that matches the cursor of `run`. Requires a result with a trace.
    TracePosition tracePosition(const Session& run) const;
    /// Null until it is known.
    const Compared* result() const { return result_.get(); }
    /// Shared ownership of result(), for callers that keep it while another comparison may begin.
    const std::shared_ptr<const Compared>& sharedResult() const { return result_; }
    /// Grows with every new result.
    std::uint32_t revision() const { return revision_; }
    /// The other run; null if there is none (yet), or a mesh.
    Session* other() { return runs() && other_->ready() ? other_.get() : nullptr; }
    const Session* other() const { return runs() && other_->ready() ? other_.get() : nullptr; }

    /// Moves both, and holds the other one there until `run` moves.
    void goTo(Session& run, const ComparedAddresses& place);

  private:
    /// Cursor position of a run.
    struct Stand {
        std::uint32_t generation = 0;
        std::uint32_t pivot = 0;
        std::size_t cursor = 0;
        friend bool operator==(const Stand&, const Stand&) = default;
    };

    bool runs() const { return with_.kind == CompareWith::Kind::Run && other_ != nullptr; }
    bool fits(const Session& run) const;
    void startJob(const Session& run);
    void startTrace(const Session& run, const std::string& path);
    bool pollTrace(const Session& run);
    void takeTrace(const Session& run);
    void refuse(const Session& run);
    bool takeResult();
    void follow(const Session& run);
    static Stand standOf(const Session& run);
    std::optional<Address> wantedAddress(const Session& run) const;

    CompareWith with_;
    std::unique_ptr<Session> other_;
    BackgroundQuery<std::shared_ptr<const Compared>> query_;
    std::shared_ptr<const Compared> result_;
    std::shared_ptr<const Model> comparedA_;  ///< Key of the job, or of the result.
    std::shared_ptr<const Model> comparedB_;
    std::string complaint_;
    std::uint32_t revision_ = 0;

    BackgroundQuery<std::shared_ptr<const Compared>> traceQuery_;
    FileWatch traceFile_;  ///< Of the trace that is read, or was.
    std::string refusal_;

    std::optional<Address> held_;  ///< Position that the other run is held at ...
    std::optional<Stand> heldBy_;  ///< ... while this one is there; empty: on its way.
    std::optional<Stand> followed_;
    std::uint32_t asked_ = 0xffffffffU;  ///< The pivot requested from the other run.
};

// The layout Compare: the user's choice of the other run, and state. Plain values.

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

// Titles of two views that are compared.

/// Titles of the open run and of what it is compared with; `now`: null if nothing can be.
std::array<ComparedTitle, 2> comparedTitles(const Session& run, const Comparison* now);

}  // namespace se::view
