/// Birth and death of particles. The crowding at a place is the sum of the repulsion around it;
/// crowded particles are removed and new ones added at the least crowded places, a few percent at a
/// time, so that the number reaches its target and the spacing becomes even. Deterministic: ties by
/// index. O(n log n) for n particles.
#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/geometry/point_grid.h"
#include "spiraling_edge/sampling/particles.h"

namespace se::sampling {
namespace {

/// A place for a new particle, or a particle that may be removed, with the crowding there.
struct Candidate {
    double crowd;
    std::size_t particle;
    Vec3 place;
};

/// The crowding where there is no place on the surface.
constexpr double kNowhere = 1e9;
/// Crowding below which a place is on another sheet or a speck, with fewer than three particles
/// near.
constexpr double kElsewhere = 0.6;
/// Crowding below which a particle is added: it is 1 in the gap of one particle in even triangles,
/// 1.6 in the middle of a triangle.
constexpr double kRoom = 1.2;
constexpr double kCrowded = 1.35;
/// Weight of a pair that is too near in the crowding, in units of squeeze().
constexpr double kPair = 4.0;
/// A particle without another within this many spacings has no neighbors for triangles.
constexpr double kLonely = 1.3;
/// Crowding above which a particle is exchanged even where there is little room elsewhere.
constexpr double kSqueezed = 2.0;

/// Measures the crowding. At a place it is the sum of push() over the particles around, scaled to 1
/// among equilateral triangles of the target size, and more where some are too near.
class Census {
  public:
    Census(const Surface& surface, double flatSpacing, const Particles& particles)
        : surface_(surface),
          particles_(particles),
          flat_(flatSpacing),
          grid_(surface.field().low, surface.field().high,
                kReach * *std::max_element(particles.spacing.begin(), particles.spacing.end())) {
        for (const Vec3& x : particles.position) grid_.add(x);
    }

    /// Crowding at a place with this normal, without particle `self`.
    double crowdAt(const Vec3& x, const Vec3& n, double spacing, std::size_t self) const {
        double sum = 0.0;
        grid_.near(x, [&](Index j) {
            if (j == self || glm::dot(n, particles_.normal[j]) <= 0.0) return;
            const double reach = 0.5 * kReach * (spacing + particles_.spacing[j]);
            const double q = lengthOf(x - particles_.position[j]) / reach;
            sum += push(q) + kPair * squeeze(q);
        });
        return sum / kCrowdOfTriangles;
    }
    double crowdOf(std::size_t i) const {
        return crowdAt(particles_.position[i], particles_.normal[i], particles_.spacing[i], i);
    }

    /// True if fewer than three others around face the same way, or none is near: on a speck too
    /// small for triangles.
    bool isAlone(std::size_t i) const {
        const Vec3 x = particles_.position[i];
        const double spacing = particles_.spacing[i];
        int others = 0;
        double nearest = kReach * spacing;
        grid_.near(x, [&](Index j) {
            const double distance = lengthOf(x - particles_.position[j]);
            if (j == i || distance >= kReach * spacing) return;
            if (glm::dot(particles_.normal[i], particles_.normal[j]) <= 0.0) return;
            ++others;
            nearest = std::min(nearest, distance);
        });
        return others < 3 || nearest > kLonely * spacing;
    }

