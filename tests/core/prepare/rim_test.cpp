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

TEST_CASE("rim: none on closed surfaces of any size, even or shaken") {
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
        {"mannequin_devil", 1, 80}, {"nefertiti", 1, 37},       {"three_peaks", 1, 141},
        {"blobs", 4, 65},           {"bunny", 5, 179},          {"armadillo", 0, 0},
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
