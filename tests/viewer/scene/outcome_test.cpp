#include "scene/outcome.h"

#include <doctest/doctest.h>

using namespace se;
using namespace se::view;

namespace {

std::optional<Color> colorOf(Stage stage, const Evidence& evidence) {
    return outcomeColor(paletteOf(Theme::Dark), {{1, stage, 1}, evidence});
}

}  // namespace

TEST_CASE("An event without an outcome has no color of one") {
    CHECK_FALSE(colorOf(Stage::Emit, EmitEvidence{0, {0, 1, 2}}));
    CHECK_FALSE(colorOf(Stage::Advance, AdvanceEvidence{1, 0, false}));
    CHECK_FALSE(colorOf(Stage::Flip, FlipEvidence{0, 1, 2, 3}));
    CHECK_FALSE(colorOf(Stage::Pivot, PivotEvidence{0, 1, 2, 3, 180.0}));
}

TEST_CASE("Kept, refused, moved and alarming things have a color each") {
    const Palette& c = paletteOf(Theme::Dark);
    CHECK(colorOf(Stage::TwoPoint, TwoPointEvidence{90.0, Verdict::Hole}) == c.used);
    CHECK(colorOf(Stage::TwoPoint, TwoPointEvidence{190.0, Verdict::Discarded}) == c.rejected);
    LimitEvidence limit{Side::Start, 1, 2, 0.1, 0.0, 20.0, Verdict::Moved};
    CHECK(colorOf(Stage::Limits, limit) == c.test);
    limit.verdict = Verdict::NotListed;
    CHECK(colorOf(Stage::Limits, limit) == c.textDim);
    CHECK(colorOf(Stage::Done, AlertEvidence{AlertKind::Hole, 3}) == c.rejected);
}
