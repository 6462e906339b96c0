// Positions stay doubles for the stepper. For drawing they are moved to the center of their box
// and scaled to the unit sphere before they become floats, so that inputs far from the origin keep
// their precision.

#include "model.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <initializer_list>
#include <limits>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/base/types.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/gzip.h"
#include "strings.h"
#include "teach/file_bytes.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSampleSize = 4000;
/// Shares of the progress bar after the bytes, the points and the lists.
constexpr double kReadShare = 0.1;
constexpr double kParsedShare = 0.25;
constexpr double kPreparedShare = 0.9;

/// The bytes of a file, and their hash.
Result<std::string> readHashed(const fs::path& path, const ByteLimit& limit, std::string& hash,
                               LoadProgress& progress) {
    Result<std::string> bytes = readBytes(path, limit, [&](double share) {
        progress.share = kReadShare * share;
        return !progress.cancelled.load();
    });
    if (!bytes) return bytes;
    constexpr std::size_t kPiece = std::size_t{1} << 20U;
    teach::ByteHash sum;
    for (std::string_view rest = bytes.value(); !rest.empty() && !progress.cancelled;
         rest.remove_prefix(std::min(kPiece, rest.size())))
        sum.add(rest.substr(0, kPiece));
    hash = sum.text();
    return bytes;
}

/// Sampled points, unless they are in memory.
Result<PointFile> readSample(const RunSpec& spec, Model& model, LoadProgress& progress) {
    Result<SampleSpec> sample = sampleFromSource(spec.source);
    if (!sample) return sample.error();
    sample.value().maxBytes = spec.maxBytes;
    progress.part = LoadPart::Sampling;
    Result<PointFile> points =
        spec.points ? *spec.points : samplePoints(sample.value(), [&](double share) {
            progress.share = kParsedShare * share;
            return !progress.cancelled.load();
        });
    if (progress.cancelled) return openingCancelled();
    if (!points) return points;
    model.name = sampleTitle(sample.value(), points.value().position.size());
    model.hash = hashOfPoints(points.value());
    return points;
}

/// Standard input, which was read when the program started.
Result<PointFile> takeStandardInput(const RunSpec& spec, Model& model) {
    model.name = "standard input";
    if (!spec.points) return Error{"Standard input can be read only once, at the start."};
    model.hash = hashOfPoints(*spec.points);
    return *spec.points;
}

/// The points of a file inside a link.
Result<PointFile> unpackPoints(const RunSpec& spec, Model& model) {
    const Result<PackedFile> file = unpackedFile(spec.source);
    if (!file) return file.error();
    model.name = file.value().name;
    teach::ByteHash sum;
    sum.add(file.value().bytes);
    model.hash = sum.text();
    return readPoints(file.value().bytes, file.value().name);
}

/// Letters name the points of one pivot; numbers, and the letters of a figure with a given start,
/// name them in the whole run.
void nameLikeFigure(Model& model, const Figure& figure) {
    model.names = figure.pointNames();
    const auto address = addressFromString(figure.scene.address);
    const bool numbers = !model.names.empty() &&
                         std::isdigit(static_cast<unsigned char>(model.names[0].name.front())) != 0;
    if (address && !numbers && figure.scene.start == nullptr) model.namesIn = address->pivot;
}

Result<PointFile> readSource(const RunSpec& spec, Model& model, LoadProgress& progress) {
    const std::string& source = spec.source;
    if (isSample(source)) return readSample(spec, model, progress);
    if (isStandardInput(source)) return takeStandardInput(spec, model);
    if (isPacked(source)) return unpackPoints(spec, model);
    if (const auto seed = teach::practiceSeed(source)) {
        model.name = source;
        PointFile points = teach::practiceFile(*seed);
        model.hash = hashOfPoints(points);
        return points;
    }
    if (source.empty() || isScene(source)) {
        const std::string id = source.empty() ? "" : source.substr(kScenePrefix.size());
        if (source.empty() && scenes().empty()) return Error{"No file was named."};
        const Scene* scene = source.empty() ? &scenes().front() : findScene(id);
        if (scene == nullptr) {
            std::vector<std::string_view> known;
            for (const Scene& each : scenes()) known.push_back(each.id);
            return Error{"There is no scene " + inQuotes(id) +
                         ". Scenes are: " + wordList(known, "") + "."};
        }
        model.name = sceneSource(scene->id);
        model.watch = std::string(scene->watch);
        if (const Figure* figure = figureOfScene(scene->id)) nameLikeFigure(model, *figure);
        PointFile points = scene->build();
        model.hash = hashOfPoints(points);
        return points;
    }
    model.name = fs::path(source).filename().string();
    const Result<std::string> bytes =
        readHashed(source, ByteLimit{spec.maxBytes}, model.hash, progress);
    if (progress.cancelled) return openingCancelled();
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), source, ByteLimit{spec.maxBytes}, unpackGzip);
}

