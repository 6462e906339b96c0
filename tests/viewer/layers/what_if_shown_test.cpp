/// What a user sees of a decision that a what-if or a rule overrides: the verdict that was taken,
/// in the view, the dial, Inspect and Paper.
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "drawn.h"
#include "panel_state/settings.h"
#include "panel_state/what_if_offers.h"
#include "rows/evidence_rows.h"
#include "rows/paper_text.h"
#include "rows/pivot_dial.h"
#include "spiraling_edge/run/reading.h"
#include "spiraling_edge/run/timeline.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

/// The first what-if of each kind at each stage that the run offers.
std::vector<WhatIf> overridesOf(const Session& session) {
    std::map<std::pair<Stage, WhatIfKind>, WhatIf> found;
    EventLog log;
    Stepper stepper(session.model().points, session.model().params, &log);
    while (stepper.stepPivot()) {
        Index pivot = kNone;
        for (const Event& event : log.events()) {
            if (const auto* e = as<PivotEvidence>(event)) pivot = e->pivot;
            for (const WhatIfOffer& each : offersAt(event, pivot))
                found.try_emplace({each.what.stage, each.what.kind}, each.what);
            if (isA<EmitEvidence>(event) && pivot != kNone) {
                const WhatIf none{
                    WhatIfKind::Drop, event.address.pivot, Stage::Guard, pivot, {}, {}};
                found.try_emplace({Stage::Guard, WhatIfKind::Drop}, none);
            }
        }
        log.clear();
    }
    std::vector<WhatIf> list;
    for (const auto& [key, what] : found) list.push_back(what);
    return list;
}

/// The decision of the open run that a what-if set.
std::optional<Event> overriddenAt(const Session& session, const WhatIf& what) {
    Timeline timeline(session.model().points, session.model().params);
    const auto record = timeline.record(what.pivot);
    for (const Event& event : record->events) {
        const auto verdict = verdictOf(event);
        if (event.address.stage == what.stage && verdict && isWhatIf(*verdict)) return event;
    }
    return std::nullopt;
}

/// All layers that show a stage, at a decision of it.
DrawList layersAt(OpenSession& open, const Event& event) {
    open.session.moves().goTo(event.address);
    open.session.waitUntilDone();
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
    in.triangles = open.session.triangles();
    in.meshIndex = &open.session.meshIndex();
    DrawList list;
    fillDrawList(in, shownLayers(ViewSettings{}.layers, event.address.stage), list);
    return list;
}

std::string valueOf(const std::vector<EvidenceRow>& rows, const std::string& name) {
    for (const EvidenceRow& row : rows) {
        if (row.name == name) return row.value;
    }
    return {};
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

std::vector<EvidenceRow> inspected(const Session& session, const Event& event) {
    return evidenceRows({session.shown(), session.picture(), event, &session.overview()});
}

std::string linesOfPaper(const Event& event) {
    return paperRule(event.address.stage).code[presentLine(event)];
}

void checkView(const DrawList& list, bool kept, const std::string& words) {
    const Palette& colors = paletteOf(Theme::Dark);
    CHECK(says(list, words));
    for (const Label& label : list.labels) {
        if (has(label.text, words)) CHECK(label.color != (kept ? colors.rejected : colors.used));
    }
    for (const char* other : {"hole: filled", "lies inside"}) {
        if (!kept) CHECK_FALSE(says(list, other));
    }
    for (const char* other : {"overlap: dropped", "lies outside", "straight: removed", "refused"}) {
        if (kept) CHECK_FALSE(says(list, other));
    }
}

void checkPaper(const Event& event, bool kept, const std::string& words) {
    const std::string line = linesOfPaper(event);
    CAPTURE(line);
    CHECK(liveNumbers(event).starts_with(words));
    switch (event.address.stage) {
        case Stage::Sphere:
            CHECK(has(line, kept ? "keep q" : "remove q"));
            break;
        case Stage::TwoPoint:
            CHECK(has(line, kept ? "one triangle fills it" : "no triangle"));
            break;
        case Stage::Convex:
            CHECK(has(line, "drop") == !kept);
            break;
        case Stage::Guard:
            CHECK(has(line, "refuse") == !kept);
            CHECK_FALSE(has(line, "repeat 6.3"));
            break;
        case Stage::Limits:
            CHECK(has(line, "move start") == kept);
            break;
        default:
            break;
    }
}

}  // namespace

