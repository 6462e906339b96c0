/// Follows one failure through a run and records its three moments.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/explain/failure_moments.h"

namespace se {

/// The common input of all finders of a run.
struct FinderInput {
    const PointSet& points;
    const Params& params;
    const std::vector<Triangle>& mesh;
    const std::vector<LedgerLine>& moves;  ///< Moves of start and end in the current pivot so far.
};

class MomentFinder {
  public:
    /// `failure` and `input` must outlive this object. Requires triangles below mesh.size().
    MomentFinder(const FinderInput& input, const MeshFailure& failure);

    /// The points of the failure, the corners of its triangles, and the points that may cause it
    /// by becoming DONE; some of them twice.
    const std::vector<Index>& watched() const { return watched_; }
    /// Takes the next event; events about none of watched() may be left out.
    void add(const LedgerLine& line);
    /// Takes the event at which the ring of the failure is freed.
    void addFreed(const LedgerLine& line) { created_ = line; }
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
    void addForPoint(const LedgerLine& line);
    std::optional<LedgerLine> moveOver(const DropEvidence& drop) const;
    void addForRing(const LedgerLine& line);
    bool isOne(const EmitEvidence& made) const;
    bool isThere() const;
    bool isRepair(const Event& event) const;
    void addForTriangle(const LedgerLine& line);
    void recordTest(const LedgerLine& line);
    std::optional<LedgerLine> decisionForPart(const Triangle& made) const;
    std::optional<LedgerLine> decisionFor(const Triangle& made) const;

    const FinderInput& input_;
    const MeshFailure& failure_;
    Kind kind_;
    std::vector<Triangle> triangles_;  ///< Triangles of the failure.
    std::vector<Index> points_;        ///< Of the failure and its triangles, ascending.
    std::vector<Index> watched_;  ///< `points_`; of a point in no triangle also those it lists.
    std::optional<LedgerLine> created_;
    std::optional<LedgerLine> unavoidable_;
    std::optional<LedgerLine> outside_;  ///< The last refusal of a point outside the sector.
    /// The pivot kept only one candidate, as the candidate's own list does.
    std::optional<LedgerLine> alonePair_;
    std::optional<LedgerLine> part_;  ///< The decision that made the faulty edge or point.
    std::optional<LedgerLine> touched_;
    std::optional<LedgerLine> deserted_;  ///< The last of the neighbors became DONE.
    Index alone_ = kNone;
    std::vector<Triangle> made_;       ///< Triangles of the failure made so far, in order.
    bool complete_ = false;            ///< The failure exists: later triangles are no cause.
    std::uint32_t pivot_ = 0;          ///< The pivot of `decided_`.
    std::vector<LedgerLine> decided_;  ///< Tests of this pivot that a triangle may come from.
};

}  // namespace se
