/// The input as the viewer holds it: points ready for the stepper, and their positions on screen.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aside.h"
#include "doctor_fixes.h"
#include "packed_file.h"
#include "sample_spec.h"
#include "spiraling_edge/mesh/fault_places.h"
#include "spiraling_edge/points/index_ranges.h"
#include "spiraling_edge/points/point_name.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/pivot_replay.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/run_spec.h"
#include "spiraling_edge/stepper/params.h"
#include "teach/practice.h"

namespace se::view {

/// Error of an opening that the user cancelled.
Error openingCancelled();

inline std::string sceneSource(std::string_view id) {
    return std::string(kScenePrefix) + std::string(id);
}

/// The points of a pivot to practice: "practice:7".
inline bool isPractice(std::string_view source) { return teach::practiceSeed(source).has_value(); }

/// The path of a file, which is none of the sources that have a prefix.
inline bool isFilePath(std::string_view source) {
    return !source.empty() && !isScene(source) && !isSample(source) && !isPractice(source) &&
           !isStandardInput(source) && !isPacked(source);
}

/// The figure of the paper that a source is the scene of; null if it is none.
inline const Figure* figureOfSource(std::string_view source) {
    return isScene(source) ? figureOfScene(source.substr(kScenePrefix.size())) : nullptr;
}

/// Points in view space: centered on their bounding box, which then fits a sphere of radius 1. The
/// box is also around points that were left out, so that these change no position.
struct Model {
    std::string name;   ///< File name, scene id or "torus, 4 000 points", for title and menu.
    std::string hash;   ///< Of the input, see hashOfPoints().
    std::string watch;  ///< One sentence of a scene; empty for files.
    std::vector<PointName> names = {};  ///< Of points of a figure.
    std::uint32_t namesIn = 0;          ///< The only pivot that has these names; 0: all.
    PointSet points;
    Params params;
    PrepareReport report;
    std::string judged;                  ///< departureText() of the judge of meshes.
    bool fixed = false;                  ///< The input has fixes.
    std::vector<std::string> fixesDone;  ///< Effects of the fixes, each a piece of a sentence.
    std::size_t pointsInFile = 0;        ///< Of the file, before a piece of it was taken.
    std::size_t pointsInPiece = 0;       ///< Of the piece, the whole file by default.
    std::vector<Index> inPiece;  ///< Index in the piece, of each point; empty: that of the point.
    std::vector<AsidePoints> aside;  ///< Points that take no part in the run.
    std::vector<glm::vec3> place;  ///< View space position of each point; zero if it is not finite.
    std::vector<glm::vec3> normal;
    std::vector<bool> drawable;  ///< False for positions that are not finite.
    Vec3 center{};
    double scale = 1.0;             ///< View units per scene unit.
    glm::vec3 middle{0.0F};         ///< Center of the box of the points of the run.
    glm::vec3 boxHalf{0.0F};        ///< Half the sides of that box, in view units.
    float radius = 1.0F;            ///< Greatest distance of such a point from `middle`.
    float spacing = 0.05F;          ///< Median distance to the nearest neighbor, in view units.
    std::vector<glm::vec3> sample;  ///< Some of the positions, to fit the camera to.

    /// Index in the piece.
    Index numberInPiece(Index point) const { return inPiece.empty() ? point : inPiece[point]; }
    glm::vec3 toView(const Vec3& position) const { return glm::vec3((position - center) * scale); }
    /// View coordinates of the corners of a triangle.
    std::array<glm::vec3, 3> cornersOf(const Triangle& t) const {
        return {place[t.a], place[t.b], place[t.c]};
    }
};

/// Parts of opening an input.
enum class LoadPart : std::uint8_t { Reading, Sampling, Preparing, Placing, Beginning };

/// Progress of loading, written by the loading thread and read by the window.
struct LoadProgress {
    std::atomic<LoadPart> part = LoadPart::Reading;
    std::atomic<double> share = 0.0;  ///< Of all parts together.
    std::atomic<bool> cancelled = false;
};

/// An input, ready to be drawn and run, and the file that was read, with the fixes applied.
struct Loaded {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const PointFile> file;
    /// Input of prepare(), with which a mesh is written. `file` itself if there are no fixes.
    std::shared_ptr<const PointFile> given;
};
/// Reads or builds the points, prepares and validates them. Fails with a sentence for the user.
Result<Loaded> loadInput(const RunSpec& spec, LoadProgress& progress);

/// Effects of the fixes, as one piece of a sentence; empty if there were none.
std::string fixesText(const Model& model);
/// Changes of the input: "Repaired: 1 exact copy dropped. Left out: 12 of 400 points."; empty if
/// there are none.
std::string changesText(const Model& model);
/// Computes all drawing data from `points`.
void placeModel(Model& model);

/// The scene of the failure gallery with that id, or of the source `scene:ID`; null if there is
/// none.
const FailureScene* galleryScene(std::string_view idOrSource);
/// The address that the source `scene:ID` opens at: that of the decision it demonstrates. Empty for
/// a scene that opens at its start, and for every other source.
std::string_view openingAddress(std::string_view source);

/// Hash of positions, then normals, as little endian doubles: for inputs without a file.
std::string hashOfPoints(const PointFile& points);

/// Radius of what is to be seen at a place with faults, view units: that of its most severe fault,
/// and at least the spacing.
inline float sizeOnMesh(const Model& model, const FaultPlace& place) {
    return std::max(static_cast<float>(place.radius * model.scale), model.spacing);
}

// The points that a decision involves, for cameras and labels, and how far it looked at them.

/// The points that the decisions of a pivot involve: the pivot, its ends, the candidates that are
/// left, and other points named by the last event; in order, none twice. Without a pivot: the point
/// under test, if there is one.
std::vector<Index> neighborhoodOf(const DecisionState& picture);

/// True if the test of §6.1 (Fig. 4) went so far that it needed the angle and the turn of the next
/// point on the ring.
bool isMeasured(const LimitEvidence& e);

}  // namespace se::view
