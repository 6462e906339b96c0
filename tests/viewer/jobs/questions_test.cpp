#include "jobs/questions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "commands/commands.h"
#include "contrast.h"
#include "document/ask_actions.h"
#include "document/ui_state.h"
#include "headless_app.h"
#include "layers/layer.h"
#include "panel_state/side_panels.h"
#include "rows/evidence_rows.h"
#include "scene/camera.h"
#include "scene/mesh_style.h"
#include "session/playback.h"
#include "session/view_position.h"
#include "spiraling_edge/why/proof.h"

using namespace se;
using namespace se::view;
using namespace se::view::test;

namespace {

/// The answer of the library.
Ledger expectedOf(const Session& session, const Subject& subject) {
    const Model& model = session.model();
    ProofScope scope;
    scope.alternatives = [&](const Progress&) -> Result<Alternatives> {
        return alternativesOf(*session.input().file(), session.input().spec(), model.points.judge);
    };
    return provedWhy(model.points, model.params, subject, scope).value();
}

struct QuestionApp {
    OpenSession open;
    AroundSession around{open.session};
    UiState& ui = around.ui;
    CommandContext& context = around.context;

    explicit QuestionApp(const char* scene = "scene:stranded-point") : open(scene) {}
    Session& session() { return open.session; }
    const Ledger* ledger() {
        open.session.waitUntilDone();
        return open.session.questions().why();
    }
    void run(const char* command) { runCommand(*findCommand(command), context); }
};

}  // namespace

TEST_CASE(
    "A point, an edge or a triangle can be typed, present or not, and mistakes are reported") {
    CHECK(selectionFromText("7", 10).value() == Selection::ofPoint(7));
    CHECK(selectionFromText(" 7,3 ", 10).value() == Selection::ofEdge(3, 7));
    CHECK(selectionFromText("edge 7-3", 10).value() == Selection::ofEdge(3, 7));
    CHECK(selectionFromText("(1, 2, 3)", 10).value() == Selection::ofTriangle({1, 2, 3}));
    for (const auto& [text, expected] : std::initializer_list<std::pair<const char*, const char*>>{
             {"", "812,640"},
             {"1 2 3 4", "812,640"},
             {"12", "the points are 0 to 9"},
             {"99999999999999", "the points are 0 to 9"},
             {"3,three", "\"three\""},
             {"3 3", "twice"}}) {
        CAPTURE(std::string(text));
        const auto read = selectionFromText(text, 10);
        REQUIRE_FALSE(read.ok());
        CHECK(read.error().message.find(expected) != std::string::npos);
    }
}

TEST_CASE("W queries the selection, and the answer is that of the library") {
    QuestionApp app;
    CHECK(app.ledger() == nullptr);
    app.session().select(32);
    app.run("ask.why");
    CHECK(app.ui.column.part == kLedgerPart);
    CHECK(app.session().questions().busy());
    const Ledger* ledger = app.ledger();
    REQUIRE(ledger != nullptr);
    const Ledger expected = expectedOf(app.session(), Subject::point(32));
    CHECK(ledger->answer == expected.answer);
    CHECK(ledger->lines.size() == expected.lines.size());
    CHECK(ledger->cause == expected.cause);
    CHECK_FALSE(ledger->present);
}

TEST_CASE("The answer about an edge and a triangle is that of the library, with its what-if") {
    QuestionApp app;
    for (const Selection& what : {Selection::ofEdge(32, 99), Selection::ofEdge(0, 1)}) {
        askWhy(app.context, what);
        const Ledger* ledger = app.ledger();
        REQUIRE(ledger != nullptr);
        const Ledger expected = expectedOf(app.session(), toSubject(what));
        CHECK(ledger->answer == expected.answer);
        CHECK(ledger->inversions == expected.inversions);
    }
}

TEST_CASE("A second question takes the place of the proof of the first") {
    QuestionApp app;
    askWhy(app.context, Selection::ofPoint(32));
    askWhy(app.context, Selection::ofEdge(0, 1));
    REQUIRE(app.ledger() != nullptr);
    CHECK(app.ledger()->name == "edge 0-1");
}

TEST_CASE("Without a selection W waits for input") {
    QuestionApp app;
    app.run("ask.why");
    CHECK(app.ui.column.part == kLedgerPart);
    CHECK(app.ui.typing.opened() == TypedField::Ledger);
    CHECK_FALSE(app.session().questions().busy());
}

