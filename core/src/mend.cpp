#include "spiraling_edge/mend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact.h"
#include "shape.h"

namespace se {
namespace {

HalfEdge following(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
HalfEdge preceding(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

Index cornerOf(const MendState& m, HalfEdge h) {
    const Triangle& t = m.triangles[h / 3];
    return h % 3 == 0 ? t.a : (h % 3 == 1 ? t.b : t.c);
}

/// Calls visit(side) for every side that leaves the point, going round it both ways from sideOf.
template <typename Visit>
void forEachSideOf(const MendState& m, Index point, Visit&& visit) {
    const HalfEdge begin = m.sideOf[point];
    if (begin == kNone) return;
    HalfEdge h = begin;
    do {
        visit(h);
        h = m.twin[preceding(h)];  // Counterclockwise.
    } while (h != kNone && h != begin);
    if (h == begin) return;
    for (h = m.twin[begin]; h != kNone; h = m.twin[h]) {
        h = following(h);  // Clockwise, from a border.
        visit(h);
    }
}

bool joined(const MendState& m, Index u, Index v) {
    bool found = false;
    forEachSideOf(m, u, [&](HalfEdge h) {
        found = found || cornerOf(m, following(h)) == v || cornerOf(m, preceding(h)) == v;
    });
    return found;
}

void pair(MendState& m, HalfEdge a, HalfEdge b) {
    m.twin[a] = b;
    if (b != kNone) m.twin[b] = a;
}

void markPinched(MendState& m) {
    std::vector<Index> sides(m.sideOf.size(), 0);
    for (const Triangle& t : m.triangles) {
        ++sides[t.a];
        ++sides[t.b];
        ++sides[t.c];
    }
    for (Index p = 0; p < m.sideOf.size(); ++p) {
        Index reached = 0;
        forEachSideOf(m, p, [&](HalfEdge) { ++reached; });
        m.pinched[p] = reached != sides[p];
    }
}

}  // namespace

MendState beginMending(std::size_t pointCount, const std::vector<Triangle>& triangles) {
    MendState m;
    m.triangles = triangles;
    m.twin.assign(3 * triangles.size(), kNone);
    m.sideOf.assign(pointCount, kNone);
    m.pinched.assign(pointCount, false);
    EdgeTable table(pointCount);
    std::vector<bool> crowded(3 * triangles.size(), false);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::array<Index, 3> c{triangles[i].a, triangles[i].b, triangles[i].c};
        for (Index k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * i + k);
            const HalfEdge same = table.find(c[k], c[(k + 1) % 3]);
            const HalfEdge other = table.find(c[(k + 1) % 3], c[k]);
            m.sideOf[c[k]] = h;
            if (same != kNone) crowded[same] = crowded[h] = true;
            if (other != kNone && m.twin[other] == kNone) pair(m, h, other);
        }
        table.add(triangles[i]);
    }
    for (HalfEdge h = 0; h < m.twin.size(); ++h) {
        if (crowded[h] && m.twin[h] != kNone) {
            m.twin[m.twin[h]] = kNone;
            m.twin[h] = kNone;
        }
        m.queue.push_back(h);
    }
    markPinched(m);
    return m;
}

// ---- reinsert -----------------------------------------------------------------------------------

namespace {

/// Does the point lie over the triangle, near it, and are the three triangles it makes without
/// fault?
bool fitsInto(const PointSet& points, const Triangle& t, Index x) {
    const auto& at = points.position;
    const Vec3 area = areaVector(at[t.a], at[t.b], at[t.c]);
    const double size = std::sqrt(glm::dot(area, area));
    if (!(glm::dot(area, points.normal[x]) > 0.5 * size)) return false;
    // Above the inside: each part keeps at least a hundredth of the area.
    for (const auto& [u, v] : {std::pair{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}) {
        if (glm::dot(areaVector(at[u], at[v], at[x]), area) < 0.01 * size * size) return false;
    }
    const double height = std::abs(glm::dot(at[x] - at[t.a], area)) / size;
    if (height * height > 0.25 * size) return false;
    return facesNormals(points, t.a, t.b, x) && facesNormals(points, t.b, t.c, x) &&
           facesNormals(points, t.c, t.a, x);
}

void splitTriangle(MendState& m, Index triangle, Index x) {
    const Triangle t = m.triangles[triangle];
    const HalfEdge h = 3 * triangle;
    const HalfEdge outerB = m.twin[h + 1];
    const HalfEdge outerC = m.twin[h + 2];
    const auto second = static_cast<Index>(m.triangles.size());
    m.triangles[triangle] = {t.a, t.b, x};
    m.triangles.push_back({t.b, t.c, x});
    m.triangles.push_back({t.c, t.a, x});
    m.twin.resize(m.twin.size() + 6, kNone);
    const HalfEdge b = 3 * second;
    const HalfEdge c = b + 3;
    pair(m, b, outerB);
    pair(m, c, outerC);
    pair(m, h + 1, b + 2);
    pair(m, b + 1, c + 2);
    pair(m, c + 1, h + 2);
    m.sideOf[x] = h + 2;
    m.sideOf[t.b] = b;
    m.sideOf[t.c] = c;
    for (const HalfEdge side : {h, b, c}) m.queue.push_back(side);
}

/// The triangle near a stranded point that it fits into best: the one whose plane is nearest.
Index homeOf(const PointSet& points, const MendState& m, Index x) {
    Index best = kNone;
    double bestHeight = 0.0;
    for (const Index near : points.neighbors[x]) {
        if (m.pinched[near]) continue;
        forEachSideOf(m, near, [&](HalfEdge h) {
            const Triangle& t = m.triangles[h / 3];
            if (!fitsInto(points, t, x)) return;
            const Vec3 area =
                areaVector(points.position[t.a], points.position[t.b], points.position[t.c]);
            const double above = glm::dot(points.position[x] - points.position[t.a], area);
            const double height = above * above / glm::dot(area, area);
            if (best != kNone && !(height < bestHeight)) return;
            best = h / 3;
            bestHeight = height;
        });
    }
    return best;
}

}  // namespace

bool reinsertNext(const PointSet& points, MendState& m, Index& point) {
    for (; m.nextPoint < points.size(); ++m.nextPoint) {
        const Index x = m.nextPoint;
        if (m.sideOf[x] != kNone || points.neighbors[x].empty()) continue;
        const Index home = homeOf(points, m, x);
        if (home == kNone) continue;
        splitTriangle(m, home, x);
        ++m.reinserted;
        ++m.nextPoint;
        point = x;
        return true;
    }
    return false;
}

// ---- flip ---------------------------------------------------------------------------------------

namespace {

/// The four points around an edge u v: x on the left of u -> v, y on the right.
struct Quad {
    Index u, v, x, y;
    Triangle left() const { return {u, v, x}; }
    Triangle right() const { return {v, u, y}; }
    Triangle flippedU() const { return {u, y, x}; }
    Triangle flippedV() const { return {y, v, x}; }
};

Quad quadAt(const MendState& m, HalfEdge h) {
    return {cornerOf(m, h), cornerOf(m, following(h)), cornerOf(m, preceding(h)),
            cornerOf(m, preceding(m.twin[h]))};
}

/// Faults of two triangles at the edge they share and at the four edges around them.
class FlipScore {
  public:
    FlipScore(const PointSet& points, const MendState& m, HalfEdge h)
        : points_(points), m_(m), h_(h), g_(m.twin[h]), quad_(quadAt(m, h)) {}

