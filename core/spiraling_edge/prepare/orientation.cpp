/// Sides along a spanning forest, then a vote for each component. The cheapest edges of the forest
/// agree best, also those straight across a thin part, which holds for thin parts. Where two noisy
/// layers lie less than a spacing apart these edges contradict the others: a second forest, in
/// which steep edges cost more, is then tried for the component. On large sets in random order
/// nearly every access would miss the caches: these are worked on in the order of a Z-curve, in a
/// quarter of the time.
#include "spiraling_edge/prepare/orientation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/prepare/side_forest.h"

namespace se {
namespace {

constexpr std::size_t kOrientedPerThread = 2048;
/// Cost of an edge along the normal in the second forest.
constexpr double kSteepCost = 0.3;

/// For each component: mean disagreement over its list entries, 0 to 1.
std::vector<double> contradictionsIn(const SidesInput& input, const PointSides& sides) {
    const std::size_t count = input.normal.size();
    std::vector<double> each(count, 0.0);
    forEachItem(count, input.threads, kOrientedPerThread, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        if (!input.hasNormal(p)) return;
        for (const Index q : input.lists[p]) {
            if (!input.hasNormal(q)) continue;
            const double agreement = agreementOf(input, p, q);
            if ((sides.opposed[p] != sides.opposed[q]) != (agreement < 0.0))
                each[p] += std::abs(agreement);
        }
    });
    // In the order of the old numbers, since sums depend on it.
    std::vector<double> sum(sides.components, 0.0);
    std::vector<std::size_t> entries(sides.components, 0);
    for (Index i = 0; i < count; ++i) {
        const Index p = input.numbering.placeOf(i);
        if (sides.component[p] == kNone) continue;
        sum[sides.component[p]] += each[p];
        entries[sides.component[p]] += input.lists[p].size();
    }
    for (std::size_t c = 0; c < sum.size(); ++c) {
        if (entries[c] > 0) sum[c] /= static_cast<double>(entries[c]);
    }
    return sum;
}

std::vector<bool> listedWell(const SidesInput& input) {
    // Points of a surface are listed about as often as they list.
    constexpr std::size_t kLeastShare = 4;
    std::vector<bool> listed(input.normal.size());
    for (Index p = 0; p < listed.size(); ++p)
        listed[p] = kLeastShare * input.listedBy[p].size() >= input.lists[p].size();
    return listed;
}

/// Sides along a forest, with what speaks for them, by component.
struct SideChoice {
    PointSides sides;
    std::vector<double> contradictions;
    std::vector<FacingVote> votes;
};

/// The votes on these sides: toward a place, or outward if there is none.
std::vector<FacingVote> votesOn(const PointSides& sides, const SidesInput& input,
                                const std::optional<Vec3>& place) {
    std::vector<Vec3> normal(input.normal.begin(), input.normal.end());
    for (std::size_t p = 0; p < normal.size(); ++p) {
        if (sides.opposed[p] != 0) normal[p] = -normal[p];
    }
    const FacingInput facing{input.position,    normal,
                             sides.component,   sides.components,
                             listedWell(input), input.numbering.original};
    return place ? votesTowardScanner(facing, *place) : votesOutward(facing);
}

SideChoice candidateOf(const SidesInput& input, PointSides sides,
                       const std::optional<Vec3>& scanner) {
    std::vector<FacingVote> votes = votesOn(sides, input, scanner);
    std::vector<double> contradictions = contradictionsIn(input, sides);
    return {std::move(sides), std::move(contradictions), std::move(votes)};
}

/// More contradictions than this are no rare creases and noise.
constexpr double kDoubt = 0.01;

/// True if the second candidate is to be taken for component c. A thin plate has contradictions as
/// two layers have, but is a body along the first forest, and a sheet along the second.
bool isBetter(const SideChoice& second, const SideChoice& first, Index c) {
    constexpr double kClearly = 0.57;
    if (!(first.contradictions[c] > kDoubt)) return false;
    const bool clearly = second.contradictions[c] < kClearly * first.contradictions[c];
    return clearly && (second.votes[c].isKnown() || !first.votes[c].isKnown());
}

/// The sides along the first forest, or the second one in components where that is clearly better.
Result<SideChoice> findSides(const SidesInput& input, const std::optional<Vec3>& scanner,
                             const Progress& progress) {
    constexpr double kFirstShare = 0.95;  // Few inputs need the second forest.
    Result<PointSides> sides = sidesAlongForest(input, 0.0, partOf(progress, 0.0, kFirstShare));
    if (!sides) return sides.error();
    SideChoice first = candidateOf(input, std::move(sides.value()), scanner);
    if (std::none_of(first.contradictions.begin(), first.contradictions.end(),
                     [](double c) { return c > kDoubt; }))
        return first;
    sides = sidesAlongForest(input, kSteepCost, partOf(progress, kFirstShare, 1.0));
    if (!sides) return sides.error();
    const SideChoice second = candidateOf(input, std::move(sides.value()), scanner);
    std::vector<bool> better(first.votes.size());
    for (Index c = 0; c < better.size(); ++c) better[c] = isBetter(second, first, c);
    for (std::size_t p = 0; p < first.sides.opposed.size(); ++p) {
        const Index c = first.sides.component[p];
        if (c != kNone && better[c]) first.sides.opposed[p] = second.sides.opposed[p];
    }
    for (Index c = 0; c < better.size(); ++c) {
        if (better[c]) first.votes[c] = second.votes[c];
    }
    return first;
}

/// For each component: true if it is to be turned once its opposed normals are.
std::vector<bool> inwardComponents(const PointSides& sides, const std::vector<FacingVote>& votes,
                                   UnknownSide unknown) {
    std::vector<std::size_t> points(sides.components, 0);
    std::vector<std::size_t> turned(sides.components, 0);
    for (std::size_t p = 0; p < sides.component.size(); ++p) {
        if (sides.component[p] == kNone) continue;
        ++points[sides.component[p]];
        turned[sides.component[p]] += sides.opposed[p];
    }
    std::vector<bool> inward(sides.components);
    for (std::size_t c = 0; c < inward.size(); ++c) {
        const bool byVote = votes[c].isKnown() || unknown == UnknownSide::ByVote;
        inward[c] = byVote ? votes[c].isInward() : 2 * turned[c] > points[c];
    }
    return inward;
}

}  // namespace

