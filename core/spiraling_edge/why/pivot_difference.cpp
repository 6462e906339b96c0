/// Comparison of two logs of one pivot. Facts (rings, triangles, the next pivot) must be equal in
/// order; tests are matched by stage and subject, since runs with other rules make other tests. The
/// first test with another result explains a difference; a test that only one run makes counts only
/// if it changed something. Equal logs are recognized in O(events); else O(events squared) for the
/// events of the pivot.
#include "spiraling_edge/why/pivot_difference.h"

#include <algorithm>
#include <array>
#include <vector>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/why/origin_decisions.h"

namespace se {
namespace {

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

}  // namespace

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

std::optional<Mismatch> firstOtherTest(std::span<const Event> a, std::span<const Event> b) {
    const bool alike =
        std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Event& x, const Event& y) {
            return x.address == y.address && keyOf(x) == keyOf(y) && resultOf(x) == resultOf(y);
        });
    if (alike) return {};  // most pivots, at once
    return PivotPair(a, b).otherTest();
}

Mismatch firstDifference(std::span<const Event> a, std::span<const Event> b) {
    const PivotPair pair(a, b);
    if (const auto test = pair.otherTest()) return pair.withLists(*test);
    if (const auto list = pair.otherList()) return *list;
    return pair.otherAction().value_or(Mismatch{});
}

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

}  // namespace se
