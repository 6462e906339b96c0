// The most frequent queries: why a point, an edge or a triangle is missing.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/why/ledger.h"
#include "support/clouds.h"
#include "support/random_points.h"
#include "support/rig.h"
#include "support/shared_data.h"

using namespace se;
using namespace se::test;

namespace {

/// The missing things of one run, drawn by chance.
class Missing {
  public:
    Missing(const PointSet& points, const Params& params, std::uint64_t seed)
        : points_(points), random_(seed) {
        const Run run = runAll(points, params);
        std::vector<bool> used(points.size(), false);
        for (const Triangle& t : run.state.mesh()) {
            std::array<Index, 3> c{t.a, t.b, t.c};
            std::sort(c.begin(), c.end());
            triangles_.insert(c);
            for (const auto& [u, v] : {std::pair{c[0], c[1]}, {c[1], c[2]}, {c[0], c[2]}})
                edges_.insert({u, v});
            used[t.a] = used[t.b] = used[t.c] = true;
        }
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (!used[p]) unused_.push_back(static_cast<Index>(p));
        }
    }

    /// A random lost point; nothing if every point is used.
    std::optional<Subject> point() {
        if (unused_.empty()) return {};
        return Subject::point(unused_[random_.below(unused_.size())]);
    }
    std::optional<Subject> edge() {
        const Index a = any();
        const Index b = near(a);
        if (a == b || edges_.contains({std::min(a, b), std::max(a, b)})) return {};
        return Subject::edge(a, b);
    }
    std::optional<Subject> triangle() {
        const Index a = any();
        std::array<Index, 3> c{a, near(a), near(a)};
        std::sort(c.begin(), c.end());
        if (c[0] == c[1] || c[1] == c[2] || triangles_.contains(c)) return {};
        return Subject::triangle(c[2], c[0], c[1]);
    }

  private:
    Index any() { return static_cast<Index>(random_.below(points_.size())); }
    /// Usually a neighbor, as in most queries.
    Index near(Index p) {
        const auto list = points_.neighbors[p];
        return list.empty() || random_.below(6) == 0 ? any() : list[random_.below(list.size())];
    }

    const PointSet& points_;
    Random random_;
    std::set<std::array<Index, 3>> triangles_;
    std::set<std::pair<Index, Index>> edges_;
    std::vector<Index> unused_;
};

/// Checks the answer about `subject`. False without a subject.
bool answered(const PointSet& points, const Params& params, const std::optional<Subject>& subject) {
    if (!subject) return false;
    CAPTURE(nameOf(*subject));
    const auto ledger = why(points, params, *subject);
    REQUIRE(ledger.ok());
    const Ledger& found = ledger.value();
    CAPTURE(found.answer);
    CHECK_FALSE(found.present);
    REQUIRE(found.cause < found.lines.size());
    CHECK(found.lines[found.cause].role != LineRole::Made);
    CHECK(found.answer.find("nknown") == std::string::npos);
    CHECK(found.answer.ends_with("(" + toString(found.lines[found.cause].event.address) + ")"));
    return true;
}

struct Asked {
    std::size_t points = 0;
    std::size_t edges = 0;
    std::size_t triangles = 0;
};

void ask(const PointSet& points, const Params& params, std::uint64_t seed, std::size_t count,
         Asked& asked) {
    Missing missing(points, params, seed);
    for (std::size_t i = 0; i < count; ++i) {
        asked.points += answered(points, params, missing.point()) ? 1U : 0U;
        asked.edges += answered(points, params, missing.edge()) ? 1U : 0U;
        asked.triangles += answered(points, params, missing.triangle()) ? 1U : 0U;
    }
}

constexpr std::size_t kEach = kSanitized ? 50 : 1000;

}  // namespace

TEST_CASE(
    "ledger: 1,000 lost points, missing edges and triangles each were kept out by something") {
    Asked asked;
    std::uint64_t seed = 1;
    for (const FailureScene& each : failureScenes()) {
        CAPTURE(each.scene.id);
        ask(prepared(each.scene.build()), paper(), seed, kSanitized ? 2 : 15, asked);
        ++seed;
    }
    while (std::min({asked.points, asked.edges, asked.triangles}) < kEach) {
        CAPTURE(seed);
        const Params params = *paramsByName(seed % 3 == 0 ? "robust" : "paper");
        ask(randomPoints(seed), params, seed, 12, asked);
        REQUIRE(++seed < 4000);
    }
    MESSAGE(asked.points, " points, ", asked.edges, " edges, ", asked.triangles, " triangles");
}

TEST_CASE("ledger: so were those of the sets next to the checkout") {
    const std::filesystem::path folder = sharedFile("points");
    if (folder.empty()) return;
    Asked asked;
    for (const char* name : {"bunny_small", "fin90", "oni", "table1_electron_cloud"}) {
        CAPTURE(name);
        const auto file = sharedPoints(std::string("points/") + name + ".ply");
        if (!file) continue;
        ask(prepared(*file), paper(), 5, kSanitized ? 1 : 12, asked);
    }
    CHECK(asked.edges > 0);
}
