/// Another run, a finished mesh or a trace beside the open run: opened, compared and moved along in
/// the background. Independent of window and OpenGL.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jobs/background_job.h"
#include "jobs/file_watch.h"
#include "session/compare_with.h"
#include "session/session.h"
#include "spiraling_edge/mesh/mesh_compare.h"
#include "spiraling_edge/why/run_compare.h"
#include "trace_replay.h"

namespace se::view {

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

/// The event of B that matches A's event at `cursor`, in the same pivot: that of the same
/// address, otherwise the last one of no later stage. Requires that B has events.
std::size_t matchingEvent(std::span<const Event> a, std::size_t cursor, std::span<const Event> b);

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
    /// The same, for callers that keep it while another comparison may begin.
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

}  // namespace se::view
