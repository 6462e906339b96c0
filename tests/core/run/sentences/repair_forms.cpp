/// Beyond the paper: the sentences of the steps after the last pivot, by the triangles before and
/// after each.
#include <set>

#include "core/run/sentences/claim.h"

namespace se::test::sentences {
namespace {

using Triangles = std::vector<Triangle>;

/// Triangles of one list that another lacks, whichever corner comes first.
Triangles without(const Triangles& list, const Triangles& other) {
    const auto key = [](const Triangle& t) {
        std::array<Index, 3> c{t.a, t.b, t.c};
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        return c;
    };
    std::multiset<std::array<Index, 3>> all;
    for (const Triangle& t : other) all.insert(key(t));
    Triangles rest;
    for (const Triangle& t : list) {
        const auto found = all.find(key(t));
        if (found == all.end())
            rest.push_back(t);
        else
            all.erase(found);
    }
    return rest;
}
Triangles gone(const C& c) { return without(c.w.meshWas, c.w.state.mesh()); }
bool has(const Triangle& t, Index x) { return t.a == x || t.b == x || t.c == x; }
std::size_t countAt(const Triangles& mesh, Index x) {
    return static_cast<std::size_t>(
        std::count_if(mesh.begin(), mesh.end(), [&](const Triangle& t) { return has(t, x); }));
}
/// The triangles that are connected by edges to one, through `x` alone unless it is kNone.
std::set<Index> patchAt(const C& c, Index t, Index x) {
    std::set<Index> patch{t};
    std::vector<Index> next{t};
    while (!next.empty()) {
        const Triangle s = c.w.meshWas[next.back()];
        next.pop_back();
        for (const auto& [u, v] : {std::pair{s.a, s.b}, {s.b, s.c}, {s.c, s.a}}) {
            const Index other = c.w.triangleWith(v, u);
            if (other == kNone || (x != kNone && u != x && v != x)) continue;
            if (patch.insert(other).second) next.push_back(other);
        }
    }
    return patch;
}

int conflicts(const C& c, const Triangles& mesh, const Triangle& t) {
    int count = 0;
    for (const Triangle& other : mesh) {
        const bool self = has(other, t.a) && has(other, t.b) && has(other, t.c);
        count += !self && c.w.inConflict(t, other) ? 1 : 0;
    }
    return count;
}
/// A fault as the steps after the last pivot repair it.
void isFaulty(C& c, std::size_t i) {
    const Triangle t{c.point(i), c.point(i + 1), c.point(i + 2)};
    c.need(c.w.triangleWith(t.a, t.b) != kNone &&
               c.w.triangleWith(t.a, t.b) == c.w.triangleWith(t.b, t.c),
           "triangle");
    c.need(c.w.shapeFault(t) >= 4 || conflicts(c, c.w.meshWas, t) > 0, "a fault");
}

void dropsPatch(C& c) {
    const Triangles list = gone(c);
    c.need(counts(c, 0, list.size(), "triangle") && countAt(list, c.point(1)) > 0, "taken out");
    const Index t = c.w.at[c.point(1)].empty() ? kNone : c.w.at[c.point(1)].front();
    if (t == kNone || !c.wrong.empty()) return;
    const std::set<Index> patch = patchAt(c, t, kNone);
    c.need(patch.size() == list.size(), "a component");
    bool beside = false;
    for (const Index each : patch) {
        const Triangle& s = c.w.meshWas[each];
        for (const Index x : {s.a, s.b, s.c}) {
            for (const Index q : c.w.points.neighbors[x]) {
                beside = beside || (!c.w.at[q].empty() &&
                                    patchAt(c, c.w.at[q].front(), kNone).size() > patch.size());
            }
        }
    }
    c.need(beside, "beside a larger one");
}
void dropsFans(C& c) {
    const Index x = c.point(0);
    std::size_t largest = 0;
    for (const Index t : c.w.at[x]) largest = std::max(largest, patchAt(c, t, x).size());
    c.need(counts(c, 1, largest, "triangle"), "its fan");
    c.need(countAt(c.w.state.mesh(), x) == largest, "keeps it");
    c.need(counts(c, 2, gone(c).size(), "triangle"), "taken out");
}
void putsIn(C& c, bool beside) {
    const Index x = c.point(0);
    c.need(c.w.at[x].empty() && countAt(c.w.state.mesh(), x) > 0, "stranded, put in");
    c.need(beside ? gone(c).empty() : counts(c, 1, gone(c).size(), "triangle"), "in place of");
}
void fillsHole(C& c) {
    const Witness& w = c.w;
    const Index u = c.point(1);
    const Index v = c.point(2);
    const auto isBorder = [&](Index a, Index b) {
        return w.triangleWith(a, b) != kNone && w.triangleWith(b, a) == kNone;
    };
    c.need(isBorder(u, v), "a side of the hole");
    Index length = 1;
    for (Index x = v; x != u && length <= c.count(0); ++length) {
        Index next = kNone;
        for (const Index t : w.at[x]) {
            const Triangle& s = w.meshWas[t];
            for (const Index y : {s.a, s.b, s.c}) {
                if (y == x || !isBorder(x, y)) continue;
                if (next != kNone && next != y) return;  // Two gaps meet here.
                next = y;
            }
        }
        c.need(next != kNone, "a loop");
        if (next == kNone) return;
        x = next;
    }
    c.need(length == c.count(0), "points");
    const auto& mesh = w.state.mesh();
    const bool open = std::any_of(mesh.begin(), mesh.end(),
                                  [&](const Triangle& t) { return has(t, u) && has(t, v); }) &&
                      gone(c).empty() && countAt(mesh, u) == w.at[u].size();
    c.need(!open, "filled");
}
/// The faults of two triangles at an edge, with their neighbors and all that they are in conflict
/// with.
int faultsOf(const C& c, const Triangles& mesh, const std::array<Triangle, 2>& two) {
    int sum = 0;
    const auto fold = [&](const Triangle& a, const Triangle& b) {
        return between(areaOf(c.w.corners(a)), areaOf(c.w.corners(b))) > 170 ? 2 : 0;
    };
    for (const Triangle& t : two) {
        sum += c.w.shapeFault(t) + conflicts(c, mesh, t);
        for (const Triangle& s : mesh) {
            const int shared = has(s, t.a) + has(s, t.b) + has(s, t.c);
            const bool other = has(s, two[0].a) && has(s, two[0].b) && has(s, two[0].c);
            const bool mine = has(s, two[1].a) && has(s, two[1].b) && has(s, two[1].c);
            if (shared == 2 && !other && !mine) sum += fold(t, s);
        }
    }
    return sum + fold(two[0], two[1]);
}
void flips(C& c) {
    const Index u = c.point(0);
    const Index v = c.point(1);
    const Index x = c.point(2);
    const Index y = c.point(3);
    const std::array<Triangle, 2> before{Triangle{u, v, x}, {v, u, y}};
    const std::array<Triangle, 2> after{Triangle{u, y, x}, {y, v, x}};
    const Triangles list(before.begin(), before.end());
    c.need(without(list, c.w.meshWas).empty(), "edge before");
    c.need(without({after.begin(), after.end()}, c.w.state.mesh()).empty(), "edge after");
    const auto least = [&](const std::array<Triangle, 2>& two) {
        return std::min(leastAngle(c.w.corners(two[0])), leastAngle(c.w.corners(two[1])));
    };
    if (c.word(4) == "its least angle") return c.need(least(after) > least(before), "least angle");
    c.need(c.word(4) == "fewer faults there", "measure");
    // In the whole mesh or, where a pair farther away is at the limit of a conflict, at the points.
    const auto atPoints = [&](const Triangles& mesh) {
        Triangles at;
        std::copy_if(mesh.begin(), mesh.end(), std::back_inserter(at), [&](const Triangle& t) {
            return has(t, u) || has(t, v) || has(t, x) || has(t, y);
        });
        return at;
    };
    const Triangles& now = c.w.state.mesh();
    const Triangles& was = c.w.meshWas;
    c.need(faultsOf(c, now, after) < faultsOf(c, was, before) ||
               faultsOf(c, atPoints(now), after) < faultsOf(c, atPoints(was), before),
           "fewer faults");
}
void remeshes(C& c) {
    isFaulty(c, 0);
    const Triangle t{c.point(0), c.point(1), c.point(2)};
    const Triangles list = gone(c);
    // It may be among the new ones, where it has no fault.
    const auto isAbout = [&](const Triangle& g) {
        return has(g, t.a) || has(g, t.b) || has(g, t.c);
    };
    c.need(std::any_of(list.begin(), list.end(), isAbout), "those about it");
    c.need(c.w.state.mesh().size() == c.w.meshWas.size(), "replaced");
}

// clang-format off
constexpr auto kRepairForms = std::to_array<SentenceForm>({
    {Stage::DropPatch, kNoVerdict, "Point {} keeps its fan of {}; its other fans, {}, are taken out.", dropsFans},
    {Stage::DropPatch, kNoVerdict, "A component of {} at point {} lies beside a larger one: taken out.", dropsPatch},
    {Stage::Reinsert, kNoVerdict, "Stranded point {} is put in, in place of {}.", [](C& c) { putsIn(c, false); }},
    {Stage::Reinsert, kNoVerdict, "Stranded point {} is put in beside the border.", [](C& c) { putsIn(c, true); }},
    {Stage::CloseHole, kNoVerdict, "The hole of {} points at {} - {} is filled.", fillsHole},
    {Stage::Flip, kNoVerdict, "Edge {} - {} is better as {} - {}, by {}: flipped.", flips},
    {Stage::Remesh, kNoVerdict, "Triangle ({}, {}, {}) has a fault: those about it are replaced.", remeshes},
});
// clang-format on

}  // namespace

std::span<const SentenceForm> repairForms() { return kRepairForms; }

}  // namespace se::test::sentences
