/// findRim(): where a surface ends although no wall cuts it, on surfaces whose rims are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "spiraling_edge/prepare/rim.h"
#include "support/open_surfaces.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// Of all points nearer than `from` spacings to a rim, the share that is flagged; and of the
/// flagged ones the share that lies within `within` of one.
struct Score {
    double recall, precision;
};
Score scoreOf(const Open& open, const PointSet& points, double from, double within) {
    std::size_t near = 0;
    std::size_t found = 0;
    std::size_t flagged = 0;
    std::size_t right = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
        const double depth = open.toRim(open.file.position[p]) / open.spacing;
        const bool flag = isRimPoint(points.type[p]);
        near += depth < from ? 1U : 0U;
        found += depth < from && flag ? 1U : 0U;
        flagged += flag ? 1U : 0U;
        right += flag && depth < within ? 1U : 0U;
    }
    REQUIRE(near > 0);
    return {static_cast<double>(found) / static_cast<double>(near),
            flagged > 0 ? static_cast<double>(right) / static_cast<double>(flagged) : 1.0};
}

/// True if every step of every chain joins two points of which one lists the other, and no point is
/// twice on a chain.
bool areClosed(const Rim& rim, const PointSet& points) {
    bool closed = true;
    for (const auto& chain : rim.chains) {
        closed = closed && std::set<Index>(chain.begin(), chain.end()).size() == chain.size();
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const Index p = chain[i];
            const Index q = chain[(i + 1) % chain.size()];
            const auto lists = [&](Index a, Index b) {
                const auto list = points.neighbors[a];
                return std::find(list.begin(), list.end(), b) != list.end();
            };
            closed = closed && (lists(p, q) || lists(q, p)) && rim.gap[p].to == q;
        }
    }
    return closed;
}

}  // namespace

// ---- results ------------------------------------------------------------------------------------

TEST_CASE("rim: one closed chain for each rim of an open surface, and only points beside rims") {
    for (const Open& open : openSurfaces()) {
        CAPTURE(open.name);
        const Prepared prepared = withRim(open.file);
        CHECK(prepared.report.derived.rim);
        CHECK(prepared.report.derived.rimChains == open.rims);
        const Score score = scoreOf(open, prepared.points, 0.3, 1.2);
        CHECK(score.recall > 0.85);
        CHECK(score.precision == 1.0);
        const auto rim =
            findRim(prepared.points.position, prepared.points.normal, prepared.points.neighbors);
        REQUIRE(rim.ok());
        CHECK(areClosed(rim.value(), prepared.points));
        CHECK(rim.value().points() == prepared.report.derived.rimPoints);
    }
}

TEST_CASE("rim: the same with points that are moved about by a sixth of the spacing") {
    for (const Open& open : openSurfaces()) {
        CAPTURE(open.name);
        const Prepared prepared = withRim(shaken(open, 0.17, 7));
        CHECK(prepared.report.derived.rimChains == open.rims);
        const Score score = scoreOf(open, prepared.points, 0.3, 1.6);
        CHECK(score.recall > 0.7);
        CHECK(score.precision > 0.98);
    }
}

TEST_CASE("rim: the surface lies to the left of a chain") {
    const Prepared flat = withRim(disc(8.2).file);
    const PointSet& points = flat.points;
    const Rim rim = findRim(points.position, points.normal, points.neighbors).value();
    REQUIRE(rim.chains.size() == 1);
    double area = 0.0;
    const auto& chain = rim.chains[0];
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Vec3& x = points.position[chain[i]];
        const Vec3& y = points.position[chain[(i + 1) % chain.size()]];
        area += 0.5 * (x.x * y.y - x.y * y.x);
    }
    CHECK(area > 150.0);  // Counterclockwise around the disc, whose area is 211.
    for (Index p = 0; p < points.size(); ++p) {
        if (!rim.gap[p].known()) continue;
        // The middle of the disc is not in the gap.
        const Vec3 from = points.position[rim.gap[p].from] - points.position[p];
        const Vec3 to = points.position[rim.gap[p].to] - points.position[p];
        const double gap = turnDegrees(from, to);
        CHECK(turnDegrees(from, -points.position[p]) > gap);
    }
}

