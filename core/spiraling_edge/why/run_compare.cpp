/// Two steppers side by side, one pivot at a time, each with a log of that pivot. Until the first
/// pivot with a different result both have the same state, so that comparing logs suffices;
/// afterwards both run on to their ends alone. The step that made each triangle is recorded on the
/// way, for differences of the final meshes. O(both runs).
///
/// Comparison of two logs of one pivot. Facts (rings, triangles, the next pivot) must be equal in
/// order; tests are matched by stage and subject, since runs with other rules make other tests. The
/// first test with another result explains a difference; a test that only one run makes counts only
/// if it changed something. Equal logs are recognized in O(events); else O(events squared) for the
/// events of the pivot.
#include "spiraling_edge/why/run_compare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/origin_decisions.h"

namespace se {
namespace {

// ---- two logs of one pivot ----------------------------------------------------------------------

/// Positions in the two lists of events; size() where there is no such event.
struct Mismatch {
    std::size_t a = 0;
    std::size_t b = 0;
    bool aDecides = false;  ///< False: `a` is the event there instead.
    bool bDecides = false;
    /// Only one of the runs tests the point, since only its list holds it.
    bool listsDiffer = false;
    /// The first point that only one of the lists has, and that it takes; kNone if there is none.
    Index onlyInA = kNone;
    Index onlyInB = kNone;
};

/// The subject of an event without its numbers: events with equal keys test the same.
using Key = std::array<Index, 6>;

Key keyOf(const Event& event) {
    const auto kind = static_cast<Index>(event.evidence.index());
    const auto key = [&](auto... ids) { return Key{kind, static_cast<Index>(ids)...}; };
    return std::visit(
        Overloaded{
            [&](const SeedEvidence& e) { return key(e.first, e.second); },
            [&](const PivotEvidence& e) { return key(e.pivot, e.first, e.last, e.ringLength); },
            [&](const SkipEvidence& e) { return key(e.pivot); },
            [&](const InsertEvidence& e) { return key(e.other); },
            [&](const LimitEvidence& e) { return key(e.side, e.from, e.to); },
            [&](const ReciprocalEvidence& e) { return key(e.point, e.pred, e.succ); },
            [&](const SphereEvidence& e) { return key(e.q); },
            [&](const TwoPointEvidence&) { return key(); },
            [&](const GuardEvidence& e) { return key(e.a, e.b, e.dropped); },
            [&](const FillEvidence& e) { return key(e.pivot, e.first, e.last); },
            [&](const DropPatchEvidence& e) { return key(e.point, e.triangles); },
            [&](const CloseHoleEvidence& e) { return key(e.first, e.second, e.length); },
            [&](const RemeshEvidence& e) { return key(e.faulty.a, e.faulty.b, e.faulty.c); },
            [&](const FlipEvidence& e) { return key(e.u, e.v, e.x, e.y); },
            [&](const EmitEvidence& e) {
                return key(e.triangle, e.corners.a, e.corners.b, e.corners.c);
            },
            [&](const RingEvidence& e) { return key(e.point, e.inserted, e.status); },
            [&](const SplitEvidence& e) {
                return key(e.point, e.activeLength, e.stackedLength, e.stackDepth);
            },
            [&](const JoinEvidence& e) { return key(e.point, e.depthFromTop, e.length); },
            [&](const CloseEvidence& e) { return key(e.a, e.b); },
            [&](const AdvanceEvidence& e) { return key(e.to, e.circuit, e.popped); },
            [&](const ShelveEvidence& e) { return key(e.length, e.shelved); },
            [&](const TakeUpEvidence& e) { return key(e.to, e.rings); },
            [&](const FreeEvidence& e) { return key(e.length, e.interior, e.seed); },
            [&](const ComponentEvidence& e) { return key(e.component, e.triangles); },
            [&](const AlertEvidence& e) { return key(e.kind, e.point); },
            [&](const FinishedEvidence& e) {
                return key(e.triangles, e.components, e.unused, e.loops);
            },
            [&](const auto& e) { return key(e.point); },
        },
        event.evidence);
}

/// The result of a test: equal results have the same consequence.
struct TestResult {
    Outcome outcome;      ///< None, Taken or Refused.
    Index third = kNone;  ///< §7: the inserted point and its place.
    Verdict place = Verdict::Kept;
    friend bool operator==(const TestResult&, const TestResult&) = default;
};
TestResult resultOf(const Event& event) {
    const Outcome outcome = isAgainst(outcomeOf(event)) ? Outcome::Refused : outcomeOf(event);
    if (const auto* insert = as<InsertEvidence>(event))
        return {outcome, insert->third, insert->verdict};
    return {outcome};
}

/// True for the test of a rule; other events are facts.
bool isTest(const Event& event) { return outcomeOf(event) != Outcome::None; }
bool isSort(const Event& event) { return isA<SortEvidence>(event); }

/// The events of one run at the pivot, in the order in which they are compared.
class PivotEvents {
  public:
    explicit PivotEvents(std::span<const Event> events) : events_(events) {
        // A rule that examines the whole fan sends the pivot back to §6.3: events after it are
        // compared as a pass of their own, stage by stage.
        std::uint32_t pass = 0;
        for (std::size_t i = 0; i < events.size(); ++i) {
            order_.push_back({pass, events[i].address.stage, i, keyOf(events[i])});
            if (isA<GuardEvidence>(events[i])) ++pass;
        }
        std::stable_sort(
            order_.begin(), order_.end(),
            [](const OrderedEvent& x, const OrderedEvent& y) { return x.rank() < y.rank(); });
    }

