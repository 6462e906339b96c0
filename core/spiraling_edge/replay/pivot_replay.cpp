#include "picture.h"

#include <algorithm>

#include "repair_diff.h"
#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/replay/reading.h"
#include "spiraling_edge/stepper/verdict_table.h"

namespace se::view {

namespace {

bool isRejection(Verdict verdict) { return rowOf(verdict).outcome == Outcome::Refused; }

/// Applies events to a picture, one after the other.
class Painter {
  public:
    explicit Painter(Picture& picture) : picture_(picture) {}

    void apply(const Event& event) {
        stage_ = event.address.stage;
        remember(event);
        std::visit([this](const auto& evidence) { on(evidence); }, event.evidence);
    }

  private:
    void remember(const Event& event) {
        auto& latest = picture_.latest;
        std::erase_if(latest,
                      [&](const Event& each) { return each.address.stage == event.address.stage; });
        latest.push_back(event);
    }
    void on(const SeedEvidence& e) {
        setStatus(e.first, 1);
        setStatus(e.second, 1);
    }
    void on(const StrandEvidence& e) { setStatus(e.point, kDone); }
    void on(const PivotEvidence& e) {
        picture_.pivot = e.pivot;
        picture_.first = picture_.start = e.first;
        picture_.last = picture_.end = e.last;
        picture_.sectorDegrees = picture_.endDegrees = e.sectorDegrees;
    }
    void on(const InsertEvidence& e) {
        if (e.verdict == Verdict::Before) {
            picture_.first = picture_.start = e.third;
        } else if (e.verdict == Verdict::After) {
            picture_.last = picture_.end = e.third;
        }
        if (e.third != kNone) setStatus(e.third, 1);
    }
    void on(const SortEvidence& e) { mark(e.point, e.degrees, e.verdict); }
    void on(const LimitEvidence& e) {
        if (!e.moves()) return;
        const bool start = e.side == Side::Start;
        (start ? picture_.start : picture_.end) = e.to;
        (start ? picture_.startDegrees : picture_.endDegrees) = e.toDegrees;
    }
    void on(const DropEvidence& e) {
        // Start and end have marks of their own.
        if (!e.isLimit()) mark(e.point, e.degrees, e.verdict);
    }
    void on(const ReciprocalEvidence& e) { mark(e.point, {}, e.verdict); }
    void on(const HoleEvidence& e) {
        picture_.hole = e;
        if (e.point != kNone) mark(e.point, {}, e.verdict);
    }
    void on(const SphereEvidence& e) { mark(e.q, {}, e.verdict); }
    void on(const GuardEvidence& e) {
        if (e.dropped != kNone && e.dropped != picture_.pivot) mark(e.dropped, {}, e.verdict);
    }
    void on(const FillEvidence& e) {
        picture_.pivot = e.pivot;
        picture_.first = picture_.start = e.first;
        picture_.last = picture_.end = e.last;
    }
    void on(const EmitEvidence& e) { picture_.newTriangles.push_back(e.corners); }
    void on(const RingEvidence& e) {
        picture_.ringChanges.push_back(e);
        setStatus(e.point, e.status);
    }
    void on(const AdvanceEvidence& e) { picture_.nextPivot = e.to; }
    template <typename Other>
    void on(const Other&) {}

    void setStatus(Index point, PointStatus status) {
        if (point < picture_.status.size()) picture_.status.set(point, status);
    }
    void mark(Index point, std::optional<double> degrees, Verdict verdict) {
        // Skipped before any test: never candidates.
        if (verdict == Verdict::AlreadyDone || verdict == Verdict::OnRingEnd) return;
        auto& list = picture_.candidates;
        auto found = std::find_if(list.begin(), list.end(),
                                  [&](const CandidateMark& each) { return each.point == point; });
        if (found == list.end()) found = list.insert(found, CandidateMark{point, 0.0});
        if (degrees) found->degrees = *degrees;
        found->verdict = verdict;
        found->stage = stage_;
        found->state = isRejection(verdict) ? CandidateState::Rejected : CandidateState::Kept;
    }

