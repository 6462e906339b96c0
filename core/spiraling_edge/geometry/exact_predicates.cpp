/// A floating-point filter with Shewchuk's error bounds decides almost always; otherwise the
/// determinant is summed exactly in expansions on the stack. Triangles are then compared by the
/// signs of such determinants alone.
#include "spiraling_edge/geometry/exact_predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace se {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

int signOf(double x) { return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0); }

/// A number as an unevaluated sum of doubles, smallest first, none overlapping. Room for every
/// number that orient3d() forms: 3 products of 2 terms with 2 * 2 * 2 * 2 of them.
class Expansion {
  public:
    Expansion() = default;
    /// a - b, exactly.
    static Expansion difference(double a, double b) {
        const double s = a - b;
        const double bVirtual = a - s;
        const double error = (a - (s + bVirtual)) + (bVirtual - b);
        Expansion e;
        e.append(error);
        e.append(s);
        return e;
    }

    Expansion plus(const Expansion& other) const {
        Expansion sum = *this;
        for (std::size_t i = 0; i < other.size_; ++i) sum.grow(other.terms_[i]);
        return sum;
    }
    Expansion times(const Expansion& other) const {
        Expansion product;
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = 0; j < other.size_; ++j) {
                const double high = terms_[i] * other.terms_[j];
                product.grow(std::fma(terms_[i], other.terms_[j], -high));
                product.grow(high);
            }
        }
        return product;
    }
    Expansion negated() const {
        Expansion e = *this;
        for (std::size_t i = 0; i < size_; ++i) e.terms_[i] = -e.terms_[i];
        return e;
    }
    /// The largest term decides.
    int sign() const { return size_ == 0 ? 0 : signOf(terms_[size_ - 1]); }

  private:
    static constexpr std::size_t kRoom = 200;

    void append(double term) {
        if (term != 0.0) terms_[size_++] = term;
    }
    void grow(double value) {
        double carry = value;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = carry + terms_[i];
            const double virtualTerm = sum - carry;
            const double error = (carry - (sum - virtualTerm)) + (terms_[i] - virtualTerm);
            if (error != 0.0) terms_[kept++] = error;
            carry = sum;
        }
        size_ = kept;
        append(carry);
    }

    std::array<double, kRoom> terms_;
    std::size_t size_ = 0;
};

Expansion minor2(const Expansion& a, const Expansion& b, const Expansion& c, const Expansion& d) {
    return a.times(d).plus(b.times(c).negated());
}

int orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto e = [&](const Vec3& p, int i) { return Expansion::difference(p[i], d[i]); };
    const Expansion bc = minor2(e(b, 0), e(b, 1), e(c, 0), e(c, 1));
    const Expansion ca = minor2(e(c, 0), e(c, 1), e(a, 0), e(a, 1));
    const Expansion ab = minor2(e(a, 0), e(a, 1), e(b, 0), e(b, 1));
    return e(a, 2).times(bc).plus(e(b, 2).times(ca)).plus(e(c, 2).times(ab)).sign();
}

