/// RobustRules::flip: flips edges where that leaves fewer faults or better angles, one edge at a
/// time; a flip queues the four edges around it. An edge costs O(triangles at its four points), and
/// with a search for meetings also those at their neighbors. Most edges stay by a test of their
/// four points and of the direction of their two triangles, which is found on all cores before the
/// first flip, and for changed triangles when it is needed.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "spiraling_edge/geometry/triangle_shape.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"

namespace se {

namespace {

/// The four points around an edge u v, x on the left of u -> v, y on the right, and its triangles
/// before and after a flip.
struct Quad {
    Index u, v, x, y;

    Triangle left() const { return {u, v, x}; }
    Triangle right() const { return {v, u, y}; }
    Triangle flippedU() const { return {u, y, x}; }
    Triangle flippedV() const { return {y, v, x}; }
};

Quad quadAt(const RepairState& m, HalfEdge h) {
    const Triangle left = cornersFrom(m, h);
    return {left.a, left.b, left.c, cornersFrom(m, m.twin[h]).c};
}

/// Faults of two triangles at the edge they share and at the four edges around them.
class FlipScore {
  public:
    FlipScore(const PointSet& points, RepairState& m, HalfEdge h, const Quad& quad)
        : points_(points), m_(m), h_(h), g_(m.twin[h]), quad_(quad) {}

    /// Faults of the two triangles themselves.
    int own() const {
        if (!own_) own_ = faults(quad_.left(), quad_.right());
        return *own_;
    }
    int before() const {
        if (!before_) {
            const Vec3 left = areaOf(quad_.left());
            const Vec3 right = areaOf(quad_.right());
            before_ = own() + outerFold(following(h_), left) + outerFold(preceding(h_), left) +
                      outerFold(following(g_), right) + outerFold(preceding(g_), right);
        }
        return *before_;
    }
    int after() const {
        if (!after_) {
            const Vec3 atU = areaOf(quad_.flippedU());
            const Vec3 atV = areaOf(quad_.flippedV());
            after_ = faults(quad_.flippedU(), quad_.flippedV()) + outerFold(preceding(h_), atU) +
                     outerFold(following(g_), atU) + outerFold(following(h_), atV) +
                     outerFold(preceding(g_), atV);
        }
        return *after_;
    }
    /// Conflicts of the two given triangles with others; counted until they are more than `most`.
    int conflicts(const Triangle& a, const Triangle& b, int most) const {
        return countConflicts(points_, m_, std::array{a, b}, {h_ / 3, g_ / 3}, most);
    }
    /// Conflicts of the two triangles of the edge.
    int conflictsBefore() const {
        constexpr int kAll = std::numeric_limits<int>::max();
        return conflicts(quad_.left(), quad_.right(), kAll);
    }
    /// True if isSound() holds for both triangles of the edge.
    bool areSound() const { return isSound(points_, m_, h_ / 3) && isSound(points_, m_, g_ / 3); }
    bool areKnownAsSound() const {
        return isKnownAsSound(m_, h_ / 3) && isKnownAsSound(m_, g_ / 3);
    }
    const Quad& quad() const { return quad_; }

  private:
    int faults(const Triangle& a, const Triangle& b) const {
        return shapeFaults(points_, a) + shapeFaults(points_, b) + (folded(points_, a, b) ? 2 : 0);
    }
    /// The area vector that folded() compares.
    Vec3 areaOf(const Triangle& t) const { return areaVector(points_, fromLeastCorner(t)); }
    int outerFold(HalfEdge side, const Vec3& mine) const {
        const HalfEdge other = m_.twin[side];
        if (other == kNone) return 0;
        return encloseMore(mine, areaOf(m_.triangles[other / 3]), kFoldCosine) ? 2 : 0;
    }

