/// The page on which new points spread: the user's input as text fields and choices. Plain values.
#pragma once

#include <array>
#include <string>

#include "run/sample_spec.h"

namespace se::view {

enum class GrowthSource : std::uint8_t { Shape, Volume };

/// Six numbers as typed, the lower corner first.
using BoxFields = std::array<std::string, 6>;
BoxFields boxFields(const WallBox& box);
/// Fails with a sentence if the fields are no box.
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
    bool cut = false;  ///< Clip to `box` instead of the walls of the shape or volume.
    BoxFields box{};

    /// Fails with a sentence about the first field that is wrong.
    Result<SampleSpec> spec() const;
    void take(const SampleSpec& spec);
    /// Another shape: isovalue and box of the previous surface are cleared.
    void choose(std::string_view id);
    void chooseVolume(const std::string& path);
    /// Enables clipping, starting with the box of the shape.
    void cutByOwnBox();
};

struct GrowthPage {
    bool open = false;
    GrowthForm form;
    std::string complaint;  ///< Error of the form, the surface or the file.
    std::string message;    ///< Last success message.
};

}  // namespace se::view
