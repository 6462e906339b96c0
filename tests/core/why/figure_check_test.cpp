#include "spiraling_edge/why/figure_check.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

std::string outcomeOfEvidence(const Evidence& evidence) {
    return outcomeText({{1, Stage::Ring, 1}, evidence});
}

}  // namespace

TEST_CASE("figure check: a decision comes to its verdict, a change to what is done") {
    CHECK(outcomeOfEvidence(TwoPointEvidence{200.0, Verdict::Discarded}) == "over 180");
    CHECK(outcomeOfEvidence(RingEvidence{4, true, 2}) == "enters, USED 2");
    CHECK(outcomeOfEvidence(RingEvidence{4, false, -1}) == "leaves, DONE");
    CHECK(outcomeOfEvidence(RingEvidence{4, false, 0}) == "leaves, UNUSED");
    CHECK(outcomeOfEvidence(EmitEvidence{0, {1, 2, 3}}) == "made");
    CHECK(outcomeOfEvidence(SkipEvidence{1, kPositiveX}) == "passed over");
    CHECK(outcomeOfEvidence(SplitEvidence{1, 4, 3, 1}) == "splits into 4 and 3");
    CHECK(outcomeOfEvidence(JoinEvidence{1, 0, 9}) == "joins, a ring of 9");
    CHECK(outcomeOfEvidence(CloseEvidence{1, 2}) == "closed");
    CHECK(outcomeOfEvidence(AdvanceEvidence{1, 0, false}) == "next pivot");
    CHECK(outcomeOfEvidence(SeedEvidence{1, 2, 1.0}) == "seed");
    CHECK(outcomeOfEvidence(StrandEvidence{1, true}) == "stranded");
    CHECK(outcomeOfEvidence(FreeEvidence{4, 0}) == "freed");
    CHECK(outcomeOfEvidence(FinishedEvidence{}).empty());
}

TEST_CASE("figure check: a figure holds only if its expectations do and its rule's absence shows") {
    Figure figure = *findFigure(6);
    CHECK(checkFigure(figure).holds());
    CHECK(checkFigure(figure).faultsWithout == 4);
    const FigureExpectation wrong[] = {{"1.reciprocal.1", "e", "kept"}};
    figure.expectations = wrong;
    CHECK_FALSE(checkFigure(figure).holds());
    CHECK(checkFigure(figure).expectations[0].found.starts_with("Seen from ring point e "));
    figure = *findFigure(6);
    figure.fault = FaultKind::Flipped;
    CHECK_FALSE(checkFigure(figure).holds());
    figure = *findFigure(6);
    figure.rule = {"onsphere", 1.0};
    CHECK(checkFigure(figure).brokenWithout == 0);
    CHECK_FALSE(checkFigure(figure).showsAbsence);
    CHECK_FALSE(checkFigure(figure).holds());
}

TEST_CASE("figure check: the figure's start replaces that of the params") {
    Params params = paper();
    params.start.done = {0};
    for (const CheckedExpectation& each : expectationsOf(*findFigure(6), params)) CHECK(each.holds);
    CHECK(withoutRule(*findFigure(6), paper()).paper.reciprocal == false);
}