    struct OrderedEvent {
        std::uint32_t pass;
        Stage stage;
        std::size_t event;
        Key key;
        std::pair<std::uint32_t, Stage> rank() const { return {pass, stage}; }
        bool repeats(const OrderedEvent& o) const { return rank() == o.rank() && key == o.key; }
    };
    const std::vector<OrderedEvent>& order() const { return order_; }
    const Event& at(const OrderedEvent& place) const { return events_[place.event]; }
    bool sorts(Index point) const {
        return std::any_of(events_.begin(), events_.end(),
                           [&](const Event& e) { return isSort(e) && testedPoint(e) == point; });
    }
    bool sortsAny() const { return std::any_of(events_.begin(), events_.end(), isSort); }
    bool emits(Index point) const {
        return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
            const auto* emit = as<EmitEvidence>(e);
            return emit != nullptr && hasCorner(emit->corners, point);
        });
    }
    /// The same test at the same place of the order; null if this run does not make it.
    const OrderedEvent* counterpart(const OrderedEvent& place, const PivotEvents& from) const {
        std::size_t number = 0;  // a test may be repeated in a stage
        for (const OrderedEvent& p : from.order_) {
            if (p.event == place.event) break;
            if (p.repeats(place)) ++number;
        }
        for (const OrderedEvent& p : order_) {
            if (p.repeats(place) && number-- == 0) return &p;
        }
        return nullptr;
    }
    /// The last repetition of the test at that place of the order; null if there is none.
    const OrderedEvent* lastOf(const OrderedEvent& place) const {
        const auto found = std::find_if(order_.rbegin(), order_.rend(),
                                        [&](const OrderedEvent& p) { return p.repeats(place); });
        return found == order_.rend() ? nullptr : &*found;
    }
    /// The first event at or after `rank`, else the last event; 0 without events.
    std::size_t instead(const std::pair<std::uint32_t, Stage>& rank) const {
        for (const OrderedEvent& p : order_) {
            if (p.rank() >= rank) return p.event;
        }
        return order_.empty() ? 0 : order_.back().event;
    }

  private:
    std::span<const Event> events_;
    std::vector<OrderedEvent> order_;
};

/// Both runs at the pivot.
class PivotPair {
  public:
    PivotPair(std::span<const Event> a, std::span<const Event> b) : a_(a), b_(b) {}

    std::optional<Mismatch> otherTest() const {
        return firstWhere([&](const auto& mine, const auto& other, const auto& place) {
            return isTest(mine.at(place)) && differs(mine, other, place);
        });
    }
    std::optional<Mismatch> otherList() const {
        auto found = firstWhere([&](const auto& mine, const auto& other, const auto& place) {
            const Event& event = mine.at(place);
            return isSort(event) && onlyListed(mine, other, event) &&
                   mine.emits(testedPoint(event));
        });
        if (found) found->listsDiffer = true;
        return found;
    }
    std::optional<Mismatch> otherAction() const {
        return firstWhere([](const auto& mine, const auto& other, const auto& place) {
            return !isTest(mine.at(place)) && other.counterpart(place, mine) == nullptr;
        });
    }

    Mismatch withLists(Mismatch found) const {
        found.onlyInA = onlyListedPoint(a_, b_);
        found.onlyInB = onlyListedPoint(b_, a_);
        return found;
    }

