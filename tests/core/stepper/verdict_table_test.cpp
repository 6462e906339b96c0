#include "spiraling_edge/stepper/verdict_table.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace se;

TEST_CASE("Verdicts: each has its own words") {
    std::set<std::string_view> texts;
    for (const VerdictRow& row : verdictTable()) {
        CHECK(!row.text.empty());
        CHECK_MESSAGE(texts.insert(row.text).second, row.text);
        CHECK(verdictText(row.id) == row.text);
    }
    CHECK(texts.size() == kVerdictCount);
}

TEST_CASE("Verdicts: a what-if turns what was taken into a drop, what was refused into a keep") {
    for (const VerdictRow& row : verdictTable()) {
        if (!row.inverse) continue;
        CAPTURE(row.text);
        CHECK(*row.inverse ==
              (row.outcome == Outcome::Taken ? WhatIfKind::Drop : WhatIfKind::Keep));
    }
}

TEST_CASE("6.1 Figure 4: the candidate that start or end moved to is not refused") {
    CHECK(rowOf(Verdict::NowStart).outcome == Outcome::None);
    CHECK(rowOf(Verdict::NowEnd).outcome == Outcome::None);
    CHECK(isAgainst(rowOf(Verdict::Outside).outcome));
}