TEST_CASE("rim: none on closed surfaces of any size, even or shaken" *
          doctest::test_suite("long")) {
    for (const double scale : {0.2, 0.5, 1.0, 4.0}) {
        for (const Family& family : closedFamilies(scale)) {
            for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                CAPTURE(family.name);
                CAPTURE(scale);
                const Open closed{family.name,
                                  family.sample(seed),
                                  0,
                                  std::sqrt(12.57 / (300.0 * scale) * 1.1547),
                                  {}};
                CHECK(withRim(closed.file).report.derived.rimPoints == 0);
                if (scale >= 1.0) {
                    CHECK(withRim(shaken(closed, 0.17, seed)).report.derived.rimPoints == 0);
                }
            }
        }
    }
}

TEST_CASE("rim: what a wall cuts open is no rim") {
    const PointFile whole = sphere(1);
    PointFile half;
    for (std::size_t p = 0; p < whole.position.size(); ++p) {
        if (whole.position[p].z > 0.03) add(half, whole.position[p], whole.normal[p]);
    }
    for (int i = 0; i < 70; ++i) add(half, polar(360.0 * i / 70), polar(360.0 * i / 70));
    PrepareOptions options;
    options.rim = true;
    CHECK(prepare(half, options).value().report.derived.rimChains == 1);
    options.walls = WallBox{Vec3(-2, -2, 0), Vec3(2, 2, 2)};
    const Prepared cut = prepare(half, options).value();
    CHECK(cut.report.derived.rimPoints == 0);
    CHECK(std::count_if(cut.points.type.begin(), cut.points.type.end(), isOnWall) == 70);
}

TEST_CASE("rim: the same for any number of threads, and in any place") {
    Open open = sphereWithHoles({{1, 0, 0}, {0, 0, 1}}, 0.45, 1);
    PrepareOptions options;
    options.rim = true;
    options.neighbors.threads = 1;
    const Prepared one = prepare(open.file, options).value();
    options.neighbors.threads = 5;
    const Prepared five = prepare(open.file, options).value();
    CHECK(one.points.rim == five.points.rim);
    CHECK(one.points.type == five.points.type);
    for (Vec3& x : open.file.position) x = 4.0 * x;
    CHECK(prepare(open.file, options).value().points.rim == one.points.rim);
}

TEST_CASE("rim: the same for points of any size") {
    PointFile file = openSurfaces().front().file;
    PrepareOptions options;
    options.rim = true;
    const std::vector<Vec3> given = file.position;
    const std::vector<std::uint8_t> types = prepare(file, options).value().points.type;
    CHECK(std::any_of(types.begin(), types.end(), isRimPoint));
    for (const int power : {332, 465, -332, -465}) {
        CAPTURE(power);
        for (std::size_t p = 0; p < given.size(); ++p)
            file.position[p] = std::ldexp(1.0, power) * given[p];
        CHECK(prepare(file, options).value().points.type == types);
    }
}

TEST_CASE("rim: progress ascends over all of preparing, and no ends the search at any share") {
    const Open open = sphereWithHoles({{1, 0, 0}, {0, 0, 1}}, 0.45, 1);
    PrepareOptions options;
    options.rim = true;
    options.neighbors.symmetric = true;
    double last = 0.0;
    std::size_t calls = 0;
    REQUIRE(prepare(open.file, options, [&](double share) {
                CHECK(share >= last);
                last = share;
                ++calls;
                return true;
            }).ok());
    CHECK(last == 1.0);
    for (std::size_t until = 0; until + 1 < calls; ++until) {
        std::size_t seen = 0;
        const auto cancelled = prepare(open.file, options, [&](double) { return seen++ < until; });
        REQUIRE_FALSE(cancelled.ok());
        CHECK(cancelled.error().message.find("cancelled") != std::string::npos);
    }
    const PointSet points = prepared(open.file);
    const auto never = [](double) { return false; };
    CHECK_FALSE(findRim(points.position, points.normal, points.neighbors, {}, 2, never).ok());
    CHECK_FALSE(symmetricLists(points.position, points.neighbors, 2, never).ok());
}

TEST_CASE("rim: rim points of a file keep their type, and get their gap") {
    const Prepared found = withRim(cylinder().file);
    PointFile file = cylinder().file;
    file.type = found.points.type;
    const PointSet given = prepared(file);
    CHECK(given.type == found.points.type);
    for (Index p = 0; p < given.size(); ++p) {
        CHECK(given.gapAt(p).known() == isRimPoint(given.type[p]));
    }
    // On request they are recomputed.
    file.type.assign(file.type.size(), kRimPoint);
    CHECK(withRim(file).points.type == found.points.type);
    file.type.assign(file.type.size(), kInterior);
    CHECK(prepared(file).rim.empty());
}