  private:
    using OrderedEvent = PivotEvents::OrderedEvent;

    static Index onlyListedPoint(const PivotEvents& mine, const PivotEvents& other) {
        for (const OrderedEvent& place : mine.order()) {
            const Event& event = mine.at(place);
            if (isSort(event) && outcomeOf(event) == Outcome::Taken &&
                onlyListed(mine, other, event))
                return testedPoint(event);
        }
        return kNone;
    }

    /// True if only one of the lists has the tested point, and both runs read their lists.
    static bool onlyListed(const PivotEvents& mine, const PivotEvents& other, const Event& event) {
        const Index point = testedPoint(event);
        return point != kNone && mine.sorts(point) && other.sortsAny() && !other.sorts(point);
    }
    /// True if the other run has a different result, or does not make the test although it changes
    /// something.
    static bool differs(const PivotEvents& mine, const PivotEvents& other,
                        const OrderedEvent& place) {
        const Event& event = mine.at(place);
        if (const OrderedEvent* const there = other.counterpart(place, mine))
            return resultOf(other.at(*there)) != resultOf(event);
        if (onlyListed(mine, other, event)) return false;
        // Candidates stay unless refused; start, end and the ring stay unless moved.
        const bool changes = isA<LimitEvidence>(event) || isA<InsertEvidence>(event);
        return (outcomeOf(event) == Outcome::Taken) == changes;
    }

    /// The first place, of either run, where the condition holds.
    template <typename Condition>
    std::optional<Mismatch> firstWhere(const Condition& holds) const {
        const auto find = [&](const PivotEvents& mine, const PivotEvents& other) {
            return std::find_if(
                mine.order().begin(), mine.order().end(),
                [&](const OrderedEvent& place) { return holds(mine, other, place); });
        };
        const auto i = find(a_, b_);
        const auto j = find(b_, a_);
        const bool inA = i != a_.order().end();
        const bool inB = j != b_.order().end();
        if (!inA && !inB) return {};
        const bool takeA = inA && (!inB || i->rank() <= j->rank());
        if (takeA) return mismatchAt(a_, b_, *i);
        Mismatch found = mismatchAt(b_, a_, *j);
        std::swap(found.a, found.b);
        std::swap(found.aDecides, found.bDecides);
        return found;
    }
    static Mismatch mismatchAt(const PivotEvents& mine, const PivotEvents& other,
                               const OrderedEvent& place) {
        const OrderedEvent* there = other.counterpart(place, mine);
        // Repeated more often here: compared with the last result there.
        if (there == nullptr && isTest(mine.at(place))) there = other.lastOf(place);
        const bool decides =
            there != nullptr && resultOf(other.at(*there)) != resultOf(mine.at(place));
        if (decides) return {place.event, there->event, true, true, false};
        return {place.event, other.instead(place.rank()), true, false, false};
    }

    PivotEvents a_, b_;
};

std::string pointName(Index point) { return "point " + std::to_string(point); }

std::string testName(const Event& event, Index pivot) {
    std::string text(stageSection(event.address.stage));
    if (!text.empty()) text += ", ";
    text += stageName(event.address.stage);
    if (pivot != kNone) text += " at point " + std::to_string(pivot);
    return text;
}

std::string actionText(const Event& event) {
    const bool takes = outcomeOf(event) == Outcome::Taken;
    if (const auto* limit = as<LimitEvidence>(event)) {
        const std::string side = limit->side == Side::Start ? "start" : "end";
        return takes ? "moves " + side + " on to " + pointName(limit->to)
                     : "leaves " + side + " at " + pointName(limit->from);
    }
    if (const Index point = testedPoint(event); isTest(event) && point != kNone)
        return (takes ? "takes " : "refuses ") + pointName(point);
    if (isTest(event)) return takes ? "makes the triangle" : "makes no triangle";
    std::string text = describe(event);
    while (text.ends_with('.')) text.pop_back();
    return "goes on: \"" + text + "\"";
}

/// True if seeds, rings, triangles and the next pivot are the same; tests may differ.
bool sameResult(std::span<const Event> a, std::span<const Event> b) {
    const auto nextDeed = [](std::span<const Event> events, std::size_t i) {
        while (i < events.size() && isTest(events[i])) ++i;
        return i;
    };
    std::size_t i = 0;
    std::size_t j = 0;
    for (;; ++i, ++j) {
        i = nextDeed(a, i);
        j = nextDeed(b, j);
        if (i == a.size() || j == b.size()) return i == a.size() && j == b.size();
        if (keyOf(a[i]) != keyOf(b[j])) return false;
    }
}

