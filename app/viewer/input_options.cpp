#include "input_options.h"

#include <utility>

#include "run/number_format.h"
#include "run/strings.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/prepare/facing.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

/// Options for a piece of the file; names as in `spiraling-edge run`.
void addPiece(CLI::App& app, Options& o, RawInput& raw) {
    app.add_option("--crop", raw.crop, "Only the points in this box, X0,Y0,Z0,X1,Y1,Z1")
        ->type_name("BOX");
    app.add_option("--thin", o.input.piece.thin, "Only points no nearer than this to one before")
        ->type_name("SPACING")
        ->check(CLI::PositiveNumber);
}

/// Options for new points; names as in `spiraling-edge sample`.
void addGrowing(CLI::App& app, RawInput& raw) {
    SampleSpec& grow = raw.grow;
    auto* made = app.add_option("--new", grow.surface,
                                "Start with new points that spread over a shape or over an "
                                "isosurface of a volume (" +
                                    wordList(volumeExtensions(), "") + ")")
                     ->type_name("SHAPE");
    auto* count = app.add_option("-n,--points", grow.count, "With --new: exactly N points (2000)");
    count->type_name("N")->check(CLI::Range(std::size_t{1}, kMaxParticles))->needs(made);
    app.add_option("--spacing", grow.spacing, "With --new: as many points as fit at distance S")
        ->type_name("S")
        ->check(CLI::PositiveNumber)
        ->excludes(count)
        ->needs(made);
    app.add_option("--iso", raw.iso, "With --new: the isovalue")->type_name("V")->needs(made);
    app.add_option("--seed", grow.seed, "With --new: seed of the random start positions")
        ->type_name("S")
        ->needs(made);
    app.add_option("--curvature", grow.curvature, "With --new: denser where the surface bends")
        ->type_name("X")
        ->check(CLI::Range(0.0, 100.0))
        ->needs(made);
    app.add_option("--steps", grow.steps, "With --new: pause after N steps of spreading")
        ->type_name("N")
        ->check(CLI::Range(1, Sampler::allSteps()))
        ->needs(made);
}

/// Which points become neighbors, if an option says so. True if one does.
bool chooseReach(const RawInput& raw, NeighborOptions& lists) {
    if (raw.neighbors > 0) lists.reach = KNearest{raw.neighbors};
    if (raw.radius > 0.0) lists.reach = WithinRadius{raw.radius};
    if (raw.reach > 0.0) lists.reach = WithinSpacings{raw.reach};
    const bool given = raw.neighbors > 0 || raw.radius > 0.0 || raw.reach > 0.0;
    lists.recompute = lists.recompute || given;
    return given;
}

/// The box of --box, unless there is none to read; `expected` begins the complaint.
std::optional<WallBox> boxOf(const std::string& text, const char* expected) {
    std::optional<WallBox> box;
    if (text.empty()) return box;
    box = boxFromText(text, ',');
    if (!box) {
        throw CLI::ValidationError(
            "--box " + text,
            std::string(expected) +
                " six numbers separated by commas, the lower corner first: X0,Y0,Z0,X1,Y1,Z1");
    }
    return box;
}

void takeOverWalls(const RawInput& raw, Options& o) {
    o.wallsGiven = !raw.box.empty();
    if (raw.box == "auto") {
        o.input.walls = {WallChoice::From::Around, {}};
    } else if (const auto box = boxOf(raw.box, "expected auto, or")) {
        o.input.walls = {WallChoice::From::Box, *box};
    }
}

/// Everything that is derived from the points, but their walls.
void takeOverDerived(const RawInput& raw, Options& o) {
    o.reachGiven = chooseReach(raw, o.input.neighbors);
    if (raw.orient) o.input.normals = NormalSource::Oriented;
    if (raw.deriveNormals) o.input.normals = NormalSource::Derived;
    o.normalsGiven = raw.orient || raw.deriveNormals;
    if (raw.scanner.empty()) return;
    const Result<Vec3> scanner = scannerFromText(raw.scanner);
    if (!scanner) throw CLI::ValidationError("--scanner " + raw.scanner, scanner.error().message);
    o.input.scanner = scanner.value();
}

