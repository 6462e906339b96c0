/// What a person says of points that are to be made: text fields and choices. Plain values.
#pragma once

#include <array>
#include <string>

#include "run/sample_spec.h"

namespace se::view {

enum class GrowthSource : std::uint8_t { Shape, Volume };

/// Six numbers as typed, the lower corner first.
using BoxFields = std::array<std::string, 6>;
BoxFields boxFields(const WallBox& box);
/// Fails with a sentence if they are no box.
Result<WallBox> boxFromFields(const BoxFields& fields);

struct GrowthForm {
    GrowthSource from = GrowthSource::Shape;
    std::string shape = "torus";
    std::string volume;    ///< A path.
    std::string isovalue;  ///< Empty: that of the shape, or of the volume.
    bool bySpacing = false;
    std::string count = std::to_string(kUsualPoints);
    std::string spacing = "0.1";
    std::string seed = "1";
    std::string curvature = "0";
    bool cut = false;  ///< By the walls of `box` instead of those of the shape or volume.
    BoxFields box{};

    /// Fails with a sentence about the first field that is wrong.
    Result<SampleSpec> spec() const;
    void take(const SampleSpec& spec);
    /// Another shape: whatever was said of the surface before does not hold for it.
    void choose(std::string_view id);
    void chooseVolume(const std::string& path);
    /// Cut, from now on: begins with the box of the shape.
    void cutByOwnBox();
};

}  // namespace se::view
