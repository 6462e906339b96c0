/// Follows one failure through a run and remembers its three moments.
#pragma once

#include <optional>
#include <vector>

#include "spiraling_edge/explain/failure_moments.h"

namespace se {

/// What all finders of a run share.
struct FinderInput {
    const PointSet& points;
    const Params& params;
    const std::vector<Triangle>& mesh;
    const std::vector<LedgerLine>& moves;  ///< Of start and end in the present pivot so far.
};

class MomentFinder {
  public:
    /// `failure` and `input` must stay. Requires triangles below mesh.size().
    MomentFinder(const FinderInput& input, const MeshFailure& failure);

    /// Those of the failure and the corners of its triangles, ascending.
    const std::vector<Index>& points() const { return points_; }
    /// Points that may bring it about by becoming DONE.
    const std::vector<Index>& around() const { return around_; }
    /// Looks at the next event; those about none of its points may be left out.
    void see(const LedgerLine& line);
    /// The ring of the failure is freed.
    void seeFreed(const LedgerLine& line) { created_ = line; }
    /// The triangle that is the whole fan of its pivot, if such a one brought the failure about.
    Index alone() const { return alone_; }
    /// Nothing if the failure does not come from this run.
    std::optional<FailureMoments> found() const;

  private:
    /// What of a run brings a failure about.
    enum class Kind : std::uint8_t { Point, Hole, Ring, Triangle };
    static Kind kindOf(const MeshFailure& failure);

    bool mine(Index p) const;
    bool touches(const Event& event) const;
    void seeForPoint(const LedgerLine& line);
    std::optional<LedgerLine> moveOver(const DropEvidence& drop) const;
    void seeForRing(const LedgerLine& line);
    bool isOne(const EmitEvidence& made) const;
    bool isThere() const;
    bool isEarlyFailure() const;
    bool mends(const Event& event) const;
    void seeForTriangle(const LedgerLine& line);
    void remember(const LedgerLine& line);
    std::optional<LedgerLine> decisionForPart(const Triangle& made) const;
    std::optional<LedgerLine> decisionFor(const Triangle& made) const;

    const FinderInput& input_;
    const MeshFailure& failure_;
    Kind kind_;
    std::vector<Triangle> triangles_;  ///< Of the failure.
    std::vector<Index> points_;
    std::vector<Index> around_;  ///< Of a point in no triangle: those that it lists.
    std::optional<LedgerLine> created_;
    std::optional<LedgerLine> unavoidable_;
    std::optional<LedgerLine> outside_;    ///< The last refusal of a point outside of the sector.
    std::optional<LedgerLine> alonePair_;  ///< Found only one other point, which finds only it.
    std::optional<LedgerLine> part_;       ///< What made the edge or point that is at fault.
    std::optional<LedgerLine> touched_;
    std::optional<LedgerLine> deserted_;  ///< The last of the neighbors became DONE.
    Index alone_ = kNone;
    std::vector<Triangle> made_;       ///< Of the failure, in the order of the run.
    bool complete_ = false;            ///< Enough of them: those that follow are no cause.
    std::uint32_t pivot_ = 0;          ///< That `decided_` is about.
    std::vector<LedgerLine> decided_;  ///< Tests of this pivot that a triangle may come from.
};

}  // namespace se