TEST_CASE("An edge that is not present can be queried") {
    QuestionApp app("scene:sphere");
    const Index far = static_cast<Index>(app.session().model().points.size() - 1);
    askWhy(app.context, Selection::ofEdge(0, far));
    REQUIRE(app.ledger() != nullptr);
    CHECK_FALSE(app.ledger()->present);
    CHECK(app.session().selection() == Selection::ofEdge(0, far));
}

TEST_CASE("The lines are walked in both directions of time, from any cursor position") {
    QuestionApp app;
    askWhy(app.context, Selection::ofPoint(32));
    const Ledger ledger = *app.ledger();
    std::vector<std::string> forward;
    for (std::size_t i = 0; i < ledger.lines.size(); ++i) {
        app.run("ask.line.next");
        forward.push_back(app.open.place());
        CHECK(forward.back() == toString(ledger.lines[i].event.address));
        CHECK(positionAmong(ledger.lines, app.session()).here == i);
    }
    app.run("ask.line.next");
    CHECK(app.open.place() == forward.back());
    CHECK(app.session().messages().last() == "Nothing more happens to point 32.");
    app.session().moves().stepEvent(1);
    for (std::size_t i = ledger.lines.size(); i-- > 0;) {
        if (app.open.place() != forward.back() || i + 1 < ledger.lines.size())
            app.run("ask.line.previous");
        CHECK(app.open.place() == forward[i]);
    }
    app.run("ask.line.previous");
    CHECK(app.session().messages().last() == "Nothing happened to point 32 before.");
    app.run("ask.cause");
    CHECK(app.open.place() == toString(ledger.lines[ledger.cause].event.address));
}

TEST_CASE("Between two lines the cursor is before the next one") {
    QuestionApp app;
    askWhy(app.context, Selection::ofPoint(32));
    const Ledger ledger = *app.ledger();
    app.session().moves().toStart();
    app.session().waitUntilDone();
    CHECK(positionAmong(ledger.lines, app.session()).before == 0);
    CHECK_FALSE(positionAmong(ledger.lines, app.session()).here);
    app.session().moves().goToPivot(ledger.lines.back().event.address.pivot - 1);
    app.session().waitUntilDone();
    const LinePosition place = positionAmong(ledger.lines, app.session());
    CHECK_FALSE(place.here);
    CHECK(place.before > 0);
    CHECK(place.before < ledger.lines.size());
    CHECK(ledger.lines[place.before - 1].event.address.pivot <
          ledger.lines.back().event.address.pivot);
}

TEST_CASE("Another subject cancels the last query, another run discards all answers") {
    QuestionApp app;
    for (Index p = 0; p < 20; ++p) askWhy(app.context, Selection::ofPoint(p));
    REQUIRE(app.ledger() != nullptr);
    CHECK(app.ledger()->name == "point 19");
    askWhy(app.context, Selection::ofPoint(3));
    app.session().open(RunSpec{"scene:sphere"});
    app.session().waitUntilDone();
    CHECK(app.ledger() == nullptr);
    CHECK(app.session().questions().subject().kind == SelectionKind::None);
}

TEST_CASE("A query can be stopped, and repeated") {
    QuestionApp app;
    askWhy(app.context, Selection::ofPoint(32));
    app.session().questions().ledger().stop();
    CHECK(app.ledger() == nullptr);
    CHECK(app.session().questions().ledger().complaint() == "Stopped.");
    askWhy(app.context, Selection::ofPoint(32));
    CHECK(app.ledger() != nullptr);
}

TEST_CASE("The copied text has the answer, every address and a mark at the cause") {
    QuestionApp app;
    askWhy(app.context, Selection::ofPoint(32));
    const Ledger& ledger = *app.ledger();
    const std::string text = ledgerText(ledger.answer, ledger.lines, ledger.cause);
    CHECK(text.starts_with(ledger.answer));
    for (const LedgerLine& line : ledger.lines)
        CHECK(text.find(toString(line.event.address) + "  ") != std::string::npos);
    CHECK(text.find("> " + toString(ledger.lines[ledger.cause].event.address)) !=
          std::string::npos);
}

