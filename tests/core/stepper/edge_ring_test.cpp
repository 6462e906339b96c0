#include <doctest/doctest.h>

#include <algorithm>

#include "spiraling_edge/stepper/edge_ring.h"
#include "support/oracles.h"
#include "support/rig.h"

using namespace se;
using namespace se::test;

namespace {

/// A ring as a plain list of entries with their points and open marks, in order.
struct Item {
    Index entry, point;
    bool open;
};
using PlainRing = std::vector<Item>;

/// The model: rings as plain vectors. rings[0] is active if hasActive, `stack` from bottom to top.
struct Model {
    std::vector<PlainRing> rings;
    bool hasActive = false;

    std::pair<std::size_t, std::size_t> find(Index entry) const {
        for (std::size_t r = 0; r < rings.size(); ++r) {
            for (std::size_t i = 0; i < rings[r].size(); ++i) {
                if (rings[r][i].entry == entry) return {r, i};
            }
        }
        return {rings.size(), 0};
    }
    /// The ring turned so that `i` comes first.
    static PlainRing turned(PlainRing ring, std::size_t i) {
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring.end());
        return ring;
    }
};

bool same(const EdgeRings& rings, Index ring, const PlainRing& plain) {
    if (rings.length(ring) != plain.size()) return false;
    Index e = plain[0].entry;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        const Item& item = plain[i];
        if (e != item.entry || rings.point(e) != item.point || rings.open(e) != item.open ||
            rings.ringOf(e) != ring || rings.prev(rings.next(e)) != e) {
            return false;
        }
        e = rings.next(e);
    }
    return e == plain[0].entry;
}

/// Compares the rings with the model: order, marks, active ring, stack, chains of entries.
bool same(const EdgeRings& rings, const Model& model) {
    if ((rings.active() != kNone) != model.hasActive) return false;
    const std::size_t stacked = model.rings.size() - (model.hasActive ? 1 : 0);
    if (rings.stack().size() != stacked) return false;
    std::vector<Index> chain(rings.pointCount(), 0);
    for (std::size_t r = 0; r < model.rings.size(); ++r) {
        const bool active = model.hasActive && r == 0;
        const Index ring = rings.ringOf(model.rings[r][0].entry);
        if (active != (ring == rings.active())) return false;
        const std::size_t position = r - (model.hasActive ? 1 : 0);
        if (!active && rings.stack()[position] != ring) return false;
        if (!active && rings.depthFromTop(ring) != stacked - 1 - position) return false;
        if (!same(rings, ring, model.rings[r])) return false;
        for (const Item& item : model.rings[r]) ++chain[item.point];
    }
    for (Index p = 0; p < rings.pointCount(); ++p) {
        Index count = 0;
        for (Index e = rings.firstEntryOf(p); e != kNone; e = rings[e].nextOfPoint) {
            if (!rings.alive(e) || rings.point(e) != p) return false;
            ++count;
        }
        if (count != chain[p]) return false;
    }
    return true;
}

/// Makes one random change to both.
class Player {
  public:
    explicit Player(std::uint64_t seed) : random_(seed), rings_(kPoints) {}
    void step() {
        if (!model_.hasActive) {
            model_.rings.empty() || random_.below(3) == 0 ? start() : pop();
            return;
        }
        switch (random_.below(6)) {
            case 0:
            case 1:
                return insert();
            case 2:
                return erase();
            case 3:
            case 4:
                return exchange();
            default:
                return random_.below(4) == 0 ? push() : mark();
        }
    }
    bool agree() const { return same(rings_, model_); }

  private:
    static constexpr std::size_t kPoints = 7;

