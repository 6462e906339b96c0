#include "picture.h"

#include <algorithm>
#include <array>
#include <set>

namespace se::view {

namespace {

template <typename... Ts>
struct Overloaded : Ts... {
    using Ts::operator()...;
};
template <typename... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

bool isRejection(Verdict verdict) {
    switch (verdict) {
        case Verdict::NotAfterStart:
        case Verdict::NotBeforeEnd:
        case Verdict::SameAngle:
        case Verdict::Outside:
        case Verdict::BehindConvex:
        case Verdict::NotReciprocal:
        case Verdict::FarSide:
        case Verdict::Removed:
        case Verdict::Discarded:
        case Verdict::WallComplete:
        case Verdict::WideGap:
        case Verdict::EdgeTaken:
        case Verdict::EntryMissed:
        case Verdict::Pillow:
        case Verdict::Crosses:
        case Verdict::AgainstNormal:
        case Verdict::FoldsOver:
        case Verdict::OverRim:
        case Verdict::Steep:
        case Verdict::Meets:
        case Verdict::OtherSideOpen:
        case Verdict::NoThirdPoint:
            return true;
        default:
            return false;
    }
}

RingPath pathFrom(const EdgeRings& rings, Index entry) {
    RingPath path;
    Index at = entry;
    do {
        path.points.push_back(rings.point(at));
        path.open.push_back(rings.open(at));
        at = rings.next(at);
    } while (at != entry);
    return path;
}

/// Applies events to a picture, one after the other.
class Painter {
  public:
    explicit Painter(Picture& picture) : picture_(picture) {}

    void apply(const Event& event) {
        stage_ = event.address.stage;
        const bool changesRings = stage_ == Stage::Ring || stage_ == Stage::Split ||
                                  stage_ == Stage::Join || stage_ == Stage::Done;
        if (changesRings && picture_.oldRings.empty()) picture_.oldRings = picture_.rings;
        remember(event);
        std::visit([this](const auto& evidence) { on(evidence); }, event.evidence);
    }

  private:
    void remember(const Event& event) {
        auto& latest = picture_.latest;
        const auto same = std::find_if(latest.begin(), latest.end(), [&](const Event& each) {
            return each.address.stage == event.address.stage;
        });
        same == latest.end() ? latest.push_back(event) : void(*same = event);
    }
    void on(const SeedEvidence& e) {
        RingPath path{{e.first, e.second}, {true, true}, true, 0, kNone};
        picture_.rings.insert(picture_.rings.begin(), std::move(path));
        setStatus(e.first, 1);
        setStatus(e.second, 1);
    }
    void on(const StrandEvidence& e) { setStatus(e.point, kDone); }
    void on(const PivotEvidence& e) {
        picture_.pivot = e.pivot;
        picture_.first = picture_.start = e.first;
        picture_.last = picture_.end = e.last;
        picture_.sectorDegrees = picture_.endDegrees = e.sectorDegrees;
        RingPath* ring = activeRing();
        if (ring == nullptr) return;
        for (std::size_t i = 0; i < ring->points.size(); ++i) {
            const std::size_t previous = i == 0 ? ring->points.size() - 1 : i - 1;
            if (ring->points[i] == e.pivot && ring->points[previous] == e.first) place_ = i;
        }
    }
    void on(const InsertEvidence& e) {
        if (e.verdict == Verdict::Before) {
            picture_.first = picture_.start = e.third;
            insertAt(place_, e.third);
            ++place_;
        } else if (e.verdict == Verdict::After) {
            picture_.last = picture_.end = e.third;
            insertAt(place_ + 1, e.third);
        }
    }
    void on(const SortEvidence& e) { mark(e.point, e.degrees, e.verdict); }
    void on(const LimitEvidence& e) {
        if (e.verdict != Verdict::Moved) return;
        const bool start = e.side == Side::Start;
        (start ? picture_.start : picture_.end) = e.to;
        (start ? picture_.startDegrees : picture_.endDegrees) = e.toDegrees;
    }
    void on(const DropEvidence& e) { mark(e.point, e.degrees, e.verdict); }
    void on(const ReciprocalEvidence& e) { mark(e.point, {}, e.verdict); }
    void on(const HoleEvidence& e) {
        picture_.hole = e;
        if (e.point != kNone) mark(e.point, {}, e.verdict);
    }
    void on(const SphereEvidence& e) { mark(e.q, {}, e.verdict); }
    void on(const GuardEvidence& e) {
        if (e.dropped != kNone) mark(e.dropped, {}, e.verdict);
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
        e.inserted ? insertAt(place_++, e.point) : removeNearPlace(e.point);
    }
    void on(const AdvanceEvidence& e) { picture_.nextPivot = e.to; }
    template <typename Other>
    void on(const Other&) {}