TEST_CASE("A query line finds what the library finds, and keys step through its decisions") {
    QuestionApp app;
    app.ui.query.typed = "stage=sphere refused";
    findTyped(app.context);
    app.session().waitUntilDone();
    const FoundDecisions* found = app.session().questions().found().answer();
    REQUIRE(found != nullptr);
    const Model& model = app.session().model();
    const DecisionQuery query = DecisionQuery::parse("stage=sphere refused").value();
    CHECK(found->total == findDecisions(model.points, model.params, query, 1).value().total);
    REQUIRE(found->total > 2);
    app.run("ask.hit.next");
    CHECK(app.open.place() == toString(found->lines[0].event.address));
    app.run("ask.hit.next");
    CHECK(app.open.place() == toString(found->lines[1].event.address));
    app.run("ask.hit.previous");
    app.run("ask.hit.previous");
    CHECK(app.open.place() == toString(found->lines[0].event.address));
    CHECK(app.session().messages().last() == "No earlier decision matches.");
}

TEST_CASE(
    "Where the list of hits ends before the run does, F3 says so, and which line has the rest") {
    QuestionApp app("scene:torus");
    REQUIRE(app.session().questions().find("at=1..99999").ok());
    app.session().waitUntilDone();
    const FoundDecisions* found = app.session().questions().found().answer();
    REQUIRE(found != nullptr);
    REQUIRE(found->lines.size() == Questions::kMaxFound);
    REQUIRE(found->total > found->lines.size());
    const Address last = found->lines.back().event.address;
    app.session().moves().goTo(last);
    app.session().waitUntilDone();
    app.run("ask.hit.next");
    app.session().waitUntilDone();
    CHECK(toString(app.session().address()) == toString(last));
    const std::string rest = "at=" + std::to_string(last.pivot) + ".." +
                             std::to_string(app.session().overview().lastPivot);
    CHECK(app.session().messages().last().find(rest) != std::string::npos);
    CHECK(DecisionQuery::parse(rest).ok());
    // Coming back from after the end of the list is no step to the previous one, and a message says
    // so.
    app.session().moves().toEnd();
    app.session().waitUntilDone();
    app.run("ask.hit.previous");
    app.session().waitUntilDone();
    CHECK(toString(app.session().address()) == toString(last));
    CHECK(app.session().messages().last().find(rest) != std::string::npos);
    // Within the list there is no message.
    app.session().messages().say("");
    app.run("ask.hit.previous");
    app.session().waitUntilDone();
    CHECK(app.session().messages().last().empty());
}

TEST_CASE("A line with a mistake starts no query, and the old results stay") {
    QuestionApp app;
    CHECK(app.session().questions().find("stage=split").ok());
    CHECK_FALSE(app.session().questions().find("stage=dragon").ok());
    CHECK(app.session().questions().line() == "stage=split");
    app.session().waitUntilDone();
    CHECK(app.session().questions().found().answer() != nullptr);
}

TEST_CASE("The last word of a line is completed by the terms that begin with it") {
    CHECK(termsFor("").size() == queryTerms().size());
    CHECK(termsFor("kept ").size() == queryTerms().size());
    REQUIRE(termsFor("kept mar").size() == 1);
    CHECK(termsFor("kept mar")[0]->form == "margin<X");
    CHECK(termsFor("kept margin<1e-4").size() == 1);
    CHECK(termsFor("xyz").size() == queryTerms().size());
    CHECK(completed("kept mar", *termsFor("mar")[0]) == "kept margin<");
    CHECK(completed("k", *termsFor("k")[0]) == "kept ");
    CHECK(completed("stage=sphere", *termsFor("mar")[0]) == "stage=sphere margin<");
}

TEST_CASE("Closest decisions and charts are queried once in a run, and are void in the next") {
    QuestionApp app;
    Questions& questions = app.session().questions();
    CHECK(questions.leastMargin().empty());
    questions.requestClosest();
    questions.requestCharts();
    app.session().waitUntilDone();
    REQUIRE(questions.closest().answer() != nullptr);
    REQUIRE(questions.charts().answer() != nullptr);
    const auto& lines = questions.closest().answer()->lines;
    REQUIRE(lines.size() > 10);
    for (std::size_t i = 1; i < lines.size(); ++i)
        CHECK(std::abs(lines[i - 1].reading->margin) <= std::abs(lines[i].reading->margin));
    CHECK(questions.leastMargin().size() == app.session().model().points.size());
    questions.requestClosest();
    CHECK_FALSE(questions.busy());
    app.session().open(RunSpec{"scene:sphere"});
    app.session().waitUntilDone();
    CHECK(questions.closest().answer() == nullptr);
    CHECK(questions.charts().answer() == nullptr);
}

