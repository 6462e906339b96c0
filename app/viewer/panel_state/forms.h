/// Forms: for the points of the input, what is derived from them; for new points, what they are
/// spread over. Plain values.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "run/model.h"
#include "run/sample_spec.h"
#include "spiraling_edge/spec/spec_fields.h"

namespace se::view {

// The page on which new points spread: the user's input as text fields and choices. Plain values.

enum class GrowthSource : std::uint8_t { Shape, Volume };

/// Six numbers as typed, the lower corner first.
using BoxFields = std::array<std::string, 6>;
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

// The user's choice of what is derived from the points of the input. Plain values.

struct PrepareForm {
    static constexpr std::uint32_t kNoGeneration = ~std::uint32_t{0};
    enum class Reach : std::uint8_t { File, Nearest, Radius, Spacings };

    bool open = false;                    ///< Being edited: it keeps what was typed.
    std::uint32_t shown = kNoGeneration;  ///< The opening of the input that it shows.
    Reach reach = Reach::File;
    std::string count = "12";
    std::string radius;
    std::string spacings = "1.6";  ///< Value of Table 1.
    bool symmetric = false;
    bool keepOpposing = false;
    NormalSource normals = NormalSource::AsGiven;
    std::array<std::string, 3> scanner{};  ///< x, y, z; all empty: normals face outward.
    WallChoice::From walls = WallChoice::From::File;
    BoxFields box{};
    bool rim = false;
    bool keepNoise = false;
    bool keepStrays = false;
    /// keepOpposing, keepNoise and keepStrays by the rules of the input. A field that the user has
    /// not changed leaves its rule as it is.
    std::array<bool, 3> kept{};
    std::string complaint;

    /// Starts with the options of `opened`, including the doctor's fixes; the box with that around
    /// the points of `model`.
    void take(const RunSpec& opened, const Model& model);
    /// Drops what was typed.
    void close() {
        open = false;
        shown = kNoGeneration;
    }
    /// `base` with these options, without the fixes that they contradict. Fails with a sentence
    /// about the first field that is wrong.
    Result<RunSpec> spec(RunSpec base) const;

    friend bool operator==(const PrepareForm&, const PrepareForm&) = default;

  private:
    /// The values of the fields that are set.
    SpecChange values() const;
};

}  // namespace se::view
