/// One pass with a table of places finds exact copies. Expected O(points).
#include "spiraling_edge/points/usable_points.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/points/place_table.h"
#include "spiraling_edge/points/sentinels.h"

namespace se {
namespace {

/// Normals whose length differs from 1 by less than this are left unchanged, bit for bit.
constexpr double kUnitAlready = 1e-12;
/// Normals off by more than this are reported.
constexpr double kReportedTolerance = 1e-3;

}  // namespace

std::span<const AsideWords> asideReasons() {
    static constexpr AsideWords kReasons[] = {
        {Aside::NotFinite, "non_finite", "not finite", "it is not finite"},
        {Aside::Copy, "duplicates", "at the place of another", "it is a copy of point "},
        {Aside::Sentinel, "sentinels", "where a missing value was written",
         "a missing value was written there"},
        {Aside::LeftOut, "left_out", "left out as chosen", "it was left out as chosen"},
        {Aside::Stray, "strays", "far from all others", "it is far from all others"},
        {Aside::NoNormal, "zero_normals", "without a plane to derive a normal from",
         "no plane fits the points about it"},
        {Aside::Noise, "noise", "above or below others, where noise is as wide as the spacing",
         "it is above or below others, where noise is as wide as the spacing"},
    };
    static_assert(std::size(kReasons) + 1 == kAsides);
    return kReasons;
}

const AsideWords& wordsOf(Aside reason) {
    assert(reason != Aside::No);
    return asideReasons()[static_cast<std::size_t>(reason) - 1];
}

std::string asideText(const PointSet& points, Index p) {
    assert(points.isAside(p));
    std::string text = "Point " + std::to_string(p) + " was set aside before the run: ";
    text += wordsOf(points.aside[p]).clause;
    if (points.aside[p] == Aside::Copy) {
        const auto same =
            std::find(points.position.begin(), points.position.end(), points.position[p]);
        text += std::to_string(same - points.position.begin());
    }
    return text + ".";
}

namespace {

/// The first point at the place of each; kNone where that is not finite.
std::vector<Index> firstAt(std::span<const Vec3> position) {
    std::vector<Index> first(position.size(), kNone);
    PlaceTable seen(position.size());
    for (Index p = 0; p < position.size(); ++p) {
        if (isFinite(position[p])) first[p] = seen.add(position, p);
    }
    return first;
}

}  // namespace

PlacedPoints placedPoints(std::span<const Vec3> position, FarValues farValues) {
    PlacedPoints placed{std::vector<Aside>(position.size(), Aside::No), firstAt(position)};
    auto& [aside, original] = placed;
    for (Index p = 0; p < position.size(); ++p) {
        if (original[p] != p) aside[p] = original[p] == kNone ? Aside::NotFinite : Aside::Copy;
    }
    if (farValues == FarValues::Missing) markSentinels(position, original, aside);
    for (Index p = 0; p < position.size(); ++p) {
        if (aside[p] == Aside::Sentinel) original[p] = kNone;
    }
    return placed;
}

std::size_t countPlaces(std::span<const Vec3> position) {
    const std::vector<Index> first = firstAt(position);
    std::size_t places = 0;
    for (Index p = 0; p < position.size(); ++p) places += first[p] == p ? 1 : 0;
    return places;
}

bool scaleToUnit(Vec3& normal) {
    if (!hasDirection(normal)) return false;
    const double length = glm::length(normal);
    if (std::abs(length - 1.0) <= kUnitAlready) return false;
    // By the largest component first: squares of very long or short normals overflow or underflow.
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    normal /= largest;
    normal /= glm::length(normal);
    return !(std::abs(length - 1.0) <= kReportedTolerance);
}

void addDirection(std::vector<Vec3>& directions, Vec3 normal) {
    constexpr double kSame = 0.999999;
    if (!hasDirection(normal)) return;
    scaleToUnit(normal);
    const auto isSame = [&](const Vec3& other) { return glm::dot(normal, other) > kSame; };
    if (std::none_of(directions.begin(), directions.end(), isSame)) directions.push_back(normal);
}

Vec3 meanOfDirections(const std::vector<Vec3>& directions) {
    assert(!directions.empty());
    constexpr double kCancelled = 1e-6;
    Vec3 sum(0.0);
    for (const Vec3& each : directions) sum += each;
    return glm::length(sum) > kCancelled ? glm::normalize(sum) : directions.front();
}

Vec3 meanOfDirections(const std::vector<Vec3>& directions, std::size_t& averaged) {
    const Vec3 mean = meanOfDirections(directions);
    if (directions.size() > 1 && mean != directions.front()) ++averaged;
    return mean;
}

std::string averagedText(std::size_t places) {
    return places == 0
               ? std::string{}
               : counted(places, "place") + " with several normals: the mean of them is used";
}

Status checkColumns(const PointFile& file) {
    const std::size_t n = file.position.size();
    if (n >= kNone)
        return Error{"there are " + std::to_string(n) + " points; at most 4294967294 are possible"};
    const auto fits = [n](std::size_t size) { return size == 0 || size == n; };
    if (!fits(file.normal.size()) || !fits(file.type.size()) || !fits(file.neighbors.size()))
        return Error{"normals, types or neighbor lists are not as many as the points"};
    return file.neighbors.checkDivided();
}

namespace {

/// Keeps the rows of a column that are marked; an empty column stays empty.
template <typename T>
void keepRows(std::vector<T>& column, const std::vector<bool>& keep) {
    if (column.empty()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i]) column[kept++] = column[i];
    }
    column.resize(kept);
}

}  // namespace

std::vector<bool> usedPoints(std::size_t points, std::span<const Triangle> triangles) {
    assert(cornersBelow(triangles, points));
    std::vector<bool> used(points, false);
    for (const Triangle& t : triangles) used[t.a] = used[t.b] = used[t.c] = true;
    return used;
}

void keepColumns(PointFile& file, const std::vector<bool>& keep) {
    keepRows(file.position, keep);
    keepRows(file.normal, keep);
    keepRows(file.type, keep);
    for (Attribute& attribute : file.attributes) keepRows(attribute.values, keep);
}

std::vector<Index> keptNumbers(const std::vector<bool>& keep) {
    std::vector<Index> number(keep.size(), kNone);
    Index next = 0;
    for (std::size_t p = 0; p < keep.size(); ++p) {
        if (keep[p]) number[p] = next++;
    }
    return number;
}

NeighborLists keptLists(const NeighborLists& lists, const std::vector<Index>& number) {
    NeighborLists kept;
    std::vector<Index> list;
    for (Index p = 0; p < number.size(); ++p) {
        if (number[p] == kNone) continue;
        list.clear();
        for (const Index q : lists[p]) {
            if (q < number.size() && number[q] != kNone) list.push_back(number[q]);
        }
        kept.append(list);
    }
    return kept;
}

PointFile withUsedPoints(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkColumns(points).ok());
    const std::vector<bool> used = usedPoints(points.position.size(), triangles);
    const std::vector<Index> number = keptNumbers(used);
    PointFile made = points;
    if (points.hasNeighbors()) made.neighbors = keptLists(points.neighbors, number);
    keepColumns(made, used);
    made.faces.clear();
    made.faces.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        made.faces.push_back({number[t.a], number[t.b], number[t.c]});
    }
    return made;
}

std::size_t countUsedPoints(std::size_t points, std::span<const Triangle> triangles) {
    const std::vector<bool> used = usedPoints(points, triangles);
    return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace se