    /// The place with the least crowding at one spacing from particle i.
    Candidate gapAt(std::size_t i) const {
        constexpr int kDirections = 12;
        const Vec3 x = particles_.position[i];
        const Vec3 n = particles_.normal[i];
        const Vec3 aside = std::abs(n.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
        const Vec3 u = glm::normalize(glm::cross(n, aside));
        const Vec3 v = glm::cross(n, u);
        Candidate best{kNowhere, i, x};
        for (int k = 0; k < kDirections; ++k) {
            const double angle = 2.0 * kPi * k / kDirections;
            const Vec3 way = std::cos(angle) * u + std::sin(angle) * v;
            const auto y = surface_.settle(x + 0.9 * particles_.spacing[i] * way, 0,
                                           0.5 * particles_.spacing[i]);
            if (!y) continue;
            const Vec3 m = surface_.field().normal(*y);
            if (glm::dot(m, n) <= 0.0) continue;
            const double spacing = flat_ * surface_.relativeSpacing(*y);
            const double crowd = crowdAt(*y, m, spacing, kNone);
            if (crowd > kElsewhere && crowd < best.crowd) best = {crowd, i, *y};
        }
        return best;
    }

  private:
    static constexpr double kPi = 3.14159265358979323846;
    /// Six neighbors at one spacing.
    static constexpr double kCrowdOfTriangles = 6.0 * (1.0 - 1.0 / kReach) * (1.0 - 1.0 / kReach);

    const Surface& surface_;
    const Particles& particles_;
    double flat_;
    CellGrid grid_;
};

bool emptier(const Candidate& a, const Candidate& b) {
    return a.crowd < b.crowd || (a.crowd == b.crowd && a.particle < b.particle);
}

/// The first of `candidates`, at most `limit`, that are not near one another.
std::vector<Candidate> apart(const std::vector<Candidate>& candidates, std::size_t limit,
                             const Particles& particles) {
    std::vector<Candidate> taken;
    for (const Candidate& c : candidates) {
        if (taken.size() >= limit) break;
        const double reach = kReach * particles.spacing[c.particle];
        const bool free = std::none_of(taken.begin(), taken.end(), [&](const Candidate& t) {
            return lengthOf(t.place - c.place) < reach;
        });
        if (free) taken.push_back(c);
    }
    return taken;
}

/// The places with the least crowding next to the least crowded particles.
std::vector<Candidate> roomiest(const Census& census, std::vector<Candidate> all,
                                std::size_t wanted) {
    std::sort(all.begin(), all.end(), emptier);
    std::vector<Candidate> gaps;
    for (const Candidate& c : all) {
        if (gaps.size() >= wanted) break;
        const Candidate gap = census.gapAt(c.particle);
        if (gap.crowd < kNowhere) gaps.push_back(gap);
    }
    std::sort(gaps.begin(), gaps.end(), emptier);
    return gaps;
}

/// Removes particles on specks, unless those are most of the surface. False if cancelled.
bool leaveSpecks(const Surface& surface, double flatSpacing, unsigned threads,
                 const Progress& progress, Particles& particles) {
    const Census census(surface, flatSpacing, particles);
    std::vector<std::uint8_t> alone(particles.size(), 0);
    const bool asked =
        forEachWithProgress(alone.size(), threads, kPerThread, progress, [&](std::size_t i) {
            if (i >= particles.onWalls) alone[i] = census.isAlone(i) ? 1 : 0;
        });
    if (!asked) return false;
    const auto leaving = static_cast<std::size_t>(std::count(alone.begin(), alone.end(), 1));
    if (leaving == 0 || 2 * leaving >= particles.size()) return true;
    std::vector<bool> stays(particles.size());
    std::transform(alone.begin(), alone.end(), stays.begin(), [](auto a) { return a == 0; });
    particles.keep(stays);
    return true;
}

/// The crowding of every particle; empty if cancelled.
std::vector<Candidate> crowds(const Census& census, unsigned threads, const Progress& progress,
                              const Particles& particles) {
    std::vector<Candidate> all(particles.size());
    const auto look = [&](std::size_t i) {
        all[i] = {census.crowdOf(i), i, particles.position[i]};
    };
    if (!forEachWithProgress(all.size(), threads, kPerThread, progress, look)) all.clear();
    return all;
}

}  // namespace

bool balance(const Surface& surface, std::size_t count, double flatSpacing, std::size_t limit,
             unsigned threads, const Progress& progress, Particles& particles) {
    if (!leaveSpecks(surface, flatSpacing, threads, partOf(progress, 0.0, 0.5), particles))
        return false;
    const Census census(surface, flatSpacing, particles);
    std::vector<Candidate> all = crowds(census, threads, partOf(progress, 0.5, 1.0), particles);
    if (all.empty()) return false;
    std::vector<Candidate> dying(all.begin() + static_cast<std::ptrdiff_t>(particles.onWalls),
                                 all.end());
    std::sort(dying.begin(), dying.end(),
              [](const Candidate& a, const Candidate& b) { return emptier(b, a); });
    const auto moreCrowdedThan = [&](double crowd) {
        const auto end = std::find_if(dying.begin(), dying.end(),
                                      [&](const Candidate& c) { return c.crowd <= crowd; });
        return std::min(limit, static_cast<std::size_t>(end - dying.begin()));
    };

    // Missing particles must be added, others are added where there is room.
    const std::size_t missing = count - std::min(count, particles.size());
    const std::size_t needed = missing + moreCrowdedThan(kSqueezed);
    const std::size_t wanted = missing + moreCrowdedThan(kCrowded);
    std::vector<Candidate> born =
        apart(roomiest(census, std::move(all), 4 * wanted + 16), wanted, particles);
    while (born.size() > needed && born.back().crowd >= kRoom) born.pop_back();
    const std::size_t then = particles.size() + born.size();
    dying = apart(dying, then - std::min(count, then), particles);

    std::vector<bool> stays(particles.size(), true);
    for (const Candidate& c : dying) stays[c.particle] = false;
    for (const Candidate& c : born) particles.add(surface, c.place, kInterior, flatSpacing);
    stays.resize(particles.size(), true);
    particles.keep(stays);
    return true;
}

}  // namespace se::sampling