// ---- the shared data ----------------------------------------------------------------------------

TEST_CASE("rim: the openings of scans are found, and nothing else") {
    struct Scan {
        const char* name;
        std::size_t rims, points;
    };
    const Scan scans[] = {
        {"mannequin_devil", 1, 82}, {"nefertiti", 1, 37},       {"three_peaks", 1, 141},
        {"blobs", 4, 65},           {"bunny", 5, 183},          {"armadillo", 0, 0},
        {"bunny_small", 0, 0},      {"elephant", 0, 0},         {"fandisk", 0, 0},
        {"kitten", 0, 0},           {"sphere_even", 0, 0},      {"torus_knot", 0, 0},
        {"table1_hydrogen", 0, 0},  {"table1_blast_wave", 0, 0}};
    for (const Scan& scan : scans) {
        const auto file = sharedPoints(std::string("points/") + scan.name + ".ply");
        if (!file) continue;
        CAPTURE(scan.name);
        const Prepared prepared = withRim(*file);
        CHECK(prepared.report.derived.rimChains == scan.rims);
        CHECK(prepared.report.derived.rimPoints == scan.points);
    }
}

TEST_CASE("rim: the points found are those of the borders of the scanned meshes") {
    for (const char* name : {"nefertiti", "three_peaks", "blobs"}) {
        const auto mesh = sharedPoints(std::string("meshes/") + name + ".ply");
        if (!mesh) continue;
        CAPTURE(name);
        std::set<std::pair<Index, Index>> sides;
        for (const Triangle& t : mesh->faces) sides.insert({{t.a, t.b}, {t.b, t.c}, {t.c, t.a}});
        std::vector<bool> border(mesh->position.size(), false);
        for (const auto& [u, v] : sides) {
            if (sides.count({v, u}) == 0) border[u] = border[v] = true;
        }
        const PointSet points = withRim(*mesh).points;
        std::size_t right = 0;
        std::size_t beside = 0;
        std::size_t flagged = 0;
        for (Index p = 0; p < points.size(); ++p) {
            if (!isRimPoint(points.type[p])) continue;
            const auto list = points.neighbors[p];
            ++flagged;
            right += border[p] ? 1U : 0U;
            beside += border[p] || std::any_of(list.begin(), list.begin() + 6,
                                               [&](Index q) { return border[q]; })
                          ? 1U
                          : 0U;
        }
        CHECK(beside == flagged);
        CHECK(10 * right > 9 * flagged);
    }
}

// ---- small holes --------------------------------------------------------------------------------

namespace {

/// A round hole in the plane: its points are one apart and list each other around it. A spoke is a
/// further neighbor of one of them alone.
class RoundHole {
  public:
    /// `given` are the first points, in no list yet.
    explicit RoundHole(Index count, std::vector<Vec3> given = {})
        : count_(count),
          first_(static_cast<Index>(given.size())),
          radius_(radiusOf(count)),
          position_(std::move(given)) {
        for (Index i = 0; i < count; ++i) position_.push_back(polar(degreesAt(i), radius_));
        lists_.resize(position_.size());
        for (Index i = 0; i < count; ++i) join(around(i), around(i + 1));
    }
    static double radiusOf(Index count) { return 0.5 / std::sin(kPi / count); }

    /// Point i of the hole, counterclockwise.
    Index around(Index i) const { return first_ + i % count_; }
    void join(Index p, Index q) { lists_[p].push_back(q); }
    /// A new point that lists no other.
    Index point(const Vec3& x) {
        position_.push_back(x);
        lists_.emplace_back();
        return static_cast<Index>(position_.size() - 1);
    }
    /// Point i of the hole lists a new point, in this direction counterclockwise from outward.
    void spoke(Index i, double degrees) {
        const Index p = around(i);
        join(p, point(position_[p] + polar(degreesAt(i) + degrees, 0.8)));
    }
    /// A spoke straight outward for each point of the hole but `except`.
    void spokes(Index except = kNone) {
        for (Index i = 0; i < count_; ++i) {
            if (i != except) spoke(i, 0.0);
        }
    }
    Rim rim(std::vector<std::uint8_t> type = {}) const {
        NeighborLists lists;
        for (const auto& list : lists_) lists.append(list);
        if (!type.empty()) type.resize(position_.size(), kInterior);
        auto found =
            findRim(position_, std::vector<Vec3>(position_.size(), Vec3(0, 0, 1)), lists, type, 1);
        REQUIRE(found.ok());
        return std::move(found.value());
    }