    Index anyPoint() { return static_cast<Index>(random_.below(kPoints)); }
    const Item& anyItem() {
        const PlainRing& ring = model_.rings[random_.below(model_.rings.size())];
        return ring[random_.below(ring.size())];
    }
    void start() {
        const Index p = anyPoint();
        const Index q = anyPoint();
        const Index e = rings_.start(p, q);
        model_.rings.insert(model_.rings.begin(), {{e, p, true}, {rings_.next(e), q, true}});
        model_.hasActive = true;
    }
    void pop() {
        const Index head = rings_.pop();
        CHECK(head != kNone);
        const PlainRing top = model_.rings.back();
        model_.rings.pop_back();
        model_.rings.insert(model_.rings.begin(), top);
        model_.hasActive = true;
        CHECK(model_.find(head).first == 0);
    }
    void push() {
        const Index head = model_.rings[0][random_.below(model_.rings[0].size())].entry;
        rings_.push(rings_.active(), head);
        CHECK(rings_.head(rings_.ringOf(head)) == head);
        model_.rings.push_back(model_.rings[0]);
        model_.rings.erase(model_.rings.begin());
        model_.hasActive = false;
    }
    void insert() {
        const Item at = anyItem();
        const Index p = anyPoint();
        const Index made = rings_.insertAfter(at.entry, p);
        const auto [r, i] = model_.find(at.entry);
        model_.rings[r].insert(model_.rings[r].begin() + static_cast<std::ptrdiff_t>(i) + 1,
                               {made, p, at.open});
    }
    void erase() {
        const Index entry = anyItem().entry;
        const auto [r, i] = model_.find(entry);
        rings_.erase(entry);
        CHECK_FALSE(rings_.alive(entry));
        PlainRing& ring = model_.rings[r];
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
        if (!ring.empty()) return;
        if (model_.hasActive && r == 0) model_.hasActive = false;
        model_.rings.erase(model_.rings.begin() + static_cast<std::ptrdiff_t>(r));
    }
    void mark() {
        const Index entry = anyItem().entry;
        const auto [r, i] = model_.find(entry);
        Item& item = model_.rings[r][i];
        item.open = !item.open;
        rings_.setOpen(entry, item.open);
    }
    void exchange() {
        const Index x = anyItem().entry;
        const Index y = anyItem().entry;
        if (x == y) return;
        const auto [rx, ix] = model_.find(x);
        const auto [ry, iy] = model_.find(y);
        const Exchange done = rings_.exchangeSuccessors(x, y);
        CHECK(done.split == (rx == ry));
        CHECK(done.ringOfX == rings_.ringOf(x));
        CHECK(done.ringOfY == rings_.ringOf(y));
        rx == ry ? splitModel(rx, ix, y, done) : joinModel(rx, ix, ry, iy, done);
    }
    /// x comes first: x a .. y b ..  becomes  x b ..  and  y a .. ; marks go with the successors.
    void splitModel(std::size_t r, std::size_t ix, Index y, const Exchange& done) {
        const PlainRing ring = Model::turned(model_.rings[r], ix);
        const auto at = std::find_if(ring.begin(), ring.end(),
                                     [&](const Item& item) { return item.entry == y; });
        PlainRing partY(ring.begin() + 1, at + 1);
        PlainRing partX(at + 1, ring.end());
        partX.insert(partX.begin(), {ring[0].entry, ring[0].point, at->open});
        partY.back().open = ring[0].open;
        // One part keeps the role of the ring; the other becomes the top of the stack.
        const Index keeper = rings_.active() != kNone && r == 0 && model_.hasActive
                                 ? rings_.active()
                                 : keptOnStack(r);
        const bool keepX = done.ringOfX == keeper;
        model_.rings[r] = keepX ? partX : partY;
        const PlainRing& other = keepX ? partY : partX;
        rings_.push(keepX ? done.ringOfY : done.ringOfX, other[0].entry);
        model_.rings.push_back(other);
    }
    Index keptOnStack(std::size_t r) const {
        return rings_.stack()[r - (model_.hasActive ? 1 : 0)];
    }
    void joinModel(std::size_t rx, std::size_t ix, std::size_t ry, std::size_t iy,
                   const Exchange& done) {
        CHECK(done.ringOfX == done.ringOfY);
        PlainRing joined = Model::turned(model_.rings[rx], (ix + 1) % model_.rings[rx].size());
        const PlainRing other = Model::turned(model_.rings[ry], (iy + 1) % model_.rings[ry].size());
        const bool openX = joined.back().open;  // x and y come last now.
        joined.back().open = other.back().open;
        joined.insert(joined.end(), other.begin(), other.end());
        joined.back().open = openX;
        const bool activeStays = model_.hasActive && (rx == 0 || ry == 0);
        // Two stacked rings: the longer one's place is kept; of equal ones, that of x.
        const std::size_t kept =
            activeStays ? 0 : (model_.rings[rx].size() >= model_.rings[ry].size() ? rx : ry);
        const std::size_t gone = kept == rx ? ry : rx;
        model_.rings[kept] = joined;
        model_.rings.erase(model_.rings.begin() + static_cast<std::ptrdiff_t>(gone));
    }

    Random random_;
    EdgeRings rings_;
    Model model_;
};

Points pointsFrom(const EdgeRings& rings, Index entry) {
    Points points;
    Index e = entry;
    do {
        points.push_back(rings.point(e));
        e = rings.next(e);
    } while (e != entry);
    return points;
}

}  // namespace

