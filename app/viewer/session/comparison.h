/// Another run, or a finished mesh, beside the one that is open: opened, compared and moved along
/// in the background. Knows neither window nor OpenGL.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare_sync.h"
#include "compare_with.h"
#include "jobs/background_query.h"
#include "session.h"
#include "spiraling_edge/explain/run_compare.h"
#include "spiraling_edge/mesh/mesh_compare.h"

namespace se::view {

/// What was found. The meshes of the runs are those after the last step.
struct Compared {
    std::shared_ptr<const Model> a;
    std::shared_ptr<const Model> b;  ///< Of a mesh from a file: A's points, and those on none.
    RunComparison runs;              ///< Of a mesh from a file: its meshes alone.
    MeshDifference meshes;
    TriangleSet setA, setB;
    std::vector<Index> strangers;  ///< Vertices of the file that lie on no point.

    TwinTimes times() const {
        return {runs.pivotsAlike, runs.first.has_value(), runs.a.pivots, runs.b.pivots};
    }
};

/// Where the cursor of the run, and that of the other one, are to go.
struct ComparedPlace {
    std::optional<Address> a;  ///< Nothing: that run is over by then.
    std::optional<Address> b;
};

class Comparison {
  public:
    /// Compares `run` with something else from now on, and anew whenever it is opened anew.
    void begin(const Session& run, CompareWith with);
    /// No comparison any more.
    void stop();
    /// Takes over what threads have finished, and lets the other run follow. True if there is
    /// something new to draw.
    bool poll(const Session& run);
    /// Blocks until nothing is under way.
    void settle(Session& run);

    const CompareWith& with() const { return with_; }
    bool chosen() const { return with_.kind != CompareWith::Kind::Nothing; }
    /// Something is being opened or compared.
    bool working() const;
    /// In [0, 1], while working().
    double share() const;
    /// Why there is nothing to see; empty if all is well.
    const std::string& complaint() const { return complaint_; }
    /// Null until it is known.
    const Compared* result() const { return result_.get(); }
    /// Grows with every new result.
    std::uint32_t revision() const { return revision_; }
    /// The other run; null if there is none (yet), or a mesh.
    Session* other() { return runs() && other_->ready() ? other_.get() : nullptr; }
    const Session* other() const { return runs() && other_->ready() ? other_.get() : nullptr; }

    /// Moves both, and holds the other one there until `run` moves on.
    void goTo(Session& run, const ComparedPlace& place);

  private:
    /// Where a run stands.
    struct Stand {
        std::uint32_t generation = 0;
        std::uint32_t pivot = 0;
        std::size_t cursor = 0;
        friend bool operator==(const Stand&, const Stand&) = default;
    };

    bool runs() const { return with_.kind == CompareWith::Kind::Run && other_ != nullptr; }
    bool fits(const Session& run) const;
    void startJob(const Session& run);
    bool takeResult();
    void follow(const Session& run);
    static Stand standOf(const Session& run);
    std::optional<Address> wantedPlace(const Session& run) const;

    CompareWith with_;
    std::unique_ptr<Session> other_;
    Inquiry<std::shared_ptr<const Compared>> query_;
    std::shared_ptr<const Compared> result_;
    std::shared_ptr<const Model> comparedA_;  ///< What the job, or the result, is about.
    std::shared_ptr<const Model> comparedB_;
    std::string complaint_;
    std::uint32_t revision_ = 0;

    std::optional<Address> held_;  ///< Where the other run stays ...
    std::optional<Stand> heldBy_;  ///< ... while this one stands there; nothing: on its way.
    std::optional<Stand> followed_;
    std::uint32_t asked_ = 0xffffffffU;  ///< The pivot that the other run was sent to.
};

}  // namespace se::view