float medianSpacing(const Model& model) {
    std::vector<float> nearest;
    const std::size_t count = model.place.size();
    const std::size_t stride = std::max<std::size_t>(1, count / 20000);
    for (std::size_t p = 0; p < count; p += stride) {
        const auto list = model.points.neighbors[static_cast<Index>(p)];
        if (!list.empty()) nearest.push_back(glm::distance(model.place[p], model.place[list[0]]));
    }
    if (nearest.empty()) return 0.05F;
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    return std::clamp(*middle, 1e-5F, 0.5F);
}

}  // namespace

Error openingCancelled() { return Error{"Opening was cancelled."}; }

std::string fixesText(const Model& model) {
    if (model.fixed && model.fixesDone.empty()) return "nothing to repair";
    return joined(model.fixesDone, "; ");
}

std::string changesText(const Model& model) {
    std::string text;
    const auto add = [&text](const std::string& sentence) {
        text.append(text.empty() ? "" : " ").append(sentence);
    };
    if (model.pointsInPiece < model.pointsInFile) {
        add("A piece: " + grouped(model.pointsInPiece) + " of " + grouped(model.pointsInFile) +
            " points.");
    }
    if (model.fixed) add("Repaired: " + fixesText(model) + ".");
    for (const AsidePoints& each : model.aside) {
        if (!each.isLeftOut()) continue;
        add("Left out: " + grouped(each.count) + " of " + grouped(model.pointsInPiece) +
            " points.");
    }
    return text;
}

namespace {

/// Number of radii of the points up to which dropped outliers are still inside of view space.
constexpr double kNearRadii = 8.0;

/// The box around points, and the greatest distance from its center. Points that are not finite are
/// passed over.
struct Extent {
    explicit Extent(std::span<const std::span<const Vec3>> lists) {
        constexpr double kHuge = std::numeric_limits<double>::max();
        low = Vec3(kHuge);
        high = Vec3(-kHuge);
        forEach(lists, [this](const Vec3& p) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        });
        if (low.x > high.x) low = high = Vec3(0.0);
        center = 0.5 * (low + high);
        forEach(lists,
                [this](const Vec3& p) { radius = std::max(radius, glm::length(p - center)); });
    }
    template <typename Function>
    static void forEach(std::span<const std::span<const Vec3>> lists, Function&& function) {
        for (const std::span<const Vec3> list : lists) {
            for (const Vec3& p : list) {
                if (isFinite(p)) function(p);
            }
        }
    }

    Vec3 low;
    Vec3 high;
    Vec3 center;
    double radius = 0.0;
};

/// The points that take part in the run; all if none does.
std::vector<Vec3> positionsInRun(const PointSet& points) {
    std::vector<Vec3> position;
    for (Index p = 0; p < points.size(); ++p) {
        if (!points.isAside(p)) position.push_back(points.position[p]);
    }
    return position.empty() ? points.position : position;
}

/// Moves the points, and those that were left out or set aside nearby, into the unit sphere.
void frameModel(Model& model) {
    const std::vector<Vec3> inRun = positionsInRun(model.points);
    std::vector<std::span<const Vec3>> shown{inRun};
    const Extent own(shown);
    const auto isNear = [&](const Vec3& p) {
        return glm::length(p - own.center) <= kNearRadii * own.radius;
    };
    std::vector<Vec3> nearAside;
    for (const AsidePoints& each : model.aside) {
        if (each.isLeftOut() || std::all_of(each.position.begin(), each.position.end(), isNear))
            shown.emplace_back(each.position);
        // Where missing values lie, nothing is to be seen.
        for (const Index p : each.points) {
            if (each.reason != Aside::Sentinel && isNear(model.points.position[p]))
                nearAside.push_back(model.points.position[p]);
        }
    }
    shown.emplace_back(nearAside);
    const Extent all(shown);
    model.center = all.center;
    model.scale = all.radius > 0.0 && std::isfinite(all.radius) ? 1.0 / all.radius : 1.0;
    model.boxHalf = glm::vec3(0.5 * model.scale * (own.high - own.low));
    model.middle = model.toView(own.center);
    const double radius = own.radius * model.scale;
    model.radius = radius > 0.0 && std::isfinite(radius) ? static_cast<float>(radius) : 1.0F;
}

}  // namespace