/// The first test with different outcomes, in the order of the stages; nothing if there is none.
/// Points in the list of only one run do not count.
std::optional<Mismatch> firstOtherTest(std::span<const Event> a, std::span<const Event> b) {
    const bool alike =
        std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Event& x, const Event& y) {
            return x.address == y.address && keyOf(x) == keyOf(y) && resultOf(x) == resultOf(y);
        });
    if (alike) return {};  // most pivots, at once
    return PivotPair(a, b).otherTest();
}

/// The first difference of a pivot whose results differ: a test, or if none differs, the point that
/// only one run has in a list, or else the first different event.
Mismatch firstDifference(std::span<const Event> a, std::span<const Event> b) {
    const PivotPair pair(a, b);
    if (const auto test = pair.otherTest()) return pair.withLists(*test);
    if (const auto list = pair.otherList()) return *list;
    return pair.otherAction().value_or(Mismatch{});
}

/// One sentence about the mismatch. `pivot` is the pivot's point, kNone outside a pivot.
std::string wordsFor(const Mismatch& mismatch, std::span<const Event> a, std::span<const Event> b,
                     Index pivot) {
    if (mismatch.a >= a.size()) return "A is over, B goes on.";
    if (mismatch.b >= b.size()) return "B is over, A goes on.";
    const Event& inA = a[mismatch.a];
    const Event& inB = b[mismatch.b];
    const Event& asked = mismatch.aDecides ? inA : inB;
    const std::string place = testName(asked, pivot) + ": ";
    if (mismatch.listsDiffer) {
        return place + (mismatch.aDecides ? "A" : "B") + " lists " + pointName(testedPoint(asked)) +
               ", " + (mismatch.aDecides ? "B" : "A") + " does not.";
    }
    const char* const who = mismatch.aDecides ? "A " : "B ";
    const char* const other = mismatch.aDecides ? "B" : "A";
    const bool oneAsks = isTest(asked) && mismatch.aDecides != mismatch.bDecides;
    std::string text = oneAsks
                           ? place + who + actionText(asked) + ", " + other + " does not test it."
                           : place + "A " + actionText(inA) + ", B " + actionText(inB) + ".";
    if (mismatch.onlyInA != kNone)
        text += " Only A lists " + pointName(mismatch.onlyInA) + " here.";
    if (mismatch.onlyInB != kNone)
        text += " Only B lists " + pointName(mismatch.onlyInB) + " here.";
    return text;
}

// ---- two runs -----------------------------------------------------------------------------------

/// The corners of a triangle from the least one on, as a key.
std::array<Index, 3> cornersOf(const Triangle& t) {
    const Triangle s = fromLeastCorner(t);
    return {s.a, s.b, s.c};
}

/// Records the event that made each triangle while a run goes on.
class TriangleOrigins {
  public:
    void add(const Event& event) {
        if (const auto* emit = as<EmitEvidence>(event)) {
            emitted_.resize(emit->triangle);  // those of a given start: address 0
            emitted_.push_back(event.address);
        } else if (editsMesh(event)) {
            repairs_.push_back(event);
        }
    }
    MadeMesh take(State end) const {
        MadeMesh mesh;
        mesh.pivots = end.counters.pivots;
        if (end.repair.empty()) {
            mesh.triangles = std::move(end.triangles);
            mesh.made = emitted_;
            mesh.made.resize(mesh.triangles.size());
            return mesh;
        }
        std::map<std::array<Index, 3>, Address> byCorners;
        for (std::size_t i = 0; i < emitted_.size(); ++i)
            byCorners[cornersOf(end.triangles[i])] = emitted_[i];
        mesh.triangles = end.repair.triangles.take();
        for (const Triangle& t : mesh.triangles) {
            const auto found = byCorners.find(cornersOf(t));
            mesh.made.push_back(found != byCorners.end() ? found->second : repairOrigin(t));
        }
        mesh.emitted = std::move(end.triangles);
        return mesh;
    }

