/// The points of a run.
#pragma once

#include <memory>
#include <utility>

#include "spiraling_edge/points/point_set.h"

namespace se {

/// Points that a run reads, owned or borrowed. Made of a temporary, of a moved set or of a shared
/// pointer it keeps the points alive; made of a named set it borrows them, and that set must
/// outlive it.
class SharedPoints {
  public:
    // NOLINTBEGIN(google-explicit-constructor): every function that starts a run takes a PointSet
    SharedPoints(const PointSet& borrowed)
        : points_(std::shared_ptr<const PointSet>(), &borrowed) {}
    SharedPoints(PointSet&& owned) : points_(std::make_shared<const PointSet>(std::move(owned))) {}
    /// Requires that `owned` is not null.
    SharedPoints(std::shared_ptr<const PointSet> owned) : points_(std::move(owned)) {}
    // NOLINTEND(google-explicit-constructor)
    SharedPoints(const PointSet&&) = delete;  // would be borrowed from a temporary

    const PointSet& operator*() const { return *points_; }
    const PointSet* operator->() const { return points_.get(); }

  private:
    std::shared_ptr<const PointSet> points_;
};

}  // namespace se