/// New points of --new. Throws as takeOverInput() does.
void takeOverGrowing(const CLI::App& app, const RawInput& raw, Options& o) {
    if (!o.input.source.empty())
        throw CLI::ValidationError("--new", "cannot be combined with a FILE");
    o.grow = raw.grow;
    o.grow->box = boxOf(raw.box, "expected");
    if (app.count("--iso") > 0) o.grow->isovalue = raw.iso;
    if (o.grow->count == 0 && o.grow->spacing == 0.0) o.grow->count = kUsualPoints;
}

}  // namespace

void addPreparing(CLI::App& app, Options& o, RawInput& raw) {
    auto* k = app.add_option("-k,--neighbors", raw.neighbors, "Neighbors of a point: the K nearest")
                  ->check(CLI::Range(std::size_t{1}, std::size_t{1000}));
    auto* r = app.add_option("-r,--radius", raw.radius,
                             "Neighbors of a point: all within R, in scene units")
                  ->check(CLI::PositiveNumber);
    k->excludes(r);
    app.add_option("--reach", raw.reach,
                   "Neighbors of a point: all within X times the mean distance to the nearest")
        ->check(CLI::PositiveNumber)
        ->excludes(k)
        ->excludes(r);
    app.add_flag("--symmetric", o.input.neighbors.symmetric, "Make neighbor lists symmetric");
    app.add_flag("--keep-opposing", o.input.keepOpposing,
                 "Keep neighbors whose normal opposes that of the point");
    app.add_flag("--keep-noise", o.input.keepNoise,
                 "Keep all points where noise is as wide as the spacing");
    app.add_flag("--keep-strays", o.input.keepStrays, "Keep points far from all others");
    auto* orient = app.add_flag("--orient", raw.orient,
                                "Flip normals of the file so that they agree with each other");
    app.add_flag("--derive-normals", raw.deriveNormals,
                 "Derive normals from the positions even if the file has some")
        ->excludes(orient);
    app.add_option("--scanner", raw.scanner,
                   "Derived or flipped normals face this position, X,Y,Z, part by part")
        ->type_name("POINT");
    app.add_flag("--derive-rim", o.input.rim,
                 "Find where the surface ends without a wall, and treat the points there as "
                 "boundary points");
    app.add_option("--box", raw.box,
                   "Points on the walls of this box are boundary points: auto (the box around all "
                   "points), or X0,Y0,Z0,X1,Y1,Z1. With --new: the box that clips the surface")
        ->type_name("BOX");
}

void addInputOptions(CLI::App& app, Options& o, RawInput& raw) {
    app.add_option("--start", o.startFile,
                   "Begin with the triangles and edge rings of this JSON file "
                   "(docs/file-formats.md)")
        ->type_name("FILE");
    app.add_option("--most-bytes", o.input.maxBytes,
                   "Read and unpack at most N bytes of an input (default 2147483648, 2 GiB)")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    addPiece(app, o, raw);
    addPreparing(app, o, raw);
    addGrowing(app, raw);
}

void takeOverPreparing(const RawInput& raw, Options& o) {
    takeOverDerived(raw, o);
    takeOverWalls(raw, o);
}

void takeOverInput(const CLI::App& app, const RawInput& raw, Options& o) {
    takeOverDerived(raw, o);
    if (!raw.crop.empty()) {
        const Result<Box> crop = cropFromText(raw.crop);
        if (!crop) throw CLI::ValidationError("--crop " + raw.crop, crop.error().message);
        o.input.piece.crop = crop.value();
    }
    if (isVolumePath(o.input.source) && !isSample(o.input.source) && raw.grow.surface.empty()) {
        o.grow = SampleSpec{};
        o.grow->surface = std::exchange(o.input.source, {});
        o.grow->count = kUsualPoints;
    }
    app.count("--new") > 0 ? takeOverGrowing(app, raw, o) : takeOverWalls(raw, o);
}

}  // namespace se::view
