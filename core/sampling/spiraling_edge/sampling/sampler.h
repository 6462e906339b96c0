/// Even points on an isosurface: the particles that the paper's inputs come from (§3, §8; Crossno
/// and Angel, "Isosurface Extraction Using Particle Systems", Visualization 1997, in the spirit of
/// Witkin and Heckbert 1994). They repel each other, are pulled back onto the surface along the
/// gradient, split and die until they have the requested number and are evenly spread. Those that
/// start where the walls of the domain cut the surface spread along these curves, never leave them,
/// and carry the bits of their walls; corners stay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "spiraling_edge/base/progress.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/sampling/field.h"

namespace se {

/// Maximum number of particles: they take about 2.2 GB while they spread, and a run on them as much
/// again.
inline constexpr std::size_t kMaxParticles = 10'000'000;

/// Number and density of particles.
struct SamplerOptions {
    /// Exact number; 0: determined by `spacing`.
    std::size_t count = 0;
    /// Distance between neighbors, in units of the field; used if `count` is 0. With `curvature`
    /// it holds where the surface is flat.
    double spacing = 0.0;
    /// Equal seeds give equal particles, whatever the number of threads.
    std::uint64_t seed = 1;
    /// 0: even spacing. Else the spacing is divided by 1 + curvature * c, where c is the curvature
    /// of the surface in units of its mean, but at most by 5. In [0, 100].
    double curvature = 0.0;
    /// Number of threads; 0: as many as the machine has.
    unsigned threads = 0;
};

/// The particles while they spread. Steps are of bounded work, so that a window can draw between
/// them:
///
///     auto sampler = Sampler::begin(field, options);
///     while (!sampler.value().done()) sampler.value().step();
///     PointFile points = sampler.value().points();
class Sampler {
  public:
    /// Finds the surface and scatters particles over it. Fails if there is none in the box, if
    /// numbers are out of range or too small for the walls, or if cancelled.
    static Result<Sampler> begin(Field field, const SamplerOptions& options,
                                 const Progress& progress = {});
    ~Sampler();
    Sampler(Sampler&& other) noexcept;
    Sampler& operator=(Sampler&& other) noexcept;

    /// True after the last step: all particles are on the surface and evenly spread.
    bool done() const;
    /// One step of relaxation; in every tenth, particles also split and die. No effect when done.
    /// False if `progress`, which gets the share of this step, cancelled: then the particles are no
    /// longer valid.
    bool step(const Progress& progress = {});
    /// Share of the steps done, in [0, 1].
    double share() const;
    /// Steps done, and all steps.
    int steps() const;
    static int allSteps();

    /// The positions of all particles; invalidated by step(). Their number and order may change
    /// until done; then they are in the order of a Z-curve.
    std::span<const Vec3> positions() const;
    /// TypeBits of each.
    std::span<const std::uint8_t> types() const;
    /// The target spacing (where the surface is flat).
    double spacing() const;
    /// The particles as they are now, with unit normals to the outer side and types.
    PointFile points() const;

  private:
    struct Content;
    explicit Sampler(std::unique_ptr<Content> content);
    std::unique_ptr<Content> content_;
};

/// Runs all steps.
Result<PointFile> sample(const Field& field, const SamplerOptions& options,
                         const Progress& progress = {});

/// Evenness of particles, and their distance to the surface.
struct SampleQuality {
    double spacing = 0.0;  ///< Mean distance of an interior point to its nearest; 0: there is none.
    double variation = 0.0;  ///< Standard deviation of that distance over the mean.
    double off = 0.0;        ///< The largest distance to the surface, in spacings.
};
/// The quality of points with normals and types, as from Sampler::points(). Boundary points do not
/// count for spacing and variation. All 0 if cancelled.
SampleQuality measureSample(const Field& field, const PointFile& points,
                            const Progress& progress = {});

}  // namespace se