/// The two other coordinates, in cyclic order.
glm::dvec2 flatten(const Vec3& p, Axis dropped) {
    const int axis = static_cast<int>(dropped);
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// The axis along which the triangle's normal is longest.
Axis dominantAxis(const Vec3* t) {
    const Vec3 size = glm::abs(glm::cross(t[1] - t[0], t[2] - t[0]));
    if (size.x >= size.y && size.x >= size.z) return Axis::X;
    return size.y >= size.z ? Axis::Y : Axis::Z;
}

bool segmentsMeetInPlane(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, Axis axis) {
    const int a = orient2d(p, q, r, axis);
    const int b = orient2d(p, q, s, axis);
    const int c = orient2d(r, s, p, axis);
    const int d = orient2d(r, s, q, axis);
    if (a != 0 || b != 0 || c != 0 || d != 0) return a * b <= 0 && c * d <= 0;
    // All collinear: they meet if their extents do.
    const auto within = [&](const Vec3& x, const Vec3& u, const Vec3& v) {
        const glm::dvec2 f = flatten(x, axis);
        const glm::dvec2 g = flatten(u, axis);
        const glm::dvec2 h = flatten(v, axis);
        return std::min(g.x, h.x) <= f.x && f.x <= std::max(g.x, h.x) &&
               std::min(g.y, h.y) <= f.y && f.y <= std::max(g.y, h.y);
    };
    return within(p, r, s) || within(q, r, s) || within(r, p, q) || within(s, p, q);
}

bool insideInPlane(const Vec3& p, const Vec3* t, Axis axis) {
    const int a = orient2d(t[0], t[1], p, axis);
    const int b = orient2d(t[1], t[2], p, axis);
    const int c = orient2d(t[2], t[0], p, axis);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

/// The segment lies in the triangle's plane.
bool coplanarSegmentMeets(const Vec3& p, const Vec3& q, const Vec3* t) {
    const Axis axis = dominantAxis(t);
    if (insideInPlane(p, t, axis) || insideInPlane(q, t, axis)) return true;
    for (int i = 0; i < 3; ++i) {
        if (segmentsMeetInPlane(p, q, t[i], t[(i + 1) % 3], axis)) return true;
    }
    return false;
}

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = a - d;
    const Vec3 v = b - d;
    const Vec3 w = c - d;
    const double vw = v.x * w.y - v.y * w.x;
    const double wu = w.x * u.y - w.y * u.x;
    const double uv = u.x * v.y - u.y * v.x;
    const double determinant = u.z * vw + v.z * wu + w.z * uv;
    const double size = std::abs(u.z) * (std::abs(v.x * w.y) + std::abs(v.y * w.x)) +
                        std::abs(v.z) * (std::abs(w.x * u.y) + std::abs(w.y * u.x)) +
                        std::abs(w.z) * (std::abs(u.x * v.y) + std::abs(u.y * v.x));
    constexpr double kBound = (7.0 + 56.0 * kEpsilon) * kEpsilon;
    if (std::abs(determinant) > kBound * size) return signOf(determinant);
    return orient3dExact(a, b, c, d);
}

int orient2d(const Vec3& a3, const Vec3& b3, const Vec3& c3, Axis dropped) {
    const glm::dvec2 a = flatten(a3, dropped);
    const glm::dvec2 b = flatten(b3, dropped);
    const glm::dvec2 c = flatten(c3, dropped);
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    constexpr double kBound = (3.0 + 16.0 * kEpsilon) * kEpsilon;
    if (std::abs(determinant) > kBound * (std::abs(left) + std::abs(right))) {
        return signOf(determinant);
    }
    return minor2(Expansion::difference(a.x, c.x), Expansion::difference(a.y, c.y),
                  Expansion::difference(b.x, c.x), Expansion::difference(b.y, c.y))
        .sign();
}

namespace {

/// segmentMeetsTriangle() for ends on these sides of the triangle's plane.
bool segmentMeets(const Vec3& p, const Vec3& q, const Vec3* t, int sp, int sq) {
    if (sp * sq > 0) return false;
    if (sp == 0 && sq == 0) return coplanarSegmentMeets(p, q, t);
    const int a = orient3d(p, q, t[0], t[1]);
    const int b = orient3d(p, q, t[1], t[2]);
    const int c = orient3d(p, q, t[2], t[0]);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

/// The sides of the plane of `t` on which the corners of `other` are.
std::array<int, 3> sidesOf(const Vec3* t, const Vec3* other) {
    return {orient3d(t[0], t[1], t[2], other[0]), orient3d(t[0], t[1], t[2], other[1]),
            orient3d(t[0], t[1], t[2], other[2])};
}

bool isOneSided(const std::array<int, 3>& side) {
    return side[0] == side[1] && side[1] == side[2] && side[0] != 0;
}

}  // namespace

bool segmentMeetsTriangle(const Vec3& p, const Vec3& q, const Vec3* t) {
    return segmentMeets(p, q, t, orient3d(t[0], t[1], t[2], p), orient3d(t[0], t[1], t[2], q));
}

bool trianglesMeet(const Vec3* a, const Vec3* b) {
    // Most pairs are decided by the plane of one with the other entirely on one side.
    const std::array ofA = sidesOf(b, a);
    if (isOneSided(ofA)) return false;
    const std::array ofB = sidesOf(a, b);
    if (isOneSided(ofB)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (segmentMeets(a[i], a[j], b, ofA[i], ofA[j])) return true;
        if (segmentMeets(b[i], b[j], a, ofB[i], ofB[j])) return true;
    }
    return false;
}

bool overlapAtEdge(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y) {
    if (orient3d(u, v, x, y) != 0) return false;
    const Vec3 t[3] = {u, v, x};
    const Axis axis = dominantAxis(t);
    return orient2d(u, v, x, axis) * orient2d(u, v, y, axis) > 0;
}

namespace {

// Filters for pairs of neighbors, most of which lie side by side. They compare with bounds far
// above the rounding of the sums; triangles without area are left to the exact tests.
constexpr double kFilterRounding = 1e-13;

double absoluteSum(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// A triangle from its first corner.
struct Corner {
    Vec3 at, u, v, normal;
    double size;   ///< At least the length of each edge.
    double bound;  ///< Far above the rounding of `normal`.

    explicit Corner(const Vec3* t)
        : at(t[0]),
          u(t[1] - t[0]),
          v(t[2] - t[0]),
          normal(glm::cross(u, v)),
          size(absoluteSum(u) + absoluteSum(v)),
          bound(kFilterRounding * size * size) {}

    /// 1 or -1 if a place is clearly on that side of the plane, else 0. `distance` is at least the
    /// place's from the corner.
    int side(const Vec3& place, double distance) const {
        const double height = glm::dot(normal, place - at);
        const double least = bound * distance;
        return height > least ? 1 : (height < -least ? -1 : 0);
    }
    bool hasArea() const { return absoluteSum(normal) > bound; }
};

/// True if a plane through their common corner clearly has one triangle on each side.
bool clearlyApart(const Corner& a, const Corner& b) {
    const Vec3 d = (a.u + a.v) - (b.u + b.v);
    const double size = a.size + b.size;
    const double least = kFilterRounding * size * size;
    return glm::dot(a.u, d) > least && glm::dot(a.v, d) > least && glm::dot(b.u, d) < -least &&
           glm::dot(b.v, d) < -least;
}

/// True if a plane clearly has one triangle on each side: that of `a`, or one across the line
/// between their middles, as for two in one plane.
bool clearlyApart(const Vec3* a, const Vec3* b) {
    const Corner cornerA(a);
    const Vec3 b0 = b[0] - a[0];
    const Corner cornerB(b);
    const double distance = absoluteSum(b0) + cornerB.size;
    const int side = cornerA.side(b[0], distance);
    if (side != 0 && side == cornerA.side(b[1], distance) && side == cornerA.side(b[2], distance))
        return true;
    const Vec3 d = (cornerA.u + cornerA.v) - (cornerB.u + cornerB.v) - 3.0 * b0;
    const double size = cornerA.size + distance;
    const double least = std::min(0.0, std::min(glm::dot(cornerA.u, d), glm::dot(cornerA.v, d)));
    const double most =
        glm::dot(b0, d) + std::max(0.0, std::max(glm::dot(cornerB.u, d), glm::dot(cornerB.v, d)));
    return least - most > kFilterRounding * size * size && cornerA.hasArea() && cornerB.hasArea();
}

/// clearlyApart() for a[0] = b[0].
bool clearlyApartAtCorner(const Vec3* a, const Vec3* b) {
    const Corner cornerA(a);
    const Corner cornerB(b);
    if (!cornerA.hasArea() || !cornerB.hasArea()) return false;
    return clearlyApart(cornerA, cornerB) ||
           cornerA.side(b[1], cornerB.size) * cornerA.side(b[2], cornerB.size) > 0 ||
           cornerB.side(a[1], cornerA.size) * cornerB.side(a[2], cornerA.size) > 0;
}

/// True if x and y are clearly on different sides of the edge u v, as in a flat mesh, or y is
/// clearly off the plane of u, v and x.
bool clearlyApartAtEdge(const Vec3& u, const Vec3& v, const Vec3& x, const Vec3& y) {
    const Vec3 edge = v - u;
    const Vec3 a = x - u;
    const Vec3 b = y - u;
    const Vec3 normal = glm::cross(edge, a);
    const double size = absoluteSum(edge) + absoluteSum(a) + absoluteSum(b);
    const double bound = kFilterRounding * size * size * size;
    return std::abs(glm::dot(normal, b)) > bound ||
           glm::dot(normal, glm::cross(edge, b)) < -bound * size;
}

}  // namespace

bool trianglesShareMore(const std::vector<Vec3>& position, const Triangle& a, const Triangle& b) {
    std::array<Index, 3> pa{a.a, a.b, a.c};
    std::array<Index, 3> pb{b.a, b.b, b.c};
    // Common corners to the front, in the same order.
    std::size_t common = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found =
            std::find(pb.begin() + static_cast<std::ptrdiff_t>(common), pb.end(), pa[i]);
        if (found == pb.end()) continue;
        std::swap(*found, pb[common]);
        std::swap(pa[i], pa[common]);
        ++common;
    }
    const Vec3 va[3] = {position[pa[0]], position[pa[1]], position[pa[2]]};
    const Vec3 vb[3] = {position[pb[0]], position[pb[1]], position[pb[2]]};
    switch (common) {
        case 0:
            return !clearlyApart(va, vb) && trianglesMeet(va, vb);
        case 1:
            return !clearlyApartAtCorner(va, vb) && (segmentMeetsTriangle(va[1], va[2], vb) ||
                                                     segmentMeetsTriangle(vb[1], vb[2], va));
        case 2:
            return !clearlyApartAtEdge(va[0], va[1], va[2], vb[2]) &&
                   overlapAtEdge(va[0], va[1], va[2], vb[2]);
        default:
            return true;
    }
}

}  // namespace se
