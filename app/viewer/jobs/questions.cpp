#include "questions.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <utility>

#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/run/event_text.h"
#include "thread.h"

namespace se::view {

std::vector<LineFold> foldsOf(std::span<const LedgerLine> lines, std::size_t cause) {
    constexpr std::size_t kLeast = 3;
    const auto repeats = [&](std::size_t i) {
        const Event& event = lines[i].event;
        const Event& before = lines[i - 1].event;
        return i != cause && lines[i].role == lines[i - 1].role &&
               event.address.stage == before.address.stage &&
               endingText(event) == endingText(before);
    };
    std::vector<LineFold> folds;
    for (std::size_t first = 1; first < lines.size();) {
        std::size_t end = first;
        while (end < lines.size() && repeats(end)) ++end;
        if (end - first >= kLeast) folds.push_back({first, end - first});
        first = std::max(end, first + 1);
    }
    return folds;
}

void Questions::open(std::shared_ptr<const Model> model, std::shared_ptr<const PointFile> file,
                     RunSpec spec) {
    model_ = std::move(model);
    file_ = std::move(file);
    spec_ = std::move(spec);
    spec_.neighbors.threads = 1;  // as trials prepare
    subject_ = {};
    failure_.reset();
    subjectName_.clear();
    line_.clear();
    forEach([](auto& query) { query.cancel(); });
}

bool Questions::poll() {
    bool news = false;
    forEach([&news](auto& query) { news = query.poll() || news; });
    if (const Ledger* answer = why(); news && answer != nullptr)
        folds_ = foldsOf(answer->lines, answer->cause);
    return news;
}

void Questions::waitUntilDone() {
    forEach([](auto& query) { query.waitUntilDone(); });
    poll();
}

bool Questions::busy() const {
    return ledger_.busy() || proof_.busy() || found_.busy() || closest_.busy() || charts_.busy();
}

void Questions::startProof(Proof proof) {
    proof_.cancel();
    // Without threads the window waits for the runs; on inputs of this size they take half a
    // second.
    constexpr std::size_t kMostAtOnce = 1500;
    if (!usesThreads() && model_->points.size() > kMostAtOnce) return;
    proof_.start([model = model_, file = file_, spec = spec_,
                  proof = std::move(proof)](const Progress& progress) {
        ProofScope scope;
        scope.alternatives = [&](const Progress&) -> Result<Alternatives> {
            return alternativesOf(*file, spec, model->points.judge);
        };
        return proof(*model, scope, progress);
    });
}

void Questions::askWhy(const Selection& what) {
    assert(model_ && what.kind != SelectionKind::None);
    subject_ = what;
    failure_.reset();
    subjectName_ = selectionText(what);
    again_ = [this, what] { askWhy(what); };
    ledger_.ask(model_, [what](const Model& model) {
        return whyQuestion(model.points, model.params, toSubject(what)).value();
    });
    startProof([what](const Model& model, const ProofScope& scope, const Progress& progress) {
        return provedWhy(model.points, model.params, toSubject(what), scope, progress);
    });
}

void Questions::askWhy(const RingAddress& ring) {
    assert(model_);
    subject_ = {};
    failure_.reset();
    subjectName_ = nameOf(ring);
    again_ = [this, ring] { askWhy(ring); };
    proof_.cancel();
    ledger_.start([model = model_, ring](const Progress& progress) -> Result<Ledger> {
        const Result<RingHistory> found = whyRing(model->points, model->params, ring, progress);
        if (!found) return found.error();
        return Ledger(found.value());
    });
}

void Questions::askWhy(const RunFailure& failure, std::vector<MeshFailure> known,
                       const Selection& standIn) {
    assert(model_);
    Ledger ledger = ledgerOf(failure);
    subject_ = standIn;
    failure_ = failure.failure;
    subjectName_ = ledger.name;
    again_ = [this, failure, known, standIn] { askWhy(failure, known, standIn); };
    if (isLostPoint(failure.failure))
        ledger_.ask(model_, [p = failure.failure.points.front()](const Model& model) {
            return whyQuestion(model.points, model.params, Subject::point(p)).value();
        });
    else
        ledger_.start(
            [ledger = std::move(ledger)](const Progress&) -> Result<Ledger> { return ledger; });
    startProof([failure, known = std::move(known)](const Model& model, const ProofScope& scope,
                                                   const Progress& progress) {
        return provedWhy(model.points, model.params, failure, known, scope, progress);
    });
}

void Questions::askAgain() {
    const std::function<void()> again = again_;  // It sets again_.
    again();
}

bool Questions::isAbout(const MeshFailure& failure) const {
    return failure_ && isSame(*failure_, failure) &&
           (ledger_.busy() || ledger_.answer() != nullptr);
}

Status Questions::find(const std::string& line) {
    Result<DecisionQuery> query = DecisionQuery::parse(line);
    if (!query) return query.error();
    assert(model_);
    line_ = line;
    found_.ask(model_, [query = query.value()](const Model& model) {
        return decisionsQuestion(model.points, model.params, query, kMaxFound);
    });
    return success();
}

namespace {

template <typename Answer>
bool isNew(const BackgroundQuery<Answer>& query) {
    return !query.busy() && query.answer() == nullptr && query.complaint().empty();
}

LedgerLine lineOf(const NearestDecision& decision) {
    const bool taken = outcomeOf(decision.event) == Outcome::Taken;
    return {decision.event, decision.pivot, taken ? LineRole::Taken : LineRole::Refused,
            decision.reading};
}

}  // namespace

void Questions::requestClosest() {
    assert(model_);
    if (!isNew(closest_)) return;
    closest_.ask(model_, [](const Model& model) -> Question<ClosestAnswer> {
        const auto nearest = nearestQuestion(model.points, model.params, kClosest);
        const auto answer = [nearest](const State& end) -> Result<ClosestAnswer> {
            ClosestAnswer closest{nearest.answer(end).value(), {}};
            for (const NearestDecision& decision : closest.decisions.decisions)
                closest.lines.push_back(lineOf(decision));
            return closest;
        };
        return {nearest.visit, answer};
    });
}

std::span<const double> Questions::leastMargin() const {
    const ClosestAnswer* answer = closest_.answer();
    return answer != nullptr ? std::span<const double>(answer->decisions.leastMargin)
                             : std::span<const double>{};
}

void Questions::requestCharts() {
    assert(model_);
    if (!isNew(charts_)) return;
    charts_.ask(model_, [](const Model&) { return chartsQuestion(); });
}

Subject toSubject(const Selection& what) {
    assert(what.kind != SelectionKind::None);
    const auto& p = what.points;
    if (what.kind == SelectionKind::Edge) return Subject::edge(p[0], p[1]);
    if (what.kind == SelectionKind::Triangle) return Subject::triangle(p[0], p[1], p[2]);
    return Subject::point(p[0]);
}

namespace {

constexpr const char* kExpected =
    "Expected one point, two for an edge or three for a triangle, such as 812 or 812,640.";

}  // namespace

Result<Selection> selectionFromText(std::string_view text, std::size_t count) {
    std::vector<Index> points;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" ,;-()"), text.size()));
        if (text.empty()) break;
        const std::string word(text.substr(0, text.find_first_of(" ,;-()")));
        text.remove_prefix(word.size());
        const bool named = word == "point" || word == "edge" || word == "triangle";
        if (named && points.empty()) continue;
        Index point = kNone;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), point);
        if (error == std::errc::invalid_argument || end != word.data() + word.size())
            return Error{inQuotes(word) + " is no point. " + kExpected};
        if (error != std::errc() || point >= count)
            return Error{"There is no point " + word + ": the points are 0 to " +
                         std::to_string(count - 1) + "."};
        if (std::find(points.begin(), points.end(), point) != points.end())
            return Error{"Point " + word + " is given twice."};
        points.push_back(point);
    }
    if (points.empty() || points.size() > 3) return Error{kExpected};
    return Selection::of(points);
}

std::optional<Result<RingAddress>> ringFromText(std::string_view text, const Address& here) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (!text.starts_with("ring")) return {};
    text.remove_prefix(4);
    std::string rest;
    std::copy_if(text.begin(), text.end(), std::back_inserter(rest),
                 [](char c) { return c != ' '; });
    if (rest.empty()) return Result<RingAddress>(RingAddress{here, 0});
    if (rest[0] == '#') rest = toString(here) + rest;
    return ringAddressFromString(rest);
}

}  // namespace se::view