TEST_CASE("A ring is queried by its address, or as the one at the cursor") {
    const Address here{25, Stage::Ring, 2};
    CHECK_FALSE(ringFromText("812", here).has_value());
    CHECK(ringFromText("ring", here)->value() == RingAddress{here, 0});
    CHECK(ringFromText(" ring #2", here)->value() == RingAddress{here, 2});
    CHECK(ringFromText("ring 30#1", here)->value() == RingAddress{{30, Stage::Pivot, 0}, 1});
    CHECK_FALSE(ringFromText("ring dragon", here)->ok());
    QuestionApp app;
    app.session().moves().goToPivot(25);
    app.session().waitUntilDone();
    app.ui.ledger.typed = "ring";
    askTyped(app.context);
    REQUIRE(app.ledger() != nullptr);
    CHECK(app.ledger()->name == "active ring at " + toString(app.session().address()));
    CHECK(toString(app.ledger()->lines.front().event.address) == "1.seed.1");
    CHECK(app.session().questions().subject().kind == SelectionKind::None);
}

TEST_CASE("Margins have steps by decades, the least contrasts most with the background") {
    CHECK(marginStep(0.0) == 0U);
    CHECK(marginStep(-9e-7) == 0U);
    CHECK(marginStep(1e-6) == 1U);
    CHECK(marginStep(-0.05) == 5U);
    CHECK(marginStep(3.0) == kMarginSteps - 1);
    CHECK_FALSE(marginStep(std::numeric_limits<double>::infinity()).has_value());
    CHECK(marginStepText(1) == "1e-6");
    CHECK(marginStepText(5) == "1e-2");
    CHECK(marginStepText(6) == "0.1");
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const Color& background = paletteOf(theme).background;
        for (std::size_t step = 1; step < kMarginSteps; ++step)
            CHECK(contrast(marginColor(step - 1, theme), background) >
                  contrast(marginColor(step, theme), background));
    }
}

TEST_CASE("A point keeps its shape when tinted, and gets its plain color back") {
    OpenSession open("scene:stranded-point");
    open.session.moves().goToPivot(40);
    open.session.waitUntilDone();
    open.session.questions().requestClosest();
    open.session.waitUntilDone();
    const std::span<const double> margins = open.session.questions().leastMargin();
    LayerInput in{open.session.model(), open.session.picture(), paletteOf(Theme::Dark)};
    DrawList list;
    addPoints(in, list);
    const DrawList plain = list;
    in.leastMargin = margins;
    in.tint = 1;
    addPoints(in, list);
    CHECK(list.marginTint);
    std::size_t tinted = 0;
    for (std::size_t p = 0; p < margins.size(); ++p) {
        const PointStyle& before = plain.cloudStyles.styles[plain.cloudStyleOf[p]];
        const PointStyle& after = list.cloudStyles.styles[list.cloudStyleOf[p]];
        CHECK(after.shape == before.shape);
        const auto step = marginStep(margins[p]);
        if (!step) continue;
        ++tinted;
        const Color wanted = marginColor(*step, Theme::Dark);
        CHECK(after.color.withAlpha(1.0F) == wanted.withAlpha(1.0F));
    }
    CHECK(tinted > 100);
    list.clear();
    in.leastMargin = {};
    in.tint = 0;
    addPoints(in, list);
    CHECK(list.cloudStyleOf == plain.cloudStyleOf);
    CHECK_FALSE(list.marginTint);
}

TEST_CASE("Repeats in a ledger are folded, but not the decisive line") {
    std::vector<LedgerLine> lines(10);
    for (std::uint32_t i = 0; i < 10; ++i) {
        lines[i].event.address = {i, Stage::Sort, 1};
        lines[i].role = i == 0 ? LineRole::Fact : LineRole::Refused;
    }
    const auto folded = [&](std::size_t cause) {
        std::vector<std::pair<std::size_t, std::size_t>> all;
        for (const LineFold& fold : foldsOf(lines, cause)) all.emplace_back(fold.first, fold.count);
        return all;
    };
    using Folds = std::vector<std::pair<std::size_t, std::size_t>>;
    // The first of them is a row of its own.
    CHECK(folded(9) == Folds{{2, 7}});
    // Two are no fold.
    CHECK(folded(4) == Folds{{5, 5}});
    lines[6].event.address.stage = Stage::Limits;
    CHECK(folded(9) == Folds{{2, 4}});
}
