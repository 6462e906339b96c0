/// The edge rings within a pivot: the effect of its events on them, entry by entry (§6.5). A record
/// holds only the rings before and after a pivot.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "spiraling_edge/run/ring_path.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/params.h"

namespace se {

class RingReplay {
  public:
    /// `before`: the rings before the pivot, as EdgeRings::withoutPoints() gives them.
    /// `rules`: those of the run.
    RingReplay(const EdgeRings& before, std::size_t pointCount, const PaperRules& rules = {});

    /// Applies the events of the pivot, in order.
    void apply(const Event& event);
    /// The rings just after the events applied so far.
    const EdgeRings& rings() const { return rings_; }
    /// Loops of the last split or join so far.
    const std::optional<RingExchange>& exchange() const { return exchange_; }
    /// An event named something that is not on the rings: from there on they stay unchanged.
    bool lost() const { return lost_; }

  private:
    /// An entry that the reciprocal test takes.
    struct Instance {
        Index entry = kNone;
        bool whatIf = false;  ///< Taken although its sector does not hold the pivot.
    };

    void on(const SeedEvidence& e);
    void on(const PivotEvidence& e) { takePivot(e.pivot, e.first, e.last); }
    void on(const FillEvidence& e) { takePivot(e.pivot, e.first, e.last); }
    void on(const InsertEvidence& e);
    void on(const LimitEvidence& e);
    void on(const ReciprocalEvidence& e);
    void on(const RingEvidence& e);
    void on(const SplitEvidence& e);
    void on(const JoinEvidence& e);
    void on(const CloseEvidence& e);
    void on(const ShelveEvidence& e);
    void on(const TakeUpEvidence& e);
    /// Closes a finished edge within a longer ring.
    void closeWithin(const CloseEvidence& e);
    template <typename Other>
    void on(const Other&) {}

    void takePivot(Index pivot, Index first, Index last);
    void beginUpdate();
    bool nextLink(Index point);
    void place(const Exchange& made, Index activeLength);
    Index nextEntry() const;
    std::vector<Index> entriesOf(Index ring) const;

    EdgeRings rings_;
    PaperRules rules_;
    std::optional<RingExchange> exchange_;
    bool lost_ = false;
    Stage stage_ = Stage::Pivot;
    // Entries.
    Index pivot_ = kNone;
    Index start_ = kNone;
    Index end_ = kNone;
    Index tested_ = kNone;                 ///< The entry under the reciprocal test.
    std::map<Index, Instance> instances_;  ///< Of a candidate that is on a ring already.
    bool updating_ = false;                ///< §6.5 has begun.
    std::vector<Index> leaving_;           ///< The next one last.
    std::vector<Index> inserted_;
    bool finished_ = false;   ///< A finished edge was closed: no link comes after.
    std::size_t linked_ = 0;  ///< Number of inserted entries that were checked for other instances.
    Index x_ = kNone;
    Index y_ = kNone;
};

}  // namespace se