    Picture& picture_;
    Stage stage_ = Stage::Pivot;
};

/// The first event from which on the rings are those after the pivot.
std::size_t firstEventAfterRings(const std::vector<Event>& events) {
    const auto advance = std::find_if(events.begin(), events.end(), [](const Event& event) {
        return event.address.stage == Stage::Advance;
    });
    if (advance == events.end()) return events.size() - 1;
    return static_cast<std::size_t>(advance - events.begin());
}

/// §6.5 or §7: the ring loses or gets points.
bool updatesRings(const Event& event) {
    const Stage stage = event.address.stage;
    return stage == Stage::Ring || stage == Stage::Split || stage == Stage::Join ||
           stage == Stage::Done;
}

bool changesRings(const Event& event) {
    const Stage stage = event.address.stage;
    return updatesRings(event) || stage == Stage::Seed || stage == Stage::Insert;
}

/// A freed ring (§7) loses its points one by one, then an event reports it, and an alert may
/// follow: the ring shown is the one before the first of these.
void noteFreed(Picture& picture, const Event& event, const RingReplay& replay) {
    if (event.address.stage != Stage::Done) return;
    if (!picture.freed && std::holds_alternative<RingEvidence>(event.evidence)) {
        const std::vector<RingPath> rings = ringPaths(replay.rings());
        if (!rings.empty() && rings.front().active)
            picture.freed = ShownFreedRing{rings.front(), {}, {}};
    }
    if (!picture.freed) return;
    if (const auto* free = std::get_if<FreeEvidence>(&event.evidence))
        picture.freed->evidence = *free;
    if (const auto* alert = std::get_if<AlertEvidence>(&event.evidence)) {
        picture.freed->alert = alert->kind;
    }
}

/// The rings at events[cursor], entry by entry.
void addRings(Picture& picture, const PivotRecord& record, std::size_t cursor) {
    const std::vector<Event>& events = record.events;
    const auto end = events.begin() + static_cast<std::ptrdiff_t>(cursor) + 1;
    // Most decisions do not change the rings.
    if (std::any_of(events.begin(), end, changesRings)) {
        RingReplay replay(record.before.rings, record.before.status.size());
        for (auto event = events.begin(); event != end; ++event) {
            if (updatesRings(*event) && picture.oldRings.empty()) {
                picture.oldRings = ringPaths(replay.rings());
            }
            noteFreed(picture, *event, replay);
            replay.apply(*event);
        }
        picture.rings = ringPaths(replay.rings());
        picture.exchange = replay.exchange();
    }
    if (cursor >= firstEventAfterRings(events)) {
        picture.status = record.after.status;
        picture.rings = ringPaths(record.after.rings);
    }
}

/// Steps after the last pivot edit the mesh: each has one such event, which shows the new mesh.
/// Before that event, for example at a point that was stranded, the mesh is the old one.
void addRepaired(Picture& picture, const PivotRecord& record) {
    const bool repairs = std::any_of(picture.latest.begin(), picture.latest.end(),
                                     [](const Event& e) { return isRepair(e.address.stage); });
    if (!repairs || record.after.repaired == nullptr) return;
    picture.repaired = record.after.repaired;
    const auto& before = record.before.repaired ? record.before.repaired : record.unrepaired;
    if (before) {
        picture.newTriangles = freshTriangles(*before, *record.after.repaired);
        picture.goneTriangles = freshTriangles(*record.after.repaired, *before);
    }
    picture.finishedTriangles = picture.repaired->size() - picture.newTriangles.size();
}

Picture pictureBefore(const PivotRecord& record) {
    Picture picture;
    picture.status = record.before.status;
    picture.rings = ringPaths(record.before.rings);
    picture.finishedTriangles = record.before.triangleCount;
    picture.repaired = record.before.repaired;
    return picture;
}

}  // namespace

Picture makePictureBefore(const PivotRecord& record, std::size_t cursor) {
    return cursor == 0 ? pictureBefore(record) : makePicture(record, cursor - 1);
}

Picture makePicture(const PivotRecord& record, std::size_t cursor) {
    Picture picture = pictureBefore(record);
    if (record.events.empty()) return picture;
    cursor = std::min(cursor, record.events.size() - 1);
    Painter painter(picture);
    for (std::size_t i = 0; i <= cursor; ++i) painter.apply(record.events[i]);
    const Event& event = record.events[cursor];
    picture.event = event;
    picture.underTest = subjectOf(event);
    if (const auto* sphere = std::get_if<SphereEvidence>(&event.evidence)) picture.sphere = *sphere;
    if (event.address.stage != Stage::Hole) picture.hole.reset();
    picture.complete = cursor + 1 == record.events.size();
    addRepaired(picture, record);
    addRings(picture, record, cursor);
    return picture;
}

namespace {

/// The member `point` of most kinds of evidence; kNone of those without.
template <typename Kind>
Index pointOf(const Kind& evidence) {
    if constexpr (requires { evidence.point; }) return evidence.point;
    return kNone;
}

}  // namespace

Index subjectOf(const Event& event) {
    return std::visit(Overloaded{
                          [](const SeedEvidence& e) { return e.second; },
                          [](const InsertEvidence& e) { return e.third; },
                          [](const LimitEvidence& e) { return e.to; },
                          [](const SphereEvidence& e) { return e.q; },
                          [](const PivotEvidence& e) { return e.pivot; },
                          [](const SkipEvidence& e) { return e.pivot; },
                          [](const AdvanceEvidence& e) { return e.to; },
                          [](const GuardEvidence& e) { return e.dropped; },
                          [](const FillEvidence& e) { return e.pivot; },
                          [](const FlipEvidence& e) { return e.x; },
                          [](const CloseHoleEvidence& e) { return e.first; },
                          [](const RemeshEvidence& e) { return e.faulty.a; },
                          [](const auto& e) { return pointOf(e); },
                      },
                      event.evidence);
}

bool rejects(const Event& event) {
    const std::optional<Verdict> verdict = verdictOf(event);
    return verdict && isRejection(*verdict);
}

std::vector<Index> neighborhoodOf(const Picture& picture) {
    std::vector<Index> all;
    const auto add = [&](std::initializer_list<Index> points) {
        for (const Index point : points) {
            const bool known = std::find(all.begin(), all.end(), point) != all.end();
            if (point != kNone && !known) all.push_back(point);
        }
    };
    add({picture.pivot, picture.start, picture.end, picture.first, picture.last, picture.underTest,
         picture.nextPivot});
    for (const CandidateMark& mark : picture.candidates) {
        if (mark.state == CandidateState::Kept) add({mark.point});
    }
    for (const Triangle& t : picture.newTriangles) add({t.a, t.b, t.c});
    if (!picture.event) return all;
    // Points that an event names beside its subject.
    std::visit(Overloaded{
                   [&](const ReciprocalEvidence& e) {
                       add({e.pred, e.succ});
                   },
                   [&](const LimitEvidence& e) {
                       add({e.from, e.to});
                   },
                   [&](const SphereEvidence& e) {
                       add({e.s, e.t});
                   },
                   [](const auto&) {},
               },
               picture.event->evidence);
    return all;
}

}  // namespace se::view