void placeModel(Model& model) {
    frameModel(model);
    const auto& position = model.points.position;
    model.place.reserve(position.size());
    model.normal.reserve(position.size());
    for (std::size_t p = 0; p < position.size(); ++p) {
        const bool good = isFinite(position[p]);
        const bool goodNormal = isFinite(model.points.normal[p]);
        model.drawable.push_back(good);
        model.place.push_back(good ? model.toView(position[p]) : glm::vec3(0.0F));
        model.normal.push_back(goodNormal ? glm::vec3(model.points.normal[p]) : glm::vec3(0.0F));
    }
    model.spacing = medianSpacing(model);
    const std::size_t stride = std::max<std::size_t>(1, position.size() / kSampleSize);
    for (std::size_t p = 0; p < position.size(); p += stride) {
        const bool missing = model.points.asideOf(static_cast<Index>(p)) == Aside::Sentinel;
        if (model.drawable[p] && !missing) model.sample.push_back(model.place[p]);
    }
}

namespace {

/// Reads the piece of the source.
Result<PointFile> readPiece(const RunSpec& spec, Model& model, LoadProgress& progress) {
    Result<PointFile> file = readSource(spec, model, progress);
    if (!file) return file;
    model.pointsInFile = file.value().position.size();
    return cutPiece(std::move(file.value()), spec.piece, model.name);
}

/// Leaves out the points that the user has chosen, by their indices in the piece.
Status leaveOut(const IndexRanges& leftOut, PointFile& file, Model& model) {
    const std::size_t count = file.position.size();
    model.pointsInPiece = count;
    if (leftOut.empty()) return success();
    std::vector<bool> keep = marksOf(leftOut, count);
    keep.flip();
    AsidePoints aside = leftOutOf(file, keep);
    if (aside.count == 0) return success();
    if (aside.count == count) return Error{"All " + grouped(count) + " points are left out."};
    for (Index p = 0; p < count; ++p) {
        if (keep[p]) model.inPiece.push_back(p);
    }
    model.aside.push_back(std::move(aside));
    file = keptPoints(std::move(file), keep);
    return success();
}

/// Takes over what the fixes have dropped.
void takeFixed(FixesDone done, Model& model) {
    model.fixesDone = std::move(done.texts);
    if (done.dropped.empty()) return;
    for (Index& p : done.kept) p = model.numberInPiece(p);
    model.inPiece = std::move(done.kept);
    for (AsidePoints& each : done.dropped) model.aside.push_back(std::move(each));
}

/// Points that may take part in the run, and how to prepare them. Repaired if `spec` has fixes.
Result<PrepareOptions> takePoints(const RunSpec& spec, PointFile& file, Model& model,
                                  const LoadProgress& progress) {
    if (const Status some = leaveOut(spec.leftOut, file, model); !some) return some.error();
    model.fixed = !spec.fixes.empty();
    Result<FixesDone> done =
        fixInput(file, spec.fixes, [&](double) { return !progress.cancelled.load(); });
    if (progress.cancelled) return openingCancelled();
    if (!done) return done.error();
    takeFixed(std::move(done.value()), model);
    // Around the points that are left, like the file that the doctor writes.
    return prepareOptionsOf(withFixesAsOptions(spec), model.params, file);
}

/// Fails if the run of the model cannot begin with its given start, which names points by numbers.
Status requireStartOf(const Model& model, const PointSet& points) {
    const GivenStart& start = model.params.start;
    if (start.empty()) return success();
    if (points.size() != model.pointsInFile) {
        return Error{model.name +
                     " begins with given triangles, which name points by numbers: it needs all of "
                     "its points."};
    }
    const Status status = requireStart(points, start);
    if (status) return status;
    return Error{model.name + ": the given start does not fit. " + status.error().message};
}

}  // namespace