    const PointSet& points_;
    RepairState& m_;
    HalfEdge h_, g_;
    Quad quad_;
    mutable std::optional<int> own_, before_, after_;
};

/// Cosine of the least angle of the two triangles.
double worstCosine(const PointSet& points, const Triangle& a, const Triangle& b) {
    return std::max(leastAngleCosine(points, a), leastAngleCosine(points, b));
}

/// True if the two triangles lie nearly in one plane.
bool isFlat(const PointSet& points, const RobustThresholds& thresholds, const Quad& q) {
    return normalsCosine(points, q.left(), q.right()) > thresholds.flipFlatCosine;
}

/// True if the surface is flat by the normals of the four points: for narrow triangles, with three
/// points almost collinear, which may stand on it like a wall.
bool isFlatByNormals(const PointSet& points, const RobustThresholds& thresholds, const Quad& q) {
    const std::array corners{q.u, q.v, q.x, q.y};
    Vec3 sum(0.0);
    for (const Index p : corners) sum += points.normal[p];
    return std::none_of(corners.begin(), corners.end(), [&](Index p) {
        return encloseMore(points.normal[p], sum, thresholds.flipFlatCosine);
    });
}

/// Two sound triangles: flip for the angles only, and only where the surface is flat.
bool givesBetterAngles(const PointSet& points, const RobustThresholds& thresholds,
                       const FlipScore& score) {
    const Quad& q = score.quad();
    const bool flat = isFlat(points, thresholds, q);
    const double now = worstCosine(points, q.left(), q.right());
    if (!flat && now < thresholds.flipNarrowCosine) return false;
    const bool better = worstCosine(points, q.flippedU(), q.flippedV()) < now - 1e-9;
    if (!better || normalsCosine(points, q.flippedU(), q.flippedV()) <= thresholds.flipFlatCosine)
        return false;
    if (flat) return score.after() == 0;
    return isFlatByNormals(points, thresholds, q) && score.after() == 0 &&
           score.conflicts(q.flippedU(), q.flippedV(), 0) == 0;
}

/// The cosine of the least angle of a triangle, by the squared lengths of its edges, up to
/// rounding: the angle across the shortest edge.
double leastAngleCosine(double a, double b, double c) {
    const double shorter = std::min(a, b);
    const double longer = std::max(a, b);
    const double other = std::max(shorter, c);
    return 0.5 * (longer + other - std::min(shorter, c)) / std::sqrt(longer * other);
}

double squaredDistance(const Vec3& a, const Vec3& b) { return glm::dot(b - a, b - a); }

/// An edge of two triangles clearly within the limits of isSteep() and isFlat(), whose angles are
/// clearly not better flipped: most edges, at a fraction of the cost. Its margin is far above the
/// rounding of floats.
bool clearlyStays(const PointSet& points, const RobustThresholds& thresholds,
                  const FacingTriangle& left, const FacingTriangle& right, const Quad& q) {
    constexpr float kMargin = 1e-5F;
    const float now = std::max(left.cosine, right.cosine) + kMargin;
    if (now > FacingTriangle::kNotFacing) return false;
    const float along = left.normal[0] * right.normal[0] + left.normal[1] * right.normal[1] +
                        left.normal[2] * right.normal[2];
    if (along < thresholds.flipFlatCosine + double{kMargin}) return false;
    const Vec3& x = points.position[q.x];
    const Vec3& y = points.position[q.y];
    const double xySq = squaredDistance(x, y);
    const auto isNarrow = [&](const Vec3& other) {
        return leastAngleCosine(xySq, squaredDistance(x, other), squaredDistance(y, other)) > now;
    };
    return isNarrow(points.position[q.u]) || isNarrow(points.position[q.v]);
}

/// The triangle's RepairState::facing, made if it is not known.
const FacingTriangle& knownFacing(const PointSet& points, RepairState& m, Index t) {
    FacingTriangle& known = m.facing.at[t];
    if (known.cosine == FacingTriangle::kUnknown) known = facingTriangle(points, m.triangles[t]);
    return known;
}

/// A conflict may move to triangles that are not examined, and come back: each triangle takes part
/// in at most this many flips that change nothing else.
constexpr std::uint8_t kMaxConflictFlips = 4;

/// The gain of a flip.
enum class Gain : std::uint8_t { None, Angles, Shape, Conflicts };

/// Whether a flip leaves fewer faults.
Gain gainInFaults(const RepairState& m, HalfEdge h, const FlipScore& score) {
    const Quad& q = score.quad();
    const int before = score.before();
    const int after = score.after();
    if (after > before) return Gain::None;
    const int tooMany = before + score.conflictsBefore() - after;
    if (tooMany == 0 || score.conflicts(q.flippedU(), q.flippedV(), tooMany - 1) >= tooMany)
        return Gain::None;
    if (after < before) return Gain::Shape;
    const auto flips = std::max(m.conflictFlips[h / 3], m.conflictFlips[m.twin[h] / 3]);
    return flips < kMaxConflictFlips ? Gain::Conflicts : Gain::None;
}

Gain gainOfFlip(const PointSet& points, const RobustThresholds& thresholds, RepairState& m,
                HalfEdge h, const Quad& q) {
    const FacingTriangle& left = knownFacing(points, m, h / 3);
    const FacingTriangle& right = knownFacing(points, m, m.twin[h] / 3);
    if (clearlyStays(points, thresholds, left, right, q)) return Gain::None;
    if (q.x == q.y || m.pinched[q.u] || m.pinched[q.v] || m.pinched[q.x] || m.pinched[q.y]) {
        return Gain::None;
    }
    const FlipScore score(points, m, h, q);
    bool sound = score.own() == 0 && (isFlat(points, thresholds, q) || score.before() == 0);
    if (sound && !score.areKnownAsSound() &&
        (isRough(points, m, h / 3) || isRough(points, m, m.twin[h] / 3))) {
        // No flip for any reason leaves more faults: asked before the search for conflicts, which
        // takes ten times as long and mostly finds none.
        if (score.after() > score.before()) return Gain::None;
        sound = score.areSound();
    }
    Gain gain = Gain::None;
    if (!sound) {
        gain = gainInFaults(m, h, score);
    } else if (givesBetterAngles(points, thresholds, score)) {
        gain = Gain::Angles;
    }
    return gain == Gain::None || joined(m, q.x, q.y) ? Gain::None : gain;
}

void flipEdge(RepairState& m, HalfEdge h, const Quad& q) {
    const HalfEdge g = m.twin[h];
    const HalfEdge vx = m.twin[following(h)];
    const HalfEdge xu = m.twin[preceding(h)];
    const HalfEdge uy = m.twin[following(g)];
    const HalfEdge yv = m.twin[preceding(g)];
    const Index s = h / 3;
    const Index t = g / 3;
    m.setTriangle(s, q.flippedU());
    m.setTriangle(t, q.flippedV());
    pair(m, 3 * s, uy);
    pair(m, 3 * s + 2, xu);
    pair(m, 3 * t, yv);
    pair(m, 3 * t + 1, vx);
    pair(m, 3 * s + 1, 3 * t + 2);
    m.sideOf.set(q.u, 3 * s);
    m.sideOf.set(q.y, 3 * t);
    m.sideOf.set(q.v, 3 * t + 1);
    m.sideOf.set(q.x, 3 * t + 2);
    for (const HalfEdge side : {3 * s, 3 * s + 2, 3 * t, 3 * t + 1}) m.queue.push_back(side);
}

}  // namespace

FacingTriangle facingTriangle(const PointSet& points, const Triangle& t) {
    if (!clearlyFaces(points, t, kRough)) return {{}, FacingTriangle::kNotFacing};
    const Vec3 ab = points.position[t.b] - points.position[t.a];
    const Vec3 ac = points.position[t.c] - points.position[t.a];
    const Vec3 area = glm::cross(ab, ac);
    const Vec3 n = area / std::sqrt(glm::dot(area, area));
    const double cosine =
        leastAngleCosine(glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab));
    return {{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
            static_cast<float>(cosine)};
}

std::optional<FlipEvidence> flipNext(const PointSet& points, const RobustThresholds& thresholds,
                                     RepairState& m) {
    m.conflictFlips.resize(m.triangles.size(), 0);
    if (m.round == 0 && m.queueFront == 0) findSound(points, m);
    if (m.facing.points != &points) m.facing = {&points, {}};
    m.facing.at.resize(m.triangles.size());
    while (m.queueFront < m.queue.size()) {
        const HalfEdge h = m.queue[m.queueFront++];
        // Other steps shorten the list, so that a side in the queue may no longer exist.
        if (h >= m.twin.size() || m.twin[h] == kNone) continue;
        const Quad q = quadAt(m, h);
        const Gain gain = gainOfFlip(points, thresholds, m, h, q);
        if (gain == Gain::None) continue;
        if (gain == Gain::Conflicts) {
            for (const HalfEdge side : {h, m.twin[h]}) {
                m.conflictFlips.set(side / 3,
                                    static_cast<std::uint8_t>(m.conflictFlips[side / 3] + 1));
            }
        }
        flipEdge(m, h, q);
        ++m.flipped;
        return FlipEvidence{q.u, q.v, q.x, q.y, gain == Gain::Angles};
    }
    m.facing = {};
    return std::nullopt;
}

}  // namespace se