  private:
    /// The last step after the pivots that can have made this triangle.
    Address repairOrigin(const Triangle& t) const {
        const auto leaves = [&](const Event& event) {
            if (const auto* flip = as<FlipEvidence>(event))
                return hasCorner(t, flip->x) && hasCorner(t, flip->y);
            const auto* point = as<ReinsertEvidence>(event);
            return point != nullptr && hasCorner(t, point->point);
        };
        const auto fillsHole = [](const Event& event) {
            return isA<CloseHoleEvidence>(event) || isA<RemeshEvidence>(event);
        };
        auto found = std::find_if(repairs_.rbegin(), repairs_.rend(), leaves);
        // Other triangles fill a hole or the place of a fault; the events do not name them.
        if (found == repairs_.rend())
            found = std::find_if(repairs_.rbegin(), repairs_.rend(), fillsHole);
        return found != repairs_.rend() ? found->address : Address{};
    }

    std::vector<Address> emitted_;
    std::vector<Event> repairs_;
};

/// One of the two runs, a pivot at a time.
class Walker {
  public:
    explicit Walker(const ComparedRun& run) : run_(run), stepper_(run.points, run.params, &log_) {}
    Walker(const Walker&) = delete;
    Walker& operator=(const Walker&) = delete;

    void step() {
        log_.clear();
        if (over_) return;
        over_ = !stepper_.stepPivot();
        for (const Event& event : log_.events()) origins_.add(event);
    }
    bool over() const { return over_; }
    std::span<const Event> events() const { return log_.events(); }
    Index pivot() const { return pivotPoint(log_.events()); }
    DifferenceSide side(std::size_t event, bool decides) const {
        if (event >= log_.events().size()) return {false, {}};
        return {decides, lineOf(log_.events()[event], {run_.points, run_.params, pivot()})};
    }
    double share() const {
        const auto all = static_cast<double>(std::max<std::size_t>(run_.points.size(), 1));
        return over_ ? 1.0 : static_cast<double>(stepper_.state().done.size()) / all;
    }
    MadeMesh take() { return origins_.take(stepper_.takeState()); }

  private:
    ComparedRun run_;
    EventLog log_;
    Stepper stepper_;
    TriangleOrigins origins_;
    bool over_ = false;
};

RunDifference differenceAt(const Mismatch& mismatch, const Walker& a, const Walker& b) {
    const Index pivot = a.pivot() != kNone ? a.pivot() : b.pivot();
    return {a.side(mismatch.a, mismatch.aDecides), b.side(mismatch.b, mismatch.bDecides),
            wordsFor(mismatch, a.events(), b.events(), pivot)};
}

/// Compares the pivot that both have just completed.
void comparePivot(const Walker& a, const Walker& b, RunComparison& found) {
    if (!sameResult(a.events(), b.events())) {
        found.first = differenceAt(firstDifference(a.events(), b.events()), a, b);
        return;
    }
    if (const auto other = firstOtherTest(a.events(), b.events())) {
        if (found.harmlessPivots++ == 0) found.harmless = differenceAt(*other, a, b);
    }
    if (!a.over() && !b.over()) ++found.commonPivots;
}

}  // namespace

std::optional<Address> firstMade(const MadeMesh& mesh, std::span<const Index> triangles) {
    std::optional<Address> first;
    for (const Index t : triangles) {
        if (t >= mesh.made.size() || mesh.made[t].pivot == 0) continue;
        const Address& made = mesh.made[t];
        if (!first || std::pair(made.pivot, made.n) < std::pair(first->pivot, first->n))
            first = made;
    }
    return first;
}

Result<MadeMesh> makeMesh(const ComparedRun& run, const Progress& progress) {
    Walker walker(run);
    for (std::uint32_t count = 0; !walker.over(); ++count) {
        walker.step();
        if (count % kPivotsPerReport == 0 && progress && !progress(walker.share()))
            return Error{"Cancelled."};
    }
    return walker.take();
}

Result<RunComparison> compareRuns(const ComparedRun& a, const ComparedRun& b,
                                  const Progress& progress) {
    if (a.points.size() != b.points.size()) {
        return Error{"The runs have not the same points: A has " + std::to_string(a.points.size()) +
                     ", B has " + std::to_string(b.points.size()) + "."};
    }
    assert(validate(a.points).ok() && validate(b.points).ok());
    RunComparison found;
    Walker left(a);
    Walker right(b);
    for (std::uint32_t count = 0; !left.over() || !right.over(); ++count) {
        left.step();
        right.step();
        if (!found.first) comparePivot(left, right, found);
        if (count % kPivotsPerReport == 0 && progress &&
            !progress((left.share() + right.share()) / 2.0))
            return Error{"Cancelled."};
    }
    found.a = left.take();
    found.b = right.take();
    return found;
}

}  // namespace se