TEST_CASE("4 a new edge ring is two points, each the other's neighbor on both sides") {
    EdgeRings rings(9);
    const Index p = rings.start(4, 7);
    CHECK(pointsFrom(rings, p) == Points{4, 7});
    CHECK(rings.prev(p) == rings.next(p));
    CHECK(rings.open(p));
    CHECK(rings.open(rings.next(p)));
    CHECK(rings.length(rings.active()) == 2);
}

TEST_CASE("6.5 a point met again in the same ring splits it, and meeting again joins the parts") {
    EdgeRings rings(9);
    const Index a = rings.start(0, 1);
    const Index b = rings.insertAfter(rings.next(a), 2);
    const Index c = rings.insertAfter(b, 3);
    rings.insertAfter(c, 4);  // 0 1 2 3 4
    const Exchange split = rings.exchangeSuccessors(a, c);
    CHECK(split.split);
    CHECK(pointsFrom(rings, a) == Points{0, 4});
    CHECK(pointsFrom(rings, c) == Points{3, 1, 2});
    const Exchange join = rings.exchangeSuccessors(a, c);
    CHECK_FALSE(join.split);
    CHECK(pointsFrom(rings, a) == Points{0, 1, 2, 3, 4});
    CHECK(rings.length(rings.active()) == 5);
}

TEST_CASE("6.5 the most recently stacked ring comes off first") {
    EdgeRings rings(6);
    for (const Index p : {0U, 2U, 4U}) {
        const Index e = rings.start(p, p + 1);
        rings.push(rings.active(), e);
    }
    CHECK(rings.active() == kNone);
    for (const Index p : {4U, 2U, 0U}) {
        const Index head = rings.pop();
        CHECK(rings.point(head) == p);
        CHECK(rings.ringOf(head) == rings.active());
        rings.erase(rings.next(head));
        rings.erase(head);
        CHECK(rings.active() == kNone);
    }
    CHECK(rings.pop() == kNone);
}

TEST_CASE("edge rings agree with plain vectors through random operations") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        Player player(seed);
        bool agreed = true;
        for (int i = 0; i < 300 && agreed; ++i) {
            player.step();
            agreed = player.agree();
        }
        CHECK_MESSAGE(agreed, "seed ", seed);
    }
}

TEST_CASE("edge rings reuse what was freed") {
    EdgeRings rings(4);
    for (int round = 0; round < 50; ++round) {
        const Index e = rings.start(0, 1);
        const Index x = rings.insertAfter(e, 2);
        rings.exchangeSuccessors(e, x);
        rings.push(rings.ringOf(x) == rings.active() ? rings.ringOf(e) : rings.ringOf(x),
                   rings.ringOf(x) == rings.active() ? e : x);
        while (rings.active() != kNone || rings.pop() != kNone) {
            rings.erase(rings.head(rings.active()));
        }
    }
    CHECK(rings.entryCapacity() <= 3);
    CHECK(rings.ringCapacity() <= 2);
}

TEST_CASE("shelved rings stay at the bottom of the stack, and are not popped") {
    EdgeRings rings(8);
    const Index a = rings.start(0, 1);
    rings.shelve(a);
    CHECK(rings.active() == kNone);
    CHECK(rings.shelved() == 1);
    CHECK(rings.pop() == kNone);
    CHECK(rings.popOldest() == kNone);
    const Index b = rings.start(2, 3);
    rings.push(rings.ringOf(b), b);
    const Index c = rings.start(4, 5);
    rings.shelve(c);
    CHECK(rings.stack() == std::vector<Index>{rings.ringOf(a), rings.ringOf(c), rings.ringOf(b)});
    CHECK(rings.depthFromTop(rings.ringOf(c)) == 1);
    CHECK(rings.popOldest() == b);
    rings.push(rings.ringOf(b), b);
    CHECK(rings.pop() == b);
    CHECK(rings.pop() == kNone);
    rings.unshelve();
    CHECK(rings.shelved() == 0);
    rings.push(rings.ringOf(b), b);
    CHECK(rings.popOldest() == a);
}

TEST_CASE("a shelved ring that joins the active one leaves the shelf") {
    EdgeRings rings(8);
    const Index a = rings.start(0, 1);
    rings.shelve(a);
    const Index b = rings.start(2, 3);
    CHECK_FALSE(rings.exchangeSuccessors(a, b).split);
    CHECK(rings.shelved() == 0);
    CHECK(rings.stack().empty());
    CHECK(rings.length(rings.active()) == 4);
    CHECK(rings.withoutPoints().shelved() == 0);
}