Result<Loaded> loadInput(const RunSpec& spec, LoadProgress& progress) {
    auto model = std::make_shared<Model>();
    const Result<Params> params = paramsOf(spec);
    if (!params) return params.error();
    model->params = params.value();
    Result<PointFile> file = readPiece(spec, *model, progress);
    if (!file) return file.error();
    progress.part = LoadPart::Preparing;
    progress.share = kParsedShare;
    const Result<PrepareOptions> options = takePoints(spec, file.value(), *model, progress);
    if (!options) return options.error();
    Result<Prepared> prepared = prepare(file.value(), options.value(), [&](double share) {
        progress.share = kParsedShare + (kPreparedShare - kParsedShare) * share;
        return !progress.cancelled.load();
    });
    if (progress.cancelled) return openingCancelled();
    if (!prepared) return prepared.error();
    const auto judge =
        judgeOfRun(file.value(), options.value(), model->params, prepared.value().points,
                   [&](double) { return !progress.cancelled.load(); });
    if (progress.cancelled) return openingCancelled();
    if (!judge) return judge.error();
    prepared.value().points.judge = judge.value();
    model->judged = departureText(*judge.value());
    std::shared_ptr<const PointFile> given;
    if (model->fixed) given = std::make_shared<const PointFile>(file.value());
    for (std::string& each :
         storeFixed(prepared.value(), options.value(), spec.fixes, file.value()))
        model->fixesDone.push_back(std::move(each));
    progress.part = LoadPart::Placing;
    progress.share = kPreparedShare;
    if (const Status status = validate(prepared.value().points); !status) return status.error();
    if (const Status status = requireStartOf(*model, prepared.value().points); !status)
        return status.error();
    model->points = std::move(prepared.value().points);
    model->report = prepared.value().report;
    if (model->points.empty()) return Error{model->name + " holds no points."};
    for (AsidePoints& each : asideOf(model->points)) model->aside.push_back(std::move(each));
    placeModel(*model);
    if (progress.cancelled) return openingCancelled();
    progress.share = 1.0;
    auto examined = std::make_shared<const PointFile>(std::move(file.value()));
    if (!given) given = examined;
    return Loaded{std::move(model), std::move(examined), std::move(given)};
}

const FailureScene* galleryScene(std::string_view idOrSource) {
    if (isScene(idOrSource)) idOrSource.remove_prefix(kScenePrefix.size());
    return rowWhere(failureScenes(),
                    [&](const FailureScene& each) { return each.scene.id == idOrSource; });
}

std::string_view openingAddress(std::string_view source) {
    return isScene(source) ? addressOfScene(source.substr(kScenePrefix.size())) : "";
}

std::string hashOfPoints(const PointFile& points) {
    teach::ByteHash hash;
    for (const auto* vectors : {&points.position, &points.normal}) {
        for (const Vec3& v : *vectors) {
            for (int i = 0; i < 3; ++i) hash.add(v[i]);
        }
    }
    return hash.text();
}

std::vector<Index> neighborhoodOf(const DecisionState& picture) {
    std::vector<Index> all;
    const auto add = [&](std::initializer_list<Index> points) {
        for (const Index point : points) {
            if (point != kNone && !isAmong(point, all)) all.push_back(point);
        }
    };
    add({picture.pivot, picture.start, picture.end, picture.first, picture.last, picture.underTest,
         picture.nextPivot});
    for (const CandidateMark& mark : picture.candidates) {
        if (mark.state == CandidateState::Kept) add({mark.point});
    }
    for (const Triangle& t : picture.newTriangles) add({t.a, t.b, t.c});
    if (!picture.event) return all;
    // Points that an event names beside its subject.
    std::visit(Overloaded{
                   [&](const ReciprocalEvidence& e) {
                       add({e.pred, e.succ});
                   },
                   [&](const LimitEvidence& e) {
                       add({e.from, e.to});
                   },
                   [&](const SphereEvidence& e) {
                       add({e.s, e.t});
                   },
                   [](const auto&) {},
               },
               picture.event->evidence);
    return all;
}

bool isMeasured(const LimitEvidence& e) {
    return e.verdict != Verdict::OtherLimit && e.verdict != Verdict::NotAnEdge &&
           e.verdict != Verdict::NotListed;
}

}  // namespace se::view