Result<OrientationReport> orientNormals(const OrderedPoints& points, std::vector<Vec3>& normal,
                                        const OrientationOptions& options,
                                        const Progress& progress) {
    const SidesInput input{points.position(),  normal,
                           points.lists(),     listersOf(points.lists()),
                           points.numbering(), options.threads};
    const Result<SideChoice> found = findSides(input, options.scanner, progress);
    if (!found) return found.error();
    const PointSides& sides = found.value().sides;
    std::vector<FacingVote> votes = found.value().votes;
    const auto isUnknown = [](const FacingVote& vote) { return !vote.isKnown(); };
    const bool asksViewpoint =
        options.viewpoint && !options.scanner && std::any_of(votes.begin(), votes.end(), isUnknown);
    if (asksViewpoint) {
        const std::vector<FacingVote> toward = votesOn(sides, input, options.viewpoint);
        for (std::size_t c = 0; c < votes.size(); ++c) {
            if (isUnknown(votes[c])) votes[c] = toward[c];
        }
    }
    const std::vector<bool> inward = inwardComponents(sides, votes, options.unknown);
    OrientationReport report;
    report.components = sides.components;
    for (const FacingVote& each : votes) report.unknownSides += each.isKnown() ? 0U : 1U;
    for (std::size_t p = 0; p < normal.size(); ++p) {
        if (sides.component[p] == kNone) continue;
        if (inward[sides.component[p]] == (sides.opposed[p] != 0)) continue;
        normal[p] = -normal[p];
        ++report.turned;
    }
    return report;
}

Result<OrientationReport> orientNormals(std::span<const Vec3> position,
                                        const NeighborLists& neighbors, std::vector<Vec3>& normal,
                                        const OrientationOptions& options,
                                        const Progress& progress) {
    const OrderedPoints points(position, neighbors);
    std::vector<Vec3> own = points.renumbered(normal);
    Result<OrientationReport> report = orientNormals(points, own, options, progress);
    if (report) normal = points.restored(std::move(own));
    return report;
}

}  // namespace se