    int before() const {
        return faults(quad_.left(), quad_.right()) + outerFold(following(h_), quad_.left()) +
               outerFold(preceding(h_), quad_.left()) + outerFold(following(g_), quad_.right()) +
               outerFold(preceding(g_), quad_.right());
    }
    int after() const {
        return faults(quad_.flippedU(), quad_.flippedV()) +
               outerFold(preceding(h_), quad_.flippedU()) +
               outerFold(following(g_), quad_.flippedU()) +
               outerFold(following(h_), quad_.flippedV()) +
               outerFold(preceding(g_), quad_.flippedV());
    }
    /// Triangles nearby that the two given ones meet.
    int meetings(const Triangle& a, const Triangle& b) const {
        int count = 0;
        std::vector<Index> seen{h_ / 3, g_ / 3};
        for (const Index p : {quad_.u, quad_.v, quad_.x, quad_.y}) {
            forEachSideOf(m_, p, [&](HalfEdge side) {
                const Index t = side / 3;
                if (std::find(seen.begin(), seen.end(), t) != seen.end()) return;
                seen.push_back(t);
                for (const Triangle& mine : {a, b}) {
                    count += trianglesShareMore(points_.position, mine, m_.triangles[t]) ? 1 : 0;
                }
            });
        }
        return count;
    }
    const Quad& quad() const { return quad_; }