  private:
    double degreesAt(Index i) const { return 360.0 * i / count_; }

    Index count_, first_;
    double radius_;
    std::vector<Vec3> position_;
    std::vector<std::vector<Index>> lists_;
};

}  // namespace

TEST_CASE("rim: a hole is at least 2.5 of its edges wide") {
    // A round one of 8 is 2.41 wide, of 9 it is 2.75.
    RoundHole narrow(8);
    narrow.spokes();
    const Rim none = narrow.rim();
    CHECK(none.candidates == 8);
    CHECK(none.chains.empty());
    CHECK(none.points() == 0);
    RoundHole wide(9);
    wide.spokes();
    const Rim one = wide.rim();
    REQUIRE(one.chains.size() == 1);
    CHECK(one.chains[0] == std::vector<Index>{0, 8, 7, 6, 5, 4, 3, 2, 1});
    for (Index i = 0; i < 9; ++i) CHECK(one.gap[i] == RimGap{(i + 1) % 9, (i + 8) % 9});
    CHECK(one.points() == 9);
}

TEST_CASE("rim: two in three points of a chain have gaps of more than 120 degrees") {
    // With a spoke into the hole a gap of 110 degrees is left: a walk goes on along it.
    const auto chains = [](Index inward) {
        RoundHole hole(12);
        hole.spokes();
        for (Index i = 0; i < inward; ++i) hole.spoke(11 - i, 145.0);
        const Rim rim = hole.rim();
        CHECK(rim.candidates == 12 - inward);
        return rim.chains.size();
    };
    CHECK(chains(4) == 1);
    CHECK(chains(5) == 0);
}

TEST_CASE("rim: a chain with most of its points on walls is none") {
    RoundHole hole(12);
    hole.spokes();
    const auto onWall = [&](std::size_t count) {
        std::vector<std::uint8_t> type(12, kInterior);
        std::fill_n(type.begin(), count, kPositiveX);
        return hole.rim(type);
    };
    const Rim half = onWall(6);
    CHECK(half.chains.size() == 1);
    for (Index i = 0; i < 12; ++i) CHECK(half.gap[i].known() == (i >= 6));
    const Rim most = onWall(7);
    CHECK(most.chains.empty());
    CHECK(most.points() == 0);
}

TEST_CASE("rim: a point beside a chain joins it if its gap lies between two points of the chain") {
    // 12 lies behind the middle of the edge from 1 to 0, and sees the hole between them.
    RoundHole hole(12);
    const Index beside =
        hole.point(polar(15.0, RoundHole::radiusOf(12) * std::cos(kPi / 12) + 0.1));
    hole.join(beside, 0);
    hole.join(beside, 1);
    hole.join(beside, hole.point(polar(15.0, 3.0)));
    hole.spokes();
    const Rim rim = hole.rim();
    CHECK(rim.candidates == 13);
    REQUIRE(rim.chains.size() == 1);
    CHECK(rim.chains[0] == std::vector<Index>{0, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, beside});
    CHECK(rim.gap[beside] == RimGap{1, 0});
    CHECK(rim.gap[1] == RimGap{2, beside});
    CHECK(rim.gap[0] == RimGap{beside, 11});
}

TEST_CASE("rim: where a walk closes farther on, the points before are on no chain") {
    // 0 lies outside the hole; the end of its gap is point 0 of the hole.
    const Vec3 start = Vec3(RoundHole::radiusOf(12), 0, 0) + polar(60, 0.5);
    RoundHole hole(12, {start});
    hole.join(0, hole.around(0));
    hole.join(0, hole.point(start + polar(30, 0.5)));
    hole.spokes();
    const Rim rim = hole.rim();
    CHECK(rim.candidates == 13);
    REQUIRE(rim.chains.size() == 1);
    CHECK(rim.chains[0] == std::vector<Index>{1, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2});
    CHECK_FALSE(rim.gap[0].known());
}

TEST_CASE("rim: a walk goes on along the gap where it came from, not along a wider one behind") {
    // Behind point 4 there is a gap of 190 degrees; that of the hole has 140.
    RoundHole hole(9);
    hole.spokes(4);
    hole.spoke(4, 80.0);
    const Rim rim = hole.rim();
    REQUIRE(rim.chains.size() == 1);
    CHECK(rim.chains[0] == std::vector<Index>{0, 8, 7, 6, 5, 4, 3, 2, 1});
    CHECK(rim.gap[4] == RimGap{5, 3});
}
