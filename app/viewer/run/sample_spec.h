/// Points made by the particle sampler instead of being read: the options of `spiraling-edge
/// sample`, as one line of text that can replace the path of a file anywhere.
///
///     sample:torus,n=4000            4,000 points on the torus
///     sample:lobster.nhdr,n=43000,iso=40,seed=2
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/points/wall_types.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se {
struct Field;
struct SamplerOptions;
}  // namespace se

namespace se::view {

inline constexpr std::string_view kSamplePrefix = "sample:";
inline bool isSample(std::string_view source) { return source.starts_with(kSamplePrefix); }

/// Default number of points.
inline constexpr std::size_t kUsualPoints = 2000;

/// A surface and how it is sampled. The sampler is deterministic, so this identifies the points.
struct SampleSpec {
    std::string surface;  ///< Id of a shape, or the path of a volume.
    std::optional<double> isovalue;
    std::optional<WallBox> box;  ///< Empty: that of the shape, or the whole volume.
    std::size_t count = 0;       ///< 0: as many as `spacing` gives.
    double spacing = 0.0;
    std::uint64_t seed = 1;
    double curvature = 0.0;
    int steps = 0;  ///< The particles after that number of steps; 0: after all.
    std::uint64_t maxBytes = ByteLimit{}.bytes;  ///< Limit of reading a volume; not in the line.

    SamplerOptions sampler() const;
    friend bool operator==(const SampleSpec& a, const SampleSpec& b);
};

/// "sample:torus,n=4000": all values that differ from the defaults, without loss of digits.
std::string sampleSource(const SampleSpec& spec);
/// Parses the line. Errors name the wrong part; whether the surface exists is not checked.
Result<SampleSpec> sampleFromSource(std::string_view source);
/// The command line that writes the same points to `output`; empty if there is none, since the
/// particles stopped before their last step.
std::string sampleCommand(const SampleSpec& spec, std::string_view output);
/// The command line with a file named after the points.
std::string sampleCommand(const SampleSpec& spec);
/// "torus, 4 000 points".
std::string sampleTitle(const SampleSpec& spec, std::size_t count);
/// A file name without extension: "torus-4000".
std::string sampleStem(const SampleSpec& spec, std::size_t count);

/// The field whose isosurface is sampled. Fails with a sentence for the user: no such shape or
/// volume, no isovalue, a box outside the volume.
Result<Field> surfaceOf(const SampleSpec& spec);
/// The sampled points. Fails also if cancelled.
Result<PointFile> samplePoints(const SampleSpec& spec, const Progress& progress);

}  // namespace se::view