TEST_CASE("With a what-if everything shows the verdict that was taken") {
    std::set<std::pair<Stage, WhatIfKind>> seen;
    for (const auto& [source, rules] :
         {std::pair{"scene:torus", "paper"}, std::pair{"scene:linked-tori", "paper"},
          std::pair{"scene:genus-2", "robust"}}) {
        OpenSession open(source, rules);
        for (const WhatIf& what : overridesOf(open.session)) {
            if (!seen.insert({what.stage, what.kind}).second) continue;
            CAPTURE(source);
            CAPTURE(lineOf(what));
            open.session.rerun(withWhatIf(withSet({}, rules), what));
            open.session.waitUntilDone();
            const auto event = overriddenAt(open.session, what);
            REQUIRE(event.has_value());
            const Verdict verdict = *verdictOf(*event);
            const bool kept = isTaken(verdict);
            CHECK(kept == (what.kind == WhatIfKind::Keep));
            const std::string words(verdictText(verdict));
            checkView(layersAt(open, *event), kept, words);
            checkPaper(*event, kept, words);
            const auto rows = inspected(open.session, *event);
            CHECK(has(valueOf(rows, "decided by"), "what-if"));
            CHECK_FALSE(has(valueOf(rows, "so"), kept ? "dropped" : "filled"));
            const Dial dial = makeDial(open.session.shown().points, open.session.shown().params,
                                       open.session.picture());
            CHECK(has(dial.caption, words));
            if (dial.reciprocal) CHECK(dial.reciprocal->kept == kept);
            const ReadingContext context{open.session.model().points, open.session.model().params,
                                         open.session.picture().pivot};
            CHECK_FALSE(readingOf(*event, context).has_value());
        }
    }
    for (const Stage stage : {Stage::Limits, Stage::Reciprocal, Stage::Sphere}) {
        CHECK(seen.contains({stage, WhatIfKind::Keep}));
        CHECK(seen.contains({stage, WhatIfKind::Drop}));
    }
    CHECK(seen.contains({Stage::TwoPoint, WhatIfKind::Drop}));
    CHECK(seen.contains({Stage::Guard, WhatIfKind::Drop}));
    CHECK(seen.contains({Stage::Guard, WhatIfKind::Keep}));
    CHECK(seen.contains({Stage::Sort, WhatIfKind::Drop}));
}

TEST_CASE("A triangle over half a turn that a rule allows is not shown as a hole below it") {
    OpenSession open("scene:figure-9");
    open.session.rerun(withRule({}, "twopoint", 2.0));  // Off.
    open.session.waitUntilDone();
    const Address at = firstWhere<TwoPointEvidence>(open, [](const TwoPointEvidence& e) {
        return e.verdict == Verdict::Hole && e.degrees > 180.0;
    });
    REQUIRE(at.pivot > 0);
    open.session.moves().goTo(at);
    open.session.waitUntilDone();
    const Event event = *open.session.event();
    const DrawList list = layersAt(open, event);
    CHECK(says(list, "> 180"));
    CHECK_FALSE(says(list, "< 180"));
    CHECK_FALSE(says(list, "filled"));
    CHECK(has(valueOf(inspected(open.session, event), "so"), "anyway"));
}

TEST_CASE("Where its rule is off, a convex ring is not shown as concave") {
    OpenSession open("scene:torus");
    open.session.rerun(withRule({}, "concave", 0.0));
    open.session.waitUntilDone();
    const Address at = firstWhere<LimitEvidence>(
        open, [](const LimitEvidence& e) { return e.verdict == Verdict::Moved && e.turn < 0.0; });
    REQUIRE(at.pivot > 0);
    open.session.moves().goTo(at);
    open.session.waitUntilDone();
    CHECK(
        valueOf(inspected(open.session, *open.session.event()), "ring concave").starts_with("no"));
}
