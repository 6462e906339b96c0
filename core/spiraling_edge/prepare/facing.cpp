/// Sides by vote: single points may have bad normals or lie off the surface, as at tips and in
/// noise, but not the outermost ones of most directions.
#include "spiraling_edge/prepare/facing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "spiraling_edge/points/usable_points.h"

namespace se {
namespace {

/// Least cosine between a normal and its direction for a vote.
constexpr double kFollows = 0.5;
/// Lines of the 26 directions.
constexpr std::size_t kLines = 13;

void vote(double cosine, FacingVote& result) {
    if (cosine >= kFollows) ++result.outward;
    if (cosine <= -kFollows) ++result.inward;
    if (std::abs(cosine) > std::abs(result.clearest)) result.clearest = cosine;
}

/// Unit vectors along the axes, then along the diagonals.
std::array<Vec3, kLines> makeLines() {
    std::array<Vec3, kLines> lines{Vec3(1, 0, 0),  Vec3(0, 1, 0), Vec3(0, 0, 1),  Vec3(1, 1, 0),
                                   Vec3(1, 0, 1),  Vec3(0, 1, 1), Vec3(1, -1, 0), Vec3(1, 0, -1),
                                   Vec3(0, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, -1), Vec3(1, -1, 1),
                                   Vec3(-1, 1, 1)};
    for (Vec3& line : lines) line /= std::sqrt(glm::dot(line, line));
    return lines;
}

/// The outermost point in a direction.
struct Outermost {
    bool listed = false;
    Index number = kNone;
    double reach = -std::numeric_limits<double>::infinity();
    double cosine = 0.0;

    void offer(const Outermost& other) {
        const auto rank = [](const Outermost& o) {
            return std::tuple(o.listed, o.reach, std::abs(o.cosine), ~o.number);
        };
        if (rank(*this) < rank(other)) *this = other;
    }
};

using Extremes = std::array<Outermost, 2 * kLines>;

/// A point as seen from the scanner.
struct Sighting {
    Index component = kNone;
    std::uint32_t cell = 0;
    bool unlisted = false;
    double distance = 0.0;
    double cosine = 0.0;
};

/// Cell of a direction on a cube with 4 x 4 cells a side: wide ones, so that none holds only points
/// of the hidden side, between those in front.
std::uint32_t cellOf(const Vec3& direction) {
    constexpr double kAcross = 4.0;
    const std::array<double, 3> size{std::abs(direction.x), std::abs(direction.y),
                                     std::abs(direction.z)};
    const auto axis =
        static_cast<Vec3::length_type>(std::max_element(size.begin(), size.end()) - size.begin());
    const double most = size[static_cast<std::size_t>(axis)];
    const auto along = [&](Vec3::length_type other) {
        const double at = 0.5 * kAcross * (1.0 + direction[other] / most);
        return static_cast<std::uint32_t>(std::min(at, kAcross - 1.0));
    };
    const std::uint32_t side = 2 * static_cast<std::uint32_t>(axis) + (direction[axis] < 0.0);
    constexpr auto kSide = static_cast<std::uint32_t>(kAcross);
    return (side * kSide + along((axis + 1) % 3)) * kSide + along((axis + 2) % 3);
}

}  // namespace

std::vector<FacingVote> votesOutward(const FacingInput& input) {
    static const std::array<Vec3, kLines> kLine = makeLines();
    std::vector<Extremes> extremes(input.components);
    for (std::size_t p = 0; p < input.position.size(); ++p) {
        if (input.component[p] == kNone) continue;
        Extremes& own = extremes[input.component[p]];
        const Index number = input.number.empty() ? static_cast<Index>(p) : input.number[p];
        for (std::size_t i = 0; i < kLines; ++i) {
            const double reach = glm::dot(input.position[p], kLine[i]);
            const double cosine = glm::dot(input.normal[p], kLine[i]);
            own[2 * i].offer({input.listed[p], number, reach, cosine});
            own[2 * i + 1].offer({input.listed[p], number, -reach, -cosine});
        }
    }
    std::vector<FacingVote> votes(input.components);
    for (std::size_t c = 0; c < votes.size(); ++c) {
        votes[c].needed = kLines;
        for (const Outermost& each : extremes[c]) vote(each.cosine, votes[c]);
    }
    return votes;
}

std::vector<FacingVote> votesTowardScanner(const FacingInput& input, const Vec3& scanner) {
    assert(isFinite(scanner));
    std::vector<Sighting> sightings;
    for (std::size_t p = 0; p < input.position.size(); ++p) {
        if (input.component[p] == kNone) continue;
        const Vec3 line = input.position[p] - scanner;
        const double distance = std::sqrt(glm::dot(line, line));
        if (!(distance > 0.0)) continue;
        sightings.push_back({input.component[p], cellOf(line), !input.listed[p], distance,
                             -glm::dot(input.normal[p], line) / distance});
    }
    const auto rank = [](const Sighting& s) {
        return std::tuple(s.component, s.cell, s.unlisted, s.distance, -std::abs(s.cosine),
                          s.cosine);
    };
    std::sort(sightings.begin(), sightings.end(),
              [&](const Sighting& a, const Sighting& b) { return rank(a) < rank(b); });
    std::vector<FacingVote> votes(input.components);
    const Sighting* before = nullptr;
    for (const Sighting& each : sightings) {
        const bool seen =
            before == nullptr || before->component != each.component || before->cell != each.cell;
        if (seen) vote(each.cosine, votes[each.component]);
        before = &each;
    }
    for (FacingVote& each : votes)
        each.needed = std::max<std::size_t>(1, (each.outward + each.inward + 1) / 2);
    return votes;
}

}  // namespace se
