/// Failures detected during a run, at the decision that causes each of them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se {

/// A failure that exists from this event on.
struct LiveFailure {
    const FailureClass* kind = nullptr;
    /// Address of the event: the triangle that is made, the point that becomes DONE.
    Address address;
    Index triangle = kNone;     ///< The new one; kNone: no triangle is involved.
    Index other = kNone;        ///< The first earlier triangle involved.
    std::vector<Index> points;  ///< Ascending: the edge, the corners of both, the point.
};
/// One sentence with points and triangles.
std::string describe(const LiveFailure& failure);

/// Limit of the work of the search for pairs, in triangles visited, kPairTestWork for each
/// whose box is met: a fixed amount, plus kLiveCheckWorkPerTriangle for each triangle. About a
/// second; a surface takes some hundred units per triangle.
inline constexpr std::uint64_t kLiveCheckWork = 200'000'000;
inline constexpr std::uint64_t kLiveCheckWorkPerTriangle = 4096;

/// Follows a run event by event. For each triangle that is made it reports at most one failure of
/// each class: an edge of three triangles, an edge passed twice in one direction, three points that
/// have a triangle, almost no height, a crossing or a fold with an earlier triangle, a second layer
/// of one, a face against the normals; and for each point that becomes DONE whether it is in no
/// triangle, or its triangles are more than one fan. The predicates are those of inspectMesh(),
/// exact where those are. Rules that edit the mesh after the last pivot are not followed: the
/// failures they repair were failures when they were made. Deterministic.
class LiveCheck {
  public:
    /// `points` must outlive this object. Triangles of `start`, Params::start of the run, count as
    /// earlier ones; their own failures are not reported. Requires a valid PointSet.
    explicit LiveCheck(const PointSet& points, const GivenStart& start = {});
    ~LiveCheck();
    LiveCheck(LiveCheck&&) noexcept;
    LiveCheck& operator=(LiveCheck&&) noexcept;

    /// The failures of the next events of the run, in their order. `events` must follow from the
    /// start of the run without a gap, usually a pivot at a time. About O(1) for a triangle.
    std::vector<LiveFailure> check(std::span<const Event> events);
    /// The failures of a single event, the next one.
    std::vector<LiveFailure> check(const Event& event) { return check(std::span(&event, 1)); }
    /// False once the work limit above is reached: crossings and second layers are no longer
    /// detected then, all other classes still are.
    bool complete() const;

  private:
    class Checker;
    std::unique_ptr<Checker> checker_;
};

}  // namespace se
