/// Follows one failure through a run and records its three moments.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spiraling_edge/why/failure_moments.h"

namespace se {

/// A line that several finders keep: most failures of a run begin and end with the same events.
using SharedLine = std::shared_ptr<const LedgerLine>;

/// The common input of all finders of a run.
struct FinderInput {
    const PointSet& points;
    const Params& params;
    const std::vector<Triangle>& mesh;
    const std::vector<LedgerLine>& moves;  ///< Moves of start and end in the current pivot so far.
    const std::vector<LedgerLine>& tests;  ///< addTest() of the lines of the current pivot so far.
};

/// Appends a line to the tests of its pivot if a triangle may come from it; drops those of another
/// pivot.
void addTest(const LedgerLine& line, std::vector<LedgerLine>& tests);

class MomentFinder {
  public:
    /// `failure` and `input` must outlive this object. Requires triangles below mesh.size().
    MomentFinder(const FinderInput& input, const MeshFailure& failure);

    /// The points of the failure, the corners of its triangles, and the points that may cause it
    /// by becoming DONE; some of them twice.
    const std::vector<Index>& watched() const { return watched_; }
    /// Takes the next event; events about none of watched() may be left out.
    void add(const SharedLine& shared);
    /// Takes the event at which the ring of the failure is freed.
    void addFreed(const SharedLine& line) { created_ = line; }
    /// The triangle that is the whole fan of its pivot, if such a triangle caused the failure.
    Index alone() const { return alone_; }
    /// The moments; nothing if the failure does not come from this run.
    std::optional<FailureMoments> found() const;

  private:
    /// The kind of event that causes a failure.
    enum class Kind : std::uint8_t { Point, Hole, Ring, Triangle };
    static Kind kindOf(const MeshFailure& failure);

    bool mine(Index p) const;  ///< False for kNone.
    bool touches(const Event& event) const;
    void addForPoint(const SharedLine& shared);
    SharedLine moveOver(const DropEvidence& drop) const;
    void addForRing(const SharedLine& shared);
    bool isOne(const EmitEvidence& made) const;
    bool isThere() const;
    bool isRepair(const Event& event) const;
    void addForTriangle(const SharedLine& line);
    std::optional<LedgerLine> decisionForPart(const Triangle& made) const;
    std::optional<LedgerLine> decisionFor(const Triangle& made) const;

    const FinderInput& input_;
    const MeshFailure& failure_;
    Kind kind_;
    std::vector<Triangle> triangles_;  ///< Triangles of the failure.
    std::vector<Index> points_;        ///< Of the failure and its triangles, ascending.
    std::vector<Index> watched_;  ///< `points_`; of a point in no triangle also those it lists.
    SharedLine created_;
    SharedLine decided_;
    SharedLine outside_;  ///< The last refusal of a point outside the sector.
    /// The pivot kept only one candidate, as the candidate's own list does.
    SharedLine alonePair_;
    SharedLine part_;  ///< The decision that made the faulty edge or point.
    SharedLine touched_;
    SharedLine deserted_;  ///< The last of the neighbors became DONE.
    Index alone_ = kNone;
    std::vector<Triangle> made_;  ///< Triangles of the failure made so far, in order.
    bool complete_ = false;       ///< The failure exists: later triangles are no cause.
};

}  // namespace se
