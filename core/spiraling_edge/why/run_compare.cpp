/// Two steppers side by side, one pivot at a time, each with a log of that pivot. Until the first
/// pivot with a different result both have the same state, so that comparing logs suffices
/// (pivot_difference.h); afterwards both run on to their ends alone. The step that made each
/// triangle is recorded on the way, for differences of the final meshes. O(both runs).
#include "spiraling_edge/why/run_compare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/origin_decisions.h"
#include "spiraling_edge/why/pivot_difference.h"

namespace se {
namespace {

/// The corners of a triangle from the least one on, as a key.
std::array<Index, 3> cornersOf(const Triangle& t) {
    const Triangle s = fromLeastCorner(t);
    return {s.a, s.b, s.c};
}

/// Records the event that made each triangle while a run goes on.
class TriangleOrigins {
  public:
    void add(const Event& event) {
        if (const auto* emit = as<EmitEvidence>(event)) {
            emitted_.resize(emit->triangle);  // those of a given start: address 0
            emitted_.push_back(event.address);
        } else if (editsMesh(event)) {
            repairs_.push_back(event);
        }
    }
    MadeMesh take(State end) const {
        MadeMesh mesh;
        mesh.pivots = end.counters.pivots;
        if (end.repair.empty()) {
            mesh.triangles = std::move(end.triangles);
            mesh.made = emitted_;
            mesh.made.resize(mesh.triangles.size());
            return mesh;
        }
        std::map<std::array<Index, 3>, Address> byCorners;
        for (std::size_t i = 0; i < emitted_.size(); ++i)
            byCorners[cornersOf(end.triangles[i])] = emitted_[i];
        mesh.triangles = end.repair.triangles.take();
        for (const Triangle& t : mesh.triangles) {
            const auto found = byCorners.find(cornersOf(t));
            mesh.made.push_back(found != byCorners.end() ? found->second : repairOrigin(t));
        }
        mesh.emitted = std::move(end.triangles);
        return mesh;
    }

  private:
    /// The last step after the pivots that can have made this triangle.
    Address repairOrigin(const Triangle& t) const {
        const auto leaves = [&](const Event& event) {
            if (const auto* flip = as<FlipEvidence>(event))
                return hasCorner(t, flip->x) && hasCorner(t, flip->y);
            const auto* point = as<ReinsertEvidence>(event);
            return point != nullptr && hasCorner(t, point->point);
        };
        const auto fillsHole = [](const Event& event) {
            return isA<CloseHoleEvidence>(event) || isA<RemeshEvidence>(event);
        };
        auto found = std::find_if(repairs_.rbegin(), repairs_.rend(), leaves);
        // Other triangles fill a hole or the place of a fault; the events do not name them.
        if (found == repairs_.rend())
            found = std::find_if(repairs_.rbegin(), repairs_.rend(), fillsHole);
        return found != repairs_.rend() ? found->address : Address{};
    }

    std::vector<Address> emitted_;
    std::vector<Event> repairs_;
};

/// One of the two runs, a pivot at a time.
class Walker {
  public:
    explicit Walker(const ComparedRun& run) : run_(run), stepper_(run.points, run.params, &log_) {}
    Walker(const Walker&) = delete;
    Walker& operator=(const Walker&) = delete;

    void step() {
        log_.clear();
        if (over_) return;
        over_ = !stepper_.stepPivot();
        for (const Event& event : log_.events()) origins_.add(event);
    }
    bool over() const { return over_; }
    std::span<const Event> events() const { return log_.events(); }
    Index pivot() const { return pivotPoint(log_.events()); }
    DifferenceSide side(std::size_t event, bool decides) const {
        if (event >= log_.events().size()) return {false, {}};
        return {decides, lineOf(log_.events()[event], {run_.points, run_.params, pivot()})};
    }
    double share() const {
        const auto all = static_cast<double>(std::max<std::size_t>(run_.points.size(), 1));
        return over_ ? 1.0 : static_cast<double>(stepper_.state().done.size()) / all;
    }
    MadeMesh take() { return origins_.take(stepper_.takeState()); }

  private:
    ComparedRun run_;
    EventLog log_;
    Stepper stepper_;
    TriangleOrigins origins_;
    bool over_ = false;
};

RunDifference differenceAt(const Mismatch& mismatch, const Walker& a, const Walker& b) {
    const Index pivot = a.pivot() != kNone ? a.pivot() : b.pivot();
    return {a.side(mismatch.a, mismatch.aDecides), b.side(mismatch.b, mismatch.bDecides),
            wordsFor(mismatch, a.events(), b.events(), pivot)};
}

/// Compares the pivot that both have just completed.
void comparePivot(const Walker& a, const Walker& b, RunComparison& found) {
    if (!sameResult(a.events(), b.events())) {
        found.first = differenceAt(firstDifference(a.events(), b.events()), a, b);
        return;
    }
    if (const auto other = firstOtherTest(a.events(), b.events())) {
        if (found.harmlessPivots++ == 0) found.harmless = differenceAt(*other, a, b);
    }
    if (!a.over() && !b.over()) ++found.commonPivots;
}

}  // namespace

std::optional<Address> firstMade(const MadeMesh& mesh, std::span<const Index> triangles) {
    std::optional<Address> first;
    for (const Index t : triangles) {
        if (t >= mesh.made.size() || mesh.made[t].pivot == 0) continue;
        const Address& made = mesh.made[t];
        if (!first || std::pair(made.pivot, made.n) < std::pair(first->pivot, first->n))
            first = made;
    }
    return first;
}

Result<MadeMesh> makeMesh(const ComparedRun& run, const Progress& progress) {
    Walker walker(run);
    for (std::uint32_t count = 0; !walker.over(); ++count) {
        walker.step();
        if (count % kPivotsPerReport == 0 && progress && !progress(walker.share()))
            return Error{"Cancelled."};
    }
    return walker.take();
}

Result<RunComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const Progress& progress) {
    if (a.points.size() != b.points.size()) {
        return Error{"The runs have not the same points: A has " + std::to_string(a.points.size()) +
                     ", B has " + std::to_string(b.points.size()) + "."};
    }
    assert(validate(a.points).ok() && validate(b.points).ok());
    RunComparison found;
    Walker left(a);
    Walker right(b);
    for (std::uint32_t count = 0; !left.over() || !right.over(); ++count) {
        left.step();
        right.step();
        if (!found.first) comparePivot(left, right, found);
        if (count % kPivotsPerReport == 0 && progress &&
            !progress((left.share() + right.share()) / 2.0))
            return Error{"Cancelled."};
    }
    found.a = left.take();
    found.b = right.take();
    return found;
}

}  // namespace se
