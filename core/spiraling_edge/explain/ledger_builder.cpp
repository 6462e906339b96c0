/// Selects the events about a subject: tests between its points, tests that end a fan it would have
/// been in, and facts about its points. For this it tracks which of its points may still become
/// spokes of the current fan.
#include "spiraling_edge/explain/ledger_builder.h"

#include <algorithm>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/replay/decision_line.h"

namespace se {
namespace {

std::size_t countIn(const Subject& subject, std::initializer_list<Index> points) {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](Index p) { return subject.has(p); }));
}

bool holds(const Triangle& t, const Subject& subject) {
    return countIn(subject, {t.a, t.b, t.c}) == subject.size();
}

}  // namespace

bool isInMesh(std::span<const Triangle> mesh, const Subject& subject) {
    return std::any_of(mesh.begin(), mesh.end(),
                       [&](const Triangle& t) { return holds(t, subject); });
}

void LedgerBook::add(const ScannedPivot& pivot) {
    alive_.reset();
    reciprocal_ = kNone;
    for (const Event& event : pivot.events) {
        follow(event);
        addEvent(pivot, event);
    }
}

/// Tracks the points of the subject that are still in the neighbor ring of this pivot.
void LedgerBook::follow(const Event& event) {
    const Subject& subject = ledger_.subject;
    const auto set = [&](Index p, bool on) {
        if (const std::size_t i = subject.find(p); i < subject.size()) alive_.set(i, on);
    };
    if (const auto* pivot = std::get_if<PivotEvidence>(&event.evidence)) {
        set(pivot->first, true);
        set(pivot->last, true);
        return;
    }
    // Points that limits move past stay spokes, and so do first and last, which are no candidates.
    const auto* sort = std::get_if<SortEvidence>(&event.evidence);
    const bool stays = std::holds_alternative<LimitEvidence>(event.evidence) ||
                       (sort != nullptr && sort->verdict == Verdict::OnRingEnd);
    const Outcome outcome = outcomeOf(event);
    if (stays || outcome == Outcome::None) return;
    // One entry of the point whose test passes is enough (§6.1, Fig. 6).
    const bool otherEntry = event.address.stage == Stage::Reciprocal && isAgainst(outcome) &&
                            reciprocal_ == testedPoint(event);
    if (otherEntry) return;
    if (event.address.stage == Stage::Reciprocal && outcome == Outcome::Taken)
        reciprocal_ = testedPoint(event);
    set(testedPoint(event), outcome == Outcome::Taken);
}

void LedgerBook::addEvent(const ScannedPivot& pivot, const Event& event) {
    if (mendsMesh(event) && !mending_) {
        mending_ = true;
        inMesh_ = isInMesh(pivot.after.triangles, ledger_.subject);
    }
    std::optional<LineRole> role = roleOf(pivot, event);
    if (mendsMesh(event)) {
        const bool now = isInMesh(pivot.after.mesh(), ledger_.subject);
        if (now != inMesh_) role = now ? LineRole::Made : LineRole::Undone;
        inMesh_ = now;
    }
    if (!role) return;
    ledger_.lines.push_back(
        {event, pivot.point, *role, readingOf(event, {points_, params_, pivot.point})});
}

bool LedgerBook::isFactOf(const Event& event) const {
    const Subject& subject = ledger_.subject;
    return std::visit(Overloaded{[&](const SeedEvidence& e) {
                                     return countIn(subject, {e.first, e.second}) > 0;
                                 },
                                 [&](const StrandEvidence& e) { return subject.has(e.point); },
                                 [&](const PivotEvidence& e) { return subject.has(e.pivot); },
                                 [&](const SkipEvidence& e) { return subject.has(e.pivot); },
                                 // The other side of the pivot would stay open (docs/robust.md).
                                 [&](const InsertEvidence& e) { return subject.has(e.pivot); },
                                 [&](const RingEvidence& e) { return subject.has(e.point); },
                                 [&](const SplitEvidence& e) { return subject.has(e.point); },
                                 [&](const JoinEvidence& e) { return subject.has(e.point); },
                                 [&](const CloseEvidence& e) {
                                     return countIn(subject, {e.a, e.b}) > 0;
                                 },
                                 [&](const FillEvidence& e) { return subject.has(e.pivot); },
                                 [&](const ReinsertEvidence& e) { return subject.has(e.point); },
                                 [&](const ReseatEvidence& e) { return subject.has(e.point); },
                                 [&](const FlipEvidence& e) {
                                     return countIn(subject, {e.u, e.v, e.x, e.y}) > 0;
                                 },
                                 [&](const EmitEvidence& e) {
                                     return countIn(subject,
                                                    {e.corners.a, e.corners.b, e.corners.c}) >=
                                            std::min<std::size_t>(2, subject.size());
                                 },
                                 [](const auto&) { return false; }},
                      event.evidence);
}

/// The role of a test between two points of the subject, or of its one point, or of a test that
/// ends their fan.
std::optional<LineRole> LedgerBook::roleOfTest(Index pivot, const Event& event) const {
    const Outcome outcome = outcomeOf(event);
    if (outcome == Outcome::None) return {};
    const Subject& subject = ledger_.subject;
    const LineRole role = outcome == Outcome::Taken ? LineRole::Taken : LineRole::Refused;
    const Index tested = testedPoint(event);
    if (subject.size() == 1) {
        if (tested == subject[0]) return role;
    } else if (subject.has(pivot) && subject.has(tested) && tested != pivot) {
        return role;
    }
    // The fan as a whole, which would have held the subject.
    const bool wholeFan = tested == kNone && (event.address.stage == Stage::TwoPoint ||
                                              event.address.stage == Stage::Guard);
    if (!wholeFan || !isAgainst(outcome)) return {};
    const std::size_t inFan = alive_.count() + (subject.has(pivot) ? 1U : 0U);
    const bool concerned = subject.size() == 1 ? alive_.any() : subject.has(pivot) && inFan >= 2;
    return concerned ? std::optional(role) : std::nullopt;
}

std::optional<LineRole> LedgerBook::roleOf(const ScannedPivot& pivot, const Event& event) const {
    if (const auto* emit = std::get_if<EmitEvidence>(&event.evidence)) {
        if (holds(emit->corners, ledger_.subject)) return LineRole::Made;
    }
    if (const auto role = roleOfTest(pivot.point, event)) return role;
    return isFactOf(event) ? std::optional(LineRole::Fact) : std::nullopt;
}

}  // namespace se
