// Small pictures of the built-in scenes, seen from beside and above, scaled to a square, and in the
// order of depth, so that what is in front is drawn last: at most 1500 of their points, and the
// mesh.
#include "scene_tiles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <span>
#include <utility>

#include "jobs/open_lesson.h"
#include "run/model.h"
#include "run/sample_spec.h"
#include "spiraling_edge/mesh/inspection.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/stepper/event.h"
#include "teach/practice.h"

namespace se::view {

namespace {

constexpr std::size_t kDots = 1500;
/// Most points of the small picture of a figure that is sampled.
constexpr std::size_t kTileSample = 400;

/// The usual direction to the viewer: beside and above.
Vec3 usualDirection() {
    const double yaw = glm::radians(-60.0);
    const double pitch = glm::radians(42.0);
    return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

/// The turn from the axes of the scene to those of a view from that direction.
glm::dmat3 viewTurn(const Vec3& direction) {
    const Vec3 toViewer = glm::normalize(direction);
    const bool fromAbove = std::abs(toViewer.z) > 0.999;
    const Vec3 up = fromAbove ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 right = glm::normalize(glm::cross(up, toViewer));
    return glm::transpose(glm::dmat3(right, glm::cross(toViewer, right), toViewer));
}

/// Where points are in the square of a picture.
struct PictureFrame {
    glm::dmat3 turn = viewTurn(usualDirection());
    glm::dvec2 low{INFINITY};
    glm::dvec2 high{-INFINITY};

    void include(const Vec3& at) {
        if (!std::isfinite(at.x + at.y)) return;
        low = glm::min(low, glm::dvec2(at));
        high = glm::max(high, glm::dvec2(at));
    }
    glm::vec2 place(const Vec3& turned) const {
        const double half = 0.5 * std::max(high.x - low.x, high.y - low.y);
        const glm::vec2 middle(0.5 * (low + high));
        return (glm::vec2(turned) - middle) * (half > 0.0 ? static_cast<float>(1.0 / half) : 1.0F);
    }
};

std::size_t strideFor(std::size_t count, std::size_t limit) { return (count + limit - 1) / limit; }

PictureFrame frameOf(const PointFile& points, std::size_t limit, const Vec3& direction) {
    PictureFrame frame{viewTurn(direction)};
    const std::size_t count = points.position.size();
    for (std::size_t p = 0; p < count; p += strideFor(count, limit))
        frame.include(frame.turn * points.position[p]);
    return frame;
}

/// Parts of a picture, each after its place toward the viewer: those at the back first.
template <typename Part>
std::vector<Part> backFirst(std::vector<std::pair<double, Part>> placed) {
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Part> parts;
    parts.reserve(placed.size());
    for (const auto& [place, part] : placed) parts.push_back(part);
    return parts;
}

/// The triangles, those at the back first; `failing`: by their number.
std::vector<ThumbnailFace> facesOf(const PointSet& points, std::span<const Triangle> triangles,
                                   const std::vector<bool>& failing, const PictureFrame& frame) {
    std::vector<std::pair<double, ThumbnailFace>> sorted;
    sorted.reserve(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Triangle& corners = triangles[t];
        const std::array<Vec3, 3> at = {frame.turn * points.position[corners.a],
                                        frame.turn * points.position[corners.b],
                                        frame.turn * points.position[corners.c]};
        ThumbnailFace face;
        for (std::size_t i = 0; i < 3; ++i) face.at[i] = frame.place(at[i]);
        const Vec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
        const double length = glm::length(normal);
        face.facing = length > 0.0 ? static_cast<float>(normal.z / length) : 0.0F;
        face.failure = t < failing.size() && failing[t];
        sorted.emplace_back(at[0].z + at[1].z + at[2].z, face);
    }
    return backFirst(std::move(sorted));
}

/// An input as a tile shows it.
struct TileInput {
    PointFile file;
    GivenStart start = {};
    std::string_view at = {};  ///< The address at which the mesh is shown, or nothing.
    /// The failure of a scene of the gallery on its finished mesh, or kNoFailure; empty for others.
    std::string_view failure = {};
};
constexpr std::string_view kNoFailure = "none";

/// The mesh of an input that works, as it is at the decision of a figure or of a lesson, otherwise
/// half grown.
void drawGrown(const PointSet& points, const PictureFrame& frame, const TileInput& input,
               SceneTile& tile) {
    const auto address = addressFromString(input.at);
    const std::uint32_t pivot = address ? address->pivot : 0;
    // A closed surface has two triangles for each point.
    const auto enough = [&](const State& state) {
        return pivot > 0 ? state.counters.pivots >= pivot
                         : state.triangles.size() >= points.position.size();
    };
    Params params;
    params.start = input.start;
    tile.faces = facesOf(points, reconstruct(points, params, enough).state.triangles, {}, frame);
}

/// The finished mesh, with its failures of that name.
void drawFailure(const PointSet& points, const PictureFrame& frame, std::string_view failure,
                 SceneTile& tile) {
    const std::vector<Triangle> triangles = reconstruct(points, Params{}).state.triangles;
    std::vector<bool> failing(triangles.size());
    const auto place = [&](Index p) { return frame.place(frame.turn * points.position[p]); };
    for (const MeshFailure& each : inspectMesh(points, triangles)) {
        if (each.kind->name != failure) continue;
        for (const auto& [from, to] : each.edges) tile.marks.push_back({place(from), place(to)});
        if (!each.edges.empty()) continue;
        for (const Index t : each.triangles) failing[t] = true;
        if (!each.triangles.empty()) continue;
        for (const Index p : each.points) tile.marks.push_back({place(p), place(p)});
    }
    tile.faces = facesOf(points, triangles, failing, frame);
}

/// The direction from which a tile shows its scene.
Vec3 directionOf(const SceneTile& tile) {
    const bool scene = tile.figure != nullptr && tile.figure->hasScene();
    return scene ? tile.figure->view : usualDirection();
}

/// Points and mesh of an input.
void drawInput(const TileInput& input, SceneTile& tile) {
    const PointFile& file = input.file;
    tile.dots = thumbnail(file, kDots, directionOf(tile));
    tile.reach = glm::vec2(0.0F);
    for (const ThumbnailDot& dot : tile.dots) tile.reach = glm::max(tile.reach, glm::abs(dot.at));
    const Result<Prepared> prepared = prepare(file, PrepareOptions{});
    if (!prepared) return;
    const PointSet& points = prepared.value().points;
    const PictureFrame frame = frameOf(file, kDots, directionOf(tile));
    if (input.failure.empty()) return drawGrown(points, frame, input, tile);
    drawFailure(points, frame, input.failure, tile);
}

/// A figure of the results, without its picture.
SceneTile tileOf(const Figure& figure) {
    return {figure.sample, figure.scene.title, figure.scene.watch, 0.0, &figure};
}

/// The mesh of sampled points, fewer than the figure has.
void drawSample(SceneTile& tile) {
    Result<SampleSpec> spec = sampleFromSource(tile.id);
    if (!spec) return;
    spec.value().count = std::min(spec.value().count, kTileSample);
    if (const Result<PointFile> file = samplePoints(spec.value(), {}))
        drawInput({file.value(), {}, {}, kNoFailure}, tile);
}

SceneTile tileOf(const Scene& scene, const FailureScene* failing) {
    SceneTile tile{scene.id, scene.title, scene.watch, 0.0, figureOfScene(scene.id)};
    drawInput({scene.build(), startOfScene(scene.id),
               tile.figure != nullptr ? addressOfScene(scene.id) : std::string_view{},
               failing != nullptr ? failing->failure : std::string_view{}},
              tile);
    return tile;
}

/// A lesson begins with a built-in scene, of the gallery or not, or with a pivot to practice.
SceneTile tileOf(const LessonEntry& lesson) {
    SceneTile tile{lesson.source, lesson.title, lesson.text, lesson.minutes};
    if (const auto seed = teach::practiceSeed(lesson.input)) {
        drawInput({teach::practiceFile(*seed), {}, lesson.at}, tile);
        return tile;
    }
    const std::string_view id = std::string_view(lesson.input).substr(kScenePrefix.size());
    if (const FailureScene* failing = galleryScene(id)) {
        drawInput({failing->scene.build(), {}, lesson.at, failing->failure}, tile);
    } else if (const Scene* scene = findScene(id)) {
        drawInput({scene->build(), startOfScene(id), lesson.at}, tile);
    }
    return tile;
}

}  // namespace

std::vector<ThumbnailDot> thumbnail(const PointFile& points, std::size_t limit,
                                    const Vec3& direction) {
    const std::size_t count = points.position.size();
    if (count == 0 || limit == 0) return {};
    const PictureFrame frame = frameOf(points, limit, direction);
    std::vector<std::pair<double, ThumbnailDot>> dots;
    dots.reserve(std::min(count, limit));
    for (std::size_t p = 0; p < count; p += strideFor(count, limit)) {
        const Vec3 at = frame.turn * points.position[p];
        if (!std::isfinite(at.x + at.y)) continue;
        const double facing = points.hasNormals() ? (frame.turn * points.normal[p]).z : 1.0;
        dots.push_back({at.z, {frame.place(at), static_cast<float>(facing)}});
    }
    return backFirst(std::move(dots));
}

std::string sourceOf(const SceneTile& tile) {
    const bool source = tile.minutes > 0.0 || isSample(tile.id);
    return source ? std::string(tile.id) : sceneSource(tile.id);
}

void StartPage::prepare() {
    if (!tiles.empty()) return;
    tiles.reserve(lessonEntries().size() + scenes().size() + failureScenes().size());
    for (const LessonEntry& lesson : lessonEntries()) tiles.push_back(tileOf(lesson));
    const auto lessons = static_cast<std::ptrdiff_t>(tiles.size());
    for (const Scene& scene : scenes()) tiles.push_back(tileOf(scene, nullptr));
    std::stable_partition(tiles.begin() + lessons, tiles.end(),
                          [](const SceneTile& tile) { return tile.figure != nullptr; });
    const auto others = std::find_if(tiles.begin() + lessons, tiles.end(),
                                     [](const SceneTile& tile) { return tile.figure == nullptr; });
    std::vector<SceneTile> sampled;
    for (const Figure& figure : figures())
        if (!figure.sample.empty()) sampled.push_back(tileOf(figure));
    tiles.insert(others, sampled.begin(), sampled.end());
    for (const FailureScene& each : failureScenes()) tiles.push_back(tileOf(each.scene, &each));
    std::reverse(sampled.begin(), sampled.end());  // the next one last
    sampling.startSlices([sampled = std::move(sampled)](auto& results) mutable {
        if (sampled.empty()) return false;
        drawSample(sampled.back());
        results.add(std::move(sampled.back()));
        sampled.pop_back();
        return results.report(0.0);
    });
}

void StartPage::poll() {
    for (SceneTile& each : sampling.take().items) {
        const auto found = std::find_if(tiles.begin(), tiles.end(),
                                        [&](const SceneTile& tile) { return tile.id == each.id; });
        if (found != tiles.end()) *found = std::move(each);
    }
}

}  // namespace se::view
