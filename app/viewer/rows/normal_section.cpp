// The profile that a knife along the normal would leave: each triangle near the pivot becomes the
// line in which it meets the plane, the tested sphere a circle, the tangent plane a line. Points
// rarely lie on the plane; those near it are shown by their feet.
#include "normal_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "spiraling_edge/run/reading.h"

namespace se::view {

namespace {

/// Room around the farthest neighbor, as a factor.
constexpr double kRoom = 1.15;
/// Points closer to the plane than this share of the median spacing are shown.
constexpr double kNearShare = 0.35;

/// The plane, with the axes of the section.
struct SectionPlane {
    Vec3 origin{};
    Vec3 along{};   ///< x of the section, in the tangent plane.
    Vec3 normal{};  ///< y of the section.
    Vec3 across{};  ///< Normal of the plane.

    SectionPlace place(const Vec3& position) const {
        const Vec3 offset = position - origin;
        return {glm::dot(offset, along), glm::dot(offset, normal)};
    }
    double off(const Vec3& position) const { return glm::dot(position - origin, across); }
};

/// The part of a position that is perpendicular to a unit vector.
Vec3 inTangentPlane(const Vec3& offset, const Vec3& normal) {
    return offset - normal * glm::dot(offset, normal);
}

/// The plane through the pivot, its normal and `through`, turned about the normal.
SectionPlane planeAt(const Model& model, Index pivot, Index through, double turnDegrees) {
    SectionPlane plane;
    plane.origin = model.points.position[pivot];
    plane.normal = glm::normalize(model.points.normal[pivot]);
    Vec3 flat{};
    if (through != kNone)
        flat = inTangentPlane(model.points.position[through] - plane.origin, plane.normal);
    if (!(glm::length(flat) > 0.0)) {
        // Straight above the pivot: any direction.
        const Vec3 n = glm::abs(plane.normal);
        flat = inTangentPlane(n.x <= n.y && n.x <= n.z ? Vec3(1, 0, 0)
                              : n.y <= n.z             ? Vec3(0, 1, 0)
                                                       : Vec3(0, 0, 1),
                              plane.normal);
    }
    const Vec3 zero = glm::normalize(flat);
    const double turn = glm::radians(turnDegrees);
    plane.along = std::cos(turn) * zero + std::sin(turn) * glm::cross(plane.normal, zero);
    plane.across = glm::cross(plane.along, plane.normal);
    return plane;
}

/// The point that the plane goes through: the tested one, otherwise an end of the sector.
Index pointOfPlane(const DecisionState& picture) {
    for (const Index point : {picture.underTest, picture.start, picture.first, picture.end}) {
        if (point != kNone && point != picture.pivot) return point;
    }
    return kNone;
}

/// Fills a section step by step.
class SectionMaker {
  public:
    SectionMaker(const Model& model, const DecisionState& picture, double turnDegrees)
        : model_(model), picture_(picture) {
        made_.pivot = picture.pivot;
        made_.through = pointOfPlane(picture);
        plane_ = planeAt(model, picture.pivot, made_.through, turnDegrees);
        made_.along = plane_.along;
        made_.normal = plane_.normal;
        spacing_ = static_cast<double>(model.spacing) / model.scale;
    }

    NormalSection make(std::span<const Triangle> finished) {
        const Dial dial = makeDial(model_.points, model_.params, picture_);
        setReach(dial);
        for (const Triangle& t : finished) addCut(t, false);
        for (const Triangle& t : picture_.newTriangles) addCut(t, true);
        addPoints(dial);
        addCircle();
        return std::move(made_);
    }

  private:
    const Vec3& at(Index point) const { return model_.points.position[point]; }
    double distance(Index point) const { return glm::distance(at(point), plane_.origin); }

    void setReach(const Dial& dial) {
        double farthest = 2.0 * spacing_;
        for (const DialTick& tick : dial.ticks) farthest = std::max(farthest, distance(tick.point));
        made_.reach = kRoom * farthest;
    }

    /// Adds the line in which the plane cuts a triangle: it enters and leaves through two sides.
    void addCut(const Triangle& t, bool isNew) {
        const std::array corners = {t.a, t.b, t.c};
        const double far = 2.0 * made_.reach;
        if (std::all_of(corners.begin(), corners.end(), [&](Index p) { return distance(p) > far; }))
            return;
        std::vector<SectionPlace> met;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& from = at(corners[i]);
            const Vec3& to = at(corners[(i + 1) % 3]);
            const double a = plane_.off(from);
            const double b = plane_.off(to);
            // A corner on the plane counts with the side above.
            if ((a >= 0.0) == (b >= 0.0)) continue;
            met.push_back(plane_.place(from + (to - from) * (a / (a - b))));
        }
        if (met.size() == 2) made_.cuts.push_back({met[0], met[1], isNew});
    }

    void addPoints(const Dial& dial) {
        for (const DialTick& tick : dial.ticks) {
            const bool named = tick.role != DialRole::Neighbor && tick.role != DialRole::Done;
            add(tick.point, tick.role, named || tick.underTest);
            SectionPoint* added = find(tick.point);
            if (added == nullptr) continue;
            added->listed = true;
            added->underTest = tick.underTest;
            added->named = tick.named;
        }
        for (std::size_t p = 0; p < model_.points.size(); ++p) {
            const auto point = static_cast<Index>(p);
            if (!model_.drawable[p] || distance(point) > made_.reach) continue;
            const bool done = picture_.status[point] == kDone;
            add(point, done ? DialRole::Done : DialRole::Neighbor, false);
        }
    }

    SectionPoint* find(Index point) {
        const auto found = std::find_if(made_.points.begin(), made_.points.end(),
                                        [&](const SectionPoint& p) { return p.point == point; });
        return found == made_.points.end() ? nullptr : &*found;
    }

    /// Adds a point, only if it is near the plane, unless `always`.
    void add(Index point, DialRole role, bool always) {
        const double off = plane_.off(at(point));
        if (!always && std::abs(off) > kNearShare * spacing_) return;
        if (point == made_.pivot || find(point) != nullptr) return;
        made_.points.push_back({point, plane_.place(at(point)), off, role, false, false, false});
    }

    void addCircle() {
        const bool tested = picture_.event && picture_.event->address.stage == Stage::Sphere;
        const auto* test = tested ? picture_.evidence<SphereEvidence>(Stage::Sphere) : nullptr;
        if (test == nullptr || !hasSphere(*test)) return;
        const double off = plane_.off(test->center);
        const double square = test->radius * test->radius - off * off;
        if (!(square > 0.0)) return;
        made_.circle = {plane_.place(test->center), std::sqrt(square)};
    }

    const Model& model_;
    const DecisionState& picture_;
    SectionPlane plane_;
    double spacing_ = 0.0;  ///< Median distance to the nearest neighbor, scene units.
    NormalSection made_;
};

}  // namespace

NormalSection makeSection(const Model& model, const DecisionState& picture,
                          std::span<const Triangle> finished, double turnDegrees) {
    if (picture.pivot == kNone || picture.first == kNone) return {};
    return SectionMaker(model, picture, turnDegrees).make(finished);
}

}  // namespace se::view
