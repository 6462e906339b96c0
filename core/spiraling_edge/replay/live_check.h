/// Failures noticed while a run goes on, at the decision that brings each of them about.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/stepper/event.h"

namespace se {

/// Something that is wrong from this event on.
struct LiveFailure {
    const FailureClass* kind = nullptr;
    Address address;         ///< Of the event: the triangle that is made, the point that is DONE.
    Index triangle = kNone;  ///< The new one; kNone: no triangle is involved.
    Index other = kNone;     ///< The first of the earlier triangles that it is wrong with.
    std::vector<Index> points;  ///< Ascending: the edge, the corners of both, the point.
};
/// One sentence with points and triangles.
std::string describe(const LiveFailure& failure);

/// The work that the search for crossings may take, in triangles looked at, kPairTestWork for each
/// whose box is met: a fixed amount, plus kLiveCheckWorkPerTriangle for each triangle. About a
/// second; a surface takes some hundred units per triangle.
inline constexpr std::uint64_t kLiveCheckWork = 200'000'000;
inline constexpr std::uint64_t kLiveCheckWorkPerTriangle = 4096;

/// Follows a run event by event. Of each triangle that is made it tells at most one failure of each
/// class: an edge of three triangles, an edge passed twice in one direction, three points that have
/// a triangle, no area, a crossing or a fold with an earlier triangle, a face against the normals;
/// and of each point that becomes DONE whether it is in no triangle, or its triangles are more than
/// one fan. The same predicates as
/// inspectMesh(), exact where that is. Rules that edit the mesh after the last pivot are not
/// followed: what they mend was a failure when it was made. Deterministic.
class LiveCheck {
  public:
    /// `points` must stay. Requires a valid PointSet.
    explicit LiveCheck(const PointSet& points);
    ~LiveCheck();
    LiveCheck(LiveCheck&&) noexcept;
    LiveCheck& operator=(LiveCheck&&) noexcept;

    /// The next events of the run, from its start on and without a gap; a pivot's are the usual
    /// piece. What went wrong in them, in their order. About O(1) for a triangle.
    std::vector<LiveFailure> see(std::span<const Event> events);
    /// The same for a single event.
    std::vector<LiveFailure> see(const Event& event) { return see(std::span(&event, 1)); }
    /// False once the work named above was used up: crossings are not noticed any more then, all
    /// other classes still are.
    bool complete() const;

  private:
    class Watch;
    std::unique_ptr<Watch> watch_;
};

}  // namespace se