    RingPath* activeRing() {
        const bool any = !picture_.rings.empty() && picture_.rings.front().active;
        return any ? &picture_.rings.front() : nullptr;
    }
    void setStatus(Index point, PointStatus status) {
        if (point < picture_.status.size()) picture_.status.set(point, status);
    }
    void insertAt(std::size_t place, Index point) {
        RingPath* ring = activeRing();
        if (ring == nullptr) return;
        place = std::min(place, ring->points.size());
        ring->points.insert(ring->points.begin() + static_cast<std::ptrdiff_t>(place), point);
        ring->open.insert(ring->open.begin() + static_cast<std::ptrdiff_t>(place), false);
        setStatus(point, std::max(1, picture_.status[point]));
    }
    /// A point may stand on the ring twice: the entry meant is the one nearest to the pivot's
    /// place.
    void removeNearPlace(Index point) {
        RingPath* ring = activeRing();
        if (ring == nullptr) return;
        const std::size_t count = ring->points.size();
        std::size_t best = count;
        std::size_t bestDistance = count + 1;
        for (std::size_t i = 0; i < count; ++i) {
            if (ring->points[i] != point) continue;
            const std::size_t gap = i > place_ ? i - place_ : place_ - i;
            const std::size_t distance = std::min(gap, count - gap);
            if (distance < bestDistance) {
                best = i;
                bestDistance = distance;
            }
        }
        if (best == count) return;
        ring->points.erase(ring->points.begin() + static_cast<std::ptrdiff_t>(best));
        ring->open.erase(ring->open.begin() + static_cast<std::ptrdiff_t>(best));
        if (best < place_) --place_;
    }
    void mark(Index point, std::optional<double> degrees, Verdict verdict) {
        // Passed over before any test: never candidates.
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
    std::size_t place_ = 0;  ///< Of the pivot on the active ring.
};

/// The first event from which on the rings are those after the pivot.
std::size_t firstEventAfterRings(const std::vector<Event>& events) {
    std::size_t after = events.size() - 1;
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Stage stage = events[i].address.stage;
        if (stage == Stage::Split || stage == Stage::Join) after = i;
        if (stage == Stage::Advance) return std::min(after, i);
    }
    return after;
}

/// Triangles of `after` that `before` has not got, whichever corner comes first. The steps change a
/// few places of a long list, so only those are compared with each other.
std::vector<Triangle> freshTriangles(const std::vector<Triangle>& before,
                                     const std::vector<Triangle>& after) {
    const auto corners = [](const Triangle& t) {
        std::array<Index, 3> c = {t.a, t.b, t.c};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        return c;
    };
    const std::size_t common = std::min(before.size(), after.size());
    std::set<std::array<Index, 3>> old;
    std::vector<Triangle> fresh;
    for (std::size_t i = 0; i < common; ++i) {
        if (before[i] == after[i]) continue;
        old.insert(corners(before[i]));
        fresh.push_back(after[i]);
    }
    for (std::size_t i = common; i < before.size(); ++i) old.insert(corners(before[i]));
    for (std::size_t i = common; i < after.size(); ++i) fresh.push_back(after[i]);
    std::erase_if(fresh, [&](const Triangle& t) { return old.contains(corners(t)); });
    return fresh;
}

/// The steps after the last pivot edit the mesh: each has one event, and shows what it made.
void addMended(Picture& picture, const PivotRecord& record) {
    picture.mended = record.after.mended ? record.after.mended : record.before.mended;
    if (!picture.mended || record.after.mended == nullptr) return;
    const bool first = record.before.mended == nullptr;
    if (!first) picture.newTriangles = freshTriangles(*record.before.mended, *record.after.mended);
    picture.finishedTriangles = picture.mended->size() - picture.newTriangles.size();
}

}  // namespace

std::vector<RingPath> ringPaths(const RunState& state) {
    std::vector<RingPath> paths;
    const EdgeRings& rings = state.rings;
    if (rings.active() != kNone) {
        paths.push_back(pathFrom(rings, rings.head(rings.active())));
        paths.back().active = true;
        paths.back().id = rings.active();
    }
    for (std::size_t i = rings.stack().size(); i > 0; --i) {
        const Index ring = rings.stack()[i - 1];
        paths.push_back(pathFrom(rings, rings.head(ring)));
        paths.back().depth = static_cast<Index>(rings.stack().size() - i);
        paths.back().id = ring;
    }
    return paths;
}

namespace {

Picture pictureBefore(const PivotRecord& record) {
    Picture picture;
    picture.status = record.before.status;
    picture.rings = ringPaths(record.before);
    picture.finishedTriangles = record.before.triangleCount;
    picture.mended = record.before.mended;
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
    addMended(picture, record);
    if (cursor >= firstEventAfterRings(record.events)) {
        picture.status = record.after.status;
        picture.rings = ringPaths(record.after);
    }
    return picture;
}

Index subjectOf(const Event& event) {
    return std::visit(Overloaded{
                          [](const SeedEvidence& e) { return e.second; },
                          [](const StrandEvidence& e) { return e.point; },
                          [](const InsertEvidence& e) { return e.third; },
                          [](const SortEvidence& e) { return e.point; },
                          [](const LimitEvidence& e) { return e.to; },
                          [](const DropEvidence& e) { return e.point; },
                          [](const ReciprocalEvidence& e) { return e.point; },
                          [](const HoleEvidence& e) { return e.point; },
                          [](const SphereEvidence& e) { return e.q; },
                          [](const RingEvidence& e) { return e.point; },
                          [](const SplitEvidence& e) { return e.point; },
                          [](const JoinEvidence& e) { return e.point; },
                          [](const AlertEvidence& e) { return e.point; },
                          [](const PivotEvidence& e) { return e.pivot; },
                          [](const SkipEvidence& e) { return e.pivot; },
                          [](const AdvanceEvidence& e) { return e.to; },
                          [](const GuardEvidence& e) { return e.dropped; },
                          [](const FillEvidence& e) { return e.pivot; },
                          [](const ReinsertEvidence& e) { return e.point; },
                          [](const ReseatEvidence& e) { return e.point; },
                          [](const FlipEvidence& e) { return e.x; },
                          [](const auto&) { return kNone; },
                      },
                      event.evidence);
}

std::optional<Verdict> verdictOf(const Event& event) {
    return std::visit(
        [](const auto& e) -> std::optional<Verdict> {
            if constexpr (requires { e.verdict; }) return e.verdict;
            return std::nullopt;
        },
        event.evidence);
}

bool rejects(const Event& event) {
    const std::optional<Verdict> verdict = verdictOf(event);
    return verdict && isRejection(*verdict);
}

}  // namespace se::view
