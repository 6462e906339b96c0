#include "spiraling_edge/run/watch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <map>
#include <string>

#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/clouds.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// Each term, those of a point about point 7.
std::vector<WatchExpression> everyExpression() {
    std::vector<WatchExpression> all;
    for (const WatchTerm& term : watchTerms()) {
        std::string text(term.form);
        if (text.ends_with("=N")) text = text.substr(0, text.size() - 1) + "7";
        const auto expression = WatchExpression::parse(text);
        REQUIRE(expression.ok());
        all.push_back(expression.value());
    }
    return all;
}

using Values = std::map<std::string, double>;

}  // namespace

TEST_CASE("watch: every number is that of the state after the pivot") {
    for (const char* id : {"torus", "sheet", "figure-11", "figure-14", "stranded-point"}) {
        CAPTURE(id);
        const PointSet points = prepared(findScene(id)->build());
        const Params params = withStartOf(*findScene(id), paper());
        const auto all = everyExpression();
        std::map<std::uint32_t, Values> watched;
        const auto add = [&](std::uint32_t pivot, std::span<const double> values) {
            for (std::size_t i = 0; i < all.size(); ++i)
                watched[pivot][std::string(all[i].term().form)] = values[i];
        };
        CHECK(sweep(points, params, watchVisitor(points, params, all, add)).has_value());
        REQUIRE(watched.contains(0));
        const State start = startState(points, params);
        CHECK(watched[0]["unused"] ==
              static_cast<double>(std::count(start.status.begin(), start.status.end(), kUnused)));
        CHECK(watched[0]["triangles"] == static_cast<double>(params.start.triangles.size()));
        double tests = 0;
        sweep(points, params, [&](const SweptPivot& pivot) {
            const State& s = pivot.after;
            Values& values = watched[pivot.events.front().address.pivot];
            std::map<int, double> count;
            for (const PointStatus status : s.status) ++count[std::clamp(status, -1, 1)];
            REQUIRE(values["used"] == count[1]);
            REQUIRE(values["unused"] == count[0]);
            REQUIRE(values["done"] == count[-1]);
            REQUIRE(values["status=N"] == s.status[7]);
            REQUIRE(values["triangles"] == static_cast<double>(s.triangles.size()));
            REQUIRE(values["stack"] == static_cast<double>(s.rings.stack().size()));
            REQUIRE(values["splits"] == s.counters.splits);
            const Index ring = s.rings.active();
            REQUIRE(values["ring"] == (ring == kNone ? 0.0 : s.rings.length(ring)));
            for (const Event& e : pivot.events) tests += outcomeOf(e) != Outcome::None ? 1 : 0;
            REQUIRE(values["tests"] == tests);
            REQUIRE(values["refused"] <= tests);
        });
        CHECK(tests > 40);
    }
}

TEST_CASE("watch: what cannot be watched is named, with what can") {
    for (const char* bad : {"dragons", "", "status", "status=", "status=x", "Ring"}) {
        CAPTURE(bad);
        const auto expression = WatchExpression::parse(bad);
        REQUIRE_FALSE(expression.ok());
        CHECK(expression.error().message.find(bad) != std::string::npos);
    }
    CHECK(WatchExpression::parse(" ring ").ok());
    CHECK(WatchExpression::parse("status=812").value().point() == 812);
}

TEST_CASE("watch: a point that there is not has the value 0") {
    const PointSet points = prepared(findScene("sphere")->build());
    const std::vector<WatchExpression> one{WatchExpression::parse("status=4000000").value()};
    double most = 0.0;
    const auto measure = [&](std::uint32_t, std::span<const double> values) {
        most = std::max(most, std::abs(values[0]));
    };
    const Params params = paper();
    sweep(points, params, watchVisitor(points, params, one, measure));
    CHECK(most == 0.0);
}