  private:
    int faults(const Triangle& a, const Triangle& b) const {
        return shapeFaults(points_, a) + shapeFaults(points_, b) + (folded(points_, a, b) ? 2 : 0);
    }
    int outerFold(HalfEdge side, const Triangle& mine) const {
        const HalfEdge other = m_.twin[side];
        return other != kNone && folded(points_, mine, m_.triangles[other / 3]) ? 2 : 0;
    }

    const PointSet& points_;
    const MendState& m_;
    HalfEdge h_, g_;
    Quad quad_;
};

/// Largest cosine of an angle of the two: the smaller, the larger their least angle.
double worstCosine(const PointSet& points, const Triangle& a, const Triangle& b) {
    return std::max(leastAngleCosine(points, a), leastAngleCosine(points, b));
}

bool isBetterFlipped(const PointSet& points, const MendState& m, HalfEdge h) {
    if (m.twin[h] == kNone) return false;
    const FlipScore score(points, m, h);
    const Quad& q = score.quad();
    if (q.x == q.y || m.pinched[q.u] || m.pinched[q.v] || m.pinched[q.x] || m.pinched[q.y]) {
        return false;
    }
    int before = score.before();
    if (before == 0) {
        // Sound as it is: flip for the angles only, and only where the surface is flat.
        constexpr double kFlat = 0.9;
        if (normalsCosine(points, q.left(), q.right()) < kFlat ||
            worstCosine(points, q.flippedU(), q.flippedV()) >
                worstCosine(points, q.left(), q.right()) - 1e-9 ||
            normalsCosine(points, q.flippedU(), q.flippedV()) < kFlat) {
            return false;
        }
    }
    int after = score.after();
    if (after > before || joined(m, q.x, q.y)) return false;
    if (before == 0 && after == 0) return true;
    before += score.meetings(q.left(), q.right());
    after += score.meetings(q.flippedU(), q.flippedV());
    return after < before;
}

void flipEdge(MendState& m, HalfEdge h) {
    const HalfEdge g = m.twin[h];
    const Quad q = quadAt(m, h);
    const HalfEdge vx = m.twin[following(h)];
    const HalfEdge xu = m.twin[preceding(h)];
    const HalfEdge uy = m.twin[following(g)];
    const HalfEdge yv = m.twin[preceding(g)];
    const Index s = h / 3;
    const Index t = g / 3;
    m.triangles[s] = q.flippedU();
    m.triangles[t] = q.flippedV();
    pair(m, 3 * s, uy);
    pair(m, 3 * s + 2, xu);
    pair(m, 3 * t, yv);
    pair(m, 3 * t + 1, vx);
    pair(m, 3 * s + 1, 3 * t + 2);
    m.sideOf[q.u] = 3 * s;
    m.sideOf[q.y] = 3 * t;
    m.sideOf[q.v] = 3 * t + 1;
    m.sideOf[q.x] = 3 * t + 2;
    for (const HalfEdge side : {3 * s, 3 * s + 2, 3 * t, 3 * t + 1}) m.queue.push_back(side);
}

}  // namespace

bool flipNext(const PointSet& points, MendState& m, Flip& flip) {
    while (m.queueFront < m.queue.size()) {
        const HalfEdge h = m.queue[m.queueFront++];
        if (!isBetterFlipped(points, m, h)) continue;
        const Quad q = quadAt(m, h);
        flipEdge(m, h);
        ++m.flipped;
        flip = {q.u, q.v, q.x, q.y};
        return true;
    }
    return false;
}

}  // namespace se
