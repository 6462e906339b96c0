#include "options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "application.h"
#include "commands/commands.h"
#include "document/link.h"
#include "export/formats.h"
#include "jobs/open_lesson.h"
#include "jobs/thread.h"
#include "lesson/lesson_player.h"
#include "options/option_list.h"
#include "options/spec_options.h"
#include "run/strings.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/gzip.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"
#include "spiraling_edge/scenes/scenes.h"
#include "teach/lesson_read.h"
#include "teach/lesson_runs.h"
#include "teach/lesson_text.h"
#include "teach/spec_json.h"

namespace se::view {

namespace {

/// A title and the rows of a table: `prefix` and id, then the title in a column `width` further on.
template <typename Rows>
std::string listOf(std::string text, std::string_view prefix, const Rows& rows, std::size_t width) {
    for (const auto& row : rows) {
        text.append("\n  ").append(prefix).append(row.id);
        text.append(row.id.size() < width ? width - row.id.size() : 1, ' ').append(row.title);
    }
    return text;
}

/// Options of `spiraling-edge export`, which hands over to this program.
struct RawExport {
    RawExport() { order.viewer = webAddress(); }

    ExportOrder order;
    std::string from;
    std::string to;
    std::string around;
    std::string unit;
};

constexpr const char* kHidden = "";

void requireExport(const CLI::App& app, const RawExport& raw) {
    for (const char* name : {"--from", "--to", "--around", "--unit", "--lesson-steps", "--captions",
                             "--fps", "--dial", "--app", "--viewer"}) {
        if (raw.order.path.empty() && app.count(name) > 0)
            throw CLI::ValidationError(name, "is for spiraling-edge export");
    }
}

/// Throws if options of frames or of their links are given with --app.
void requireNoFrames(const CLI::App& app) {
    for (const char* name :
         {"--from", "--around", "--lesson-steps", "--captions", "--fps", "--dial", "--size",
          "--scale", "--supersample", "--background", "--labels"}) {
        if (app.count(name) > 0)
            throw CLI::ValidationError(
                name == std::string_view("--lesson-steps") ? "--steps" : name,
                "is for frames; --app writes the program, which draws them");
    }
    if (app.count("--viewer") > 0)
        throw CLI::ValidationError("--viewer", "is for pages of frames; --app writes the program");
}

/// Throws if --viewer is given for another format than a page, or is no address for links.
void requireViewer(const CLI::App& app, const RawExport& raw) {
    if (app.count("--viewer") > 0 && lowerExtension(raw.order.path) != ".html")
        throw CLI::ValidationError("--viewer", "is for pages; name a file that ends in .html");
    if (const Status good = checkViewerAddress(raw.order.viewer); !good)
        throw CLI::ValidationError("--viewer", good.error().message);
}

FrameRange rangeOf(const RawExport& raw) {
    const PlayUnit unit = unitFromName(raw.unit).value_or(PlayUnit::SubStep);
    if (raw.around.empty()) return {raw.from, raw.to, unit};
    Result<FrameRange> range = rangeAround(raw.around);
    if (!range) throw CLI::ValidationError("--around", range.error().message);
    return range.value();
}

/// Options without a line in the help: `spiraling-edge export --help` has them.
void addExportOptions(CLI::App& app, RawExport& raw) {
    const auto add = [&](const char* name, auto& value) {
        return app.add_option(name, value)->group(kHidden);
    };
    ExportOrder& order = raw.order;
    add("--export", order.path);
    auto* from = add("--from", raw.from);
    from->needs(add("--to", raw.to)->needs(from));
    add("--around", raw.around)->excludes(from);
    add("--unit", raw.unit)->needs(from)->check(CLI::IsMember(teach::kPlayUnits));
    add("--lesson-steps", order.stepsText)->excludes(from)->excludes("--around");
    add("--captions", order.captions)->check(CLI::IsMember({"on", "off"}));
    add("--dial", order.dial)->check(CLI::IsMember({"on", "off"}));
    add("--fps", order.perSecond)->check(CLI::Range(kLeastPerSecond, kMostPerSecond));
    add("--viewer", order.viewer);
    app.add_flag("--app", order.program)->group(kHidden);
}

/// Checks and takes over all of them, except steps. Throws as takeOver() does.
void takeOverExport(const CLI::App& app, const RawExport& raw, Options& o) {
    requireExport(app, raw);
    if (app.count("--export") == 0) return;
    const bool ranged = !raw.from.empty() || !raw.around.empty();
    if ((ranged || !raw.order.stepsText.empty()) && app.count("--goto") > 0)
        throw CLI::ValidationError("--goto", "is one frame; --from, --around and --steps are more");
    if (raw.order.program) requireNoFrames(app);
    requireViewer(app, raw);
    if (o.input.source.empty()) throw CLI::ValidationError("export", "needs an input");
    if (raw.order.path.empty()) throw CLI::ValidationError("-o", "needs the name of a file");
    o.exported = raw.order;
    if (ranged) o.exported->range = rangeOf(raw);
}

/// Options that need a check before they go into Options.
struct RawOptions {
    SpecOptions run;
    SampleSpec grow;
    std::map<std::string_view, std::string> shared;  ///< Those of linkParts(), by name.
    std::string size;
    std::string other;
    std::string place;
    std::string background;
    RawExport exported;
    bool actions = false;
};

/// Options for new points; names as in `spiraling-edge sample`.
void addGrowing(CLI::App& app, RawOptions& raw) {
    SampleSpec& grow = raw.grow;
    auto* made = app.add_option("--new", grow.surface,
                                "Start with new points that spread over a shape or over an "
                                "isosurface of a volume (" +
                                    wordList(volumeExtensions(), "") + ")")
                     ->type_name("SHAPE");
    const auto add = [&](const char* name, auto& value, const char* help, const char* type) {
        return app.add_option(name, value, help)->type_name(type)->needs(made);
    };
    auto* count = add("-n,--points", grow.count, "With --new: exactly N points (2000)", "N");
    count->check(CLI::Range(std::size_t{1}, kMaxParticles));
    add("--spacing", grow.spacing, "With --new: as many points as fit at distance S", "S")
        ->check(CLI::PositiveNumber)
        ->excludes(count);
    add("--iso", grow.isovalue, "With --new: the isovalue", "V");
    add("--seed", grow.seed, "With --new: seed of the random start positions", "S")
        ->check(wholeNumber(0));
    add("--curvature", grow.curvature, "With --new: denser where the surface bends", "X")
        ->check(CLI::Range(0.0, 100.0));
    add("--steps", grow.steps, "With --new: pause after N steps of spreading", "N")
        ->check(CLI::Range(1, Sampler::allSteps()));
}

std::string optionOf(const LinkPart& part) { return "--" + std::string(part.name); }

/// Options for what links say as well.
void addShared(CLI::App& app, RawOptions& raw) {
    for (const LinkPart& part : linkParts()) {
        if (part.kind != LinkPart::Kind::Option) continue;
        const std::string help(part.help.substr(0, part.help.size() - 1));
        if (part.value.empty()) {
            app.add_flag(optionOf(part), help);
        } else {
            app.add_option(optionOf(part), raw.shared[part.name], help)
                ->type_name(std::string(part.value));
        }
    }
}

void addOptions(CLI::App& app, Options& o, RawOptions& raw) {
    app.add_option(
        "FILE", o.input.source,
        "Points: " + listText(pointFormats(), &PointFormat::name, "or") +
            "; - for standard input; scene:ID; sample:SHAPE,n=N; a volume, as by "
            "--new; a session file; a lesson, as a file or lesson:ID; a link. Without it, the "
            "start page");
    app.add_option("OTHER", raw.other,
                   "A mesh of the same points, or a trace: beside the run, as by --with")
        ->type_name("FILE");
    raw.run.addTo(app,
                  {SpecGroup::Reading, SpecGroup::Rules, SpecGroup::Lists, SpecGroup::Derived});
    app.add_option("--start", o.startFile,
                   "Begin with the triangles and edge rings of this JSON file "
                   "(docs/file-formats.md)")
        ->type_name("FILE");
    addGrowing(app, raw);
    addShared(app, raw);
    app.add_option("--place", raw.place,
                   "Start at an address with a camera, as a session has them (JSON)")
        ->type_name("TEXT");
    app.add_option("--result", o.resultFile, "Save answers to the questions of the lesson there")
        ->type_name("FILE");
    app.add_option("--size", raw.size,
                   "Size of the window or picture in pixels, for example 1280x800");
    app.add_option("--screenshot", o.screenshot,
                   "Write a picture of the window and quit; needs no display");
    app.add_option("--background", raw.background,
                   "With --screenshot: the view alone, on the background of the theme, or on none "
                   "(transparent)")
        ->check(CLI::IsMember({"theme", "none"}));
    app.add_option("--labels", o.picture.labels,
                   "Text, axes, pins and legends over the view: on or off")
        ->type_name("TEXT")
        ->check(CLI::IsMember({"on", "off"}));
    app.add_option("--scale", o.picture.scale,
                   "With --screenshot: X times as many pixels as --size, with the same content")
        ->type_name("X")
        ->check(CLI::Range(0.25, 16.0));
    app.add_option("--supersample", o.picture.supersample,
                   "With --screenshot: draw N by N pixels for each one of the picture")
        ->type_name("N")
        ->check(CLI::Range(1, 8));
    addExportOptions(app, raw.exported);
    app.add_option("--frames", o.frames, "Quit after N frames")->check(CLI::Range(1, 1000000));
    app.add_option("--ui-scale", o.uiScale, "Size of text and panels, 0.75 to 3")
        ->check(CLI::Range(0.75, 3.0));
    app.add_flag("--reset-layout", o.resetLayout, "Start with the default layout");
    app.add_flag("--narrate", o.narrate, "Print one sentence per step to stdout");
    app.add_flag(std::string(kForceOption), o.force, std::string(kForceHelp));
    app.add_flag("--no-config", o.noConfig,
                 "Do not read or write settings, layout and recent files");
    app.add_option("--shaders", o.shaders, "Read the shaders from this folder");
    app.add_flag("--keys", o.cheatSheet, "Start with the list of keys open");
    app.add_flag("--list-actions", raw.actions, "Print all actions with their keys, and quit");
    app.set_version_flag("--version", "spiraling-edge-viewer " SE_VERSION);
    app.footer([] {
        return listOf("Scenes:", kScenePrefix, scenes(), 18) + "\n\n" +
               listOf("Shapes for --new:", "", shapes(), 24);
    });
}

/// New points of --new; --box clips their surface. Throws as takeOver() does.
void takeOverGrowing(const RawOptions& raw, Options& o) {
    if (!o.input.source.empty())
        throw CLI::ValidationError("--new", "cannot be combined with a FILE");
    o.grow = raw.grow;
    if (o.input.walls.from == WallChoice::From::Around)
        throw CLI::ValidationError("--box auto", "expected six numbers, the box that clips --new");
    if (o.input.walls.from == WallChoice::From::Box) o.grow->box = o.input.walls.box;
    o.input.walls = {};
    std::erase_if(o.given, [](const FieldValue& each) { return each.field->key == "box"; });
    if (o.grow->count == 0 && o.grow->spacing == 0.0) o.grow->count = kUsualPoints;
}

/// A link in place of FILE: what the command line does not set is that of the link. Throws as
/// takeOver() does.
void takeOverLink(const CLI::App& app, Options& o) {
    if (!isLink(o.input.source)) return;
    Result<Options> read = optionsFromLink(o.input.source);
    if (!read) throw CLI::ValidationError(read.error().message);
    static_cast<LinkOptions&>(o) = std::move(read.value());
    if (!o.lesson.empty()) o.input = RunSpec{std::exchange(o.lesson, {})};
    if (app.count("--goto") + app.count("--place") == 0) return;
    o.goTo.clear();
    o.atDifference = false;
    o.camera.reset();
}

/// The options that links have as well. Throws as takeOver() does.
void takeOverShared(const CLI::App& app, const RawOptions& raw, Options& o) {
    for (const LinkPart& part : linkParts()) {
        if (part.kind != LinkPart::Kind::Option || app.count(optionOf(part)) == 0) continue;
        const auto text = raw.shared.find(part.name);
        const Status set = part.set(o, text != raw.shared.end() ? text->second : std::string());
        if (!set) throw CLI::ValidationError(optionOf(part), set.error().message);
    }
}

/// What is to be run. Throws as takeOver() does.
void takeOverInput(const CLI::App& app, const RawOptions& raw, Options& o) {
    const SpecChange typed = raw.run.given();
    const RunSpec linked = o.input;
    const Status valid = applyChange(typed, o.input);
    if (!(linked == o.input)) o.stateHash.reset();
    if (!valid) throw CLI::ValidationError(valid.error().message);
    o.given.insert(o.given.end(), typed.begin(), typed.end());
    if (isVolumePath(o.input.source) && !isSample(o.input.source) && raw.grow.surface.empty()) {
        o.grow = SampleSpec{};
        o.grow->surface = std::exchange(o.input.source, {});
        o.grow->count = kUsualPoints;
    }
    if (app.count("--new") > 0) takeOverGrowing(raw, o);
}

/// Throws the errors that CLI11 reports as wrong usage.
void takeOver(const RawOptions& raw, Options& o) {
    o.size = pictureSize(raw.size);
    if (!o.size && !raw.size.empty())
        throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, for example 1280x800");
    if (!raw.place.empty()) {
        const Result<ViewPosition> place = viewPositionFromText(raw.place);
        if (!place) throw CLI::ValidationError("--place", place.error().message);
        o.camera = place.value().camera;
        if (o.goTo.empty()) o.goTo = place.value().address;
    }
    if (!raw.other.empty() && !o.withText.empty())
        throw CLI::ValidationError(raw.other, "--with already names what to compare with");
    if (!raw.other.empty()) o.withText = raw.other;
    if (o.atDifference && o.withText.empty() && o.input.source.empty())
        throw CLI::ValidationError("--goto difference", "needs --with");
    if (!o.withText.empty()) {
        const Result<CompareWith> with = compareWithFromText(o.withText, o.input);
        if (!with) throw CLI::ValidationError("--with", with.error().message);
    }
    if (o.input.source.empty() && !(o.goTo.empty() && o.alert.empty())) {
        throw CLI::ValidationError("--goto, --place, --alert", "need a FILE or scene:ID");
    }
}

/// Fails before any work if `path` cannot be written.
void requireWritable(const std::filesystem::path& path, const char* option) {
    if (const Status status = AtomicFile::check(path); !status)
        throw CLI::ValidationError(option, status.error().message);
}

/// Looks of a picture. Throws as takeOver() does.
void takeOverPicture(const RawOptions& raw, Options& o) {
    PictureLook& look = o.picture;
    look.viewAlone = !raw.background.empty();
    look.cutOut = raw.background == "none";
    const bool written = !o.screenshot.empty() || !raw.exported.order.path.empty();
    if (!written && (look.viewAlone || look.supersample > 1 || look.scale != 1.0))
        throw CLI::ValidationError("--background, --scale, --supersample", "need --screenshot");
    const glm::ivec2 size = o.size.value_or(glm::ivec2(1280, 800));
    const double factor = look.scale * look.supersample;
    if (std::max(size.x, size.y) * factor > kMostPixels ||
        factor * size.x * factor * size.y > kMostArea)
        throw CLI::ValidationError(
            "--scale, --supersample",
            "times --size is at most 32768 pixels a side, and 16384 squared");
}

/// Pictures are PNG; another extension would promise another format.
void requirePngName(const std::filesystem::path& path) {
    if (lowerExtension(path) == ".png") return;
    throw CLI::ValidationError("--screenshot " + path.string(),
                               "pictures are written as .png only");
}

}  // namespace

Status chooseComparison(Options& o) {
    if (o.withText.empty()) return success();
    Result<CompareWith> with = compareWithFromText(o.withText, o.input);
    if (!with) return with.error();
    o.with = std::move(with.value());
    if (o.with->kind == CompareWith::Kind::Trace && !o.layout) o.layout = LayoutPreset::Compare;
    return success();
}

Status adoptLesson(Options& o, int& code) {
    if (!o.exported) return success();
    ExportOrder& order = *o.exported;
    code = kExitInput;
    Result<SharedLesson> lesson = lessonOfSource(o.input.source);
    if (!lesson) return lesson.error();
    order.lesson = lesson.value();
    code = kExitUsage;
    if (order.lesson && (order.range || !o.goTo.empty()))
        return Error{std::string("--goto, --from and --around are for a run; a lesson has ") +
                     (order.program ? "--step" : "--steps")};
    if (!order.lesson && !order.stepsText.empty())
        return Error{"--steps is for lessons; a run has --from and --to"};
    if (!order.stepsText.empty()) {
        Result<std::vector<std::size_t>> steps =
            stepsFromText(order.stepsText, order.lesson->lesson.steps.size());
        if (!steps) return Error{"--steps " + steps.error().message};
        order.steps = std::move(steps.value());
    }
    const bool placed =
        order.lesson || order.range || order.program || o.session || o.camera || !o.alert.empty();
    if (!placed && o.goTo.empty()) o.goTo = "100%";
    if (order.range) o.goTo = "0";
    return checkExport(order, o.picture.cutOut);
}

Status adoptLesson(Options& o) {
    // For an export the lesson is read with its order.
    if (o.exported || !isLesson(o.input.source)) return success();
    o.lesson = std::exchange(o.input.source, {});
    if (isLessonFile(o.lesson)) o.lesson = wholePath(o.lesson);
    return success();
}

Status adoptSession(Options& o) {
    const std::string path = o.input.source;
    if (isTraceFile(path)) {
        if (o.onPaper())
            return Error{path +
                         ": a trace is compared with its points: spiraling-edge-viewer POINTS "
                         "--with " +
                         path};
        o.withText = std::exchange(o.input.source, {});
        return success();
    }
    if (o.session || !isFilePath(path) || !looksLikeSession(path)) return success();
    Result<SessionFile> read = readSessionFile(path);
    if (!read) return read.error();
    o.sessionPath = path;
    o.session = std::move(read.value());
    // Options of the command line change those of the session.
    RunSpec kept = o.session->input;
    if (!o.input.piece.isWhole()) {
        kept.piece = {};
        kept.leftOut = {};
    }
    o.input = otherRun(std::move(kept), o.given);
    return success();
}

Status adoptStart(Options& o) {
    if (o.startFile.empty()) return success();
    Result<GivenStart> start = teach::readStartFile(o.startFile);
    if (!start) return start.error();
    o.input.start = std::move(start.value());
    return success();
}

Status adoptStandardInput(Options& o) {
    if (o.session || !isStandardInput(o.input.source)) return success();
    Status read = success();
    const Status good = guarded([&] {
        Result<PointFile> points = readStandardInput(ByteLimit{o.input.maxBytes}, unpackGzip);
        if (!points) {
            read = points.error();
            return;
        }
        o.input.points = std::make_shared<const PointFile>(std::move(points.value()));
    });
    return good ? read : good;
}

namespace {

/// The files that a lesson reads: its inputs, and its images, which an export may name.
void addLessonFiles(const teach::Lesson& lesson, const std::filesystem::path& folder,
                    std::vector<NamedFile>& inputs) {
    const auto addText = [&](const std::string& text) {
        for (const teach::TextBlock& block : teach::textBlocks(text)) {
            if (!block.image.empty()) inputs.push_back({"the image", folder / block.image});
        }
    };
    const auto addInput = [&](const std::string& input) {
        if (!input.empty()) inputs.push_back({"the points", teach::lessonSource(input, folder)});
    };
    addText(lesson.text);
    addInput(lesson.input);
    for (const teach::LessonStep& step : lesson.steps) {
        addText(step.text);
        addInput(step.input);
    }
}

std::vector<NamedFile> filesRead(const Options& o) {
    std::vector<NamedFile> inputs{{"", o.input.source},
                                  {"the session", o.sessionPath},
                                  {"the lesson", o.lesson},
                                  {"--start", o.startFile}};
    if (o.with && o.with->isFile()) inputs.push_back({"--with", o.with->path});
    if (o.session && o.session->with.isFile())
        inputs.push_back({"the compared file", o.session->with.path});
    if (o.grow && isVolumePath(o.grow->surface)) {
        inputs.push_back({"the volume", o.grow->surface});
        inputs.push_back({"the data file", dataFileOf(o.grow->surface)});
    }
    if (o.exported && o.exported->lesson)
        addLessonFiles(o.exported->lesson->lesson, o.exported->lesson->folder, inputs);
    if (isLessonFile(o.lesson)) {
        // A faulty one is reported when it is opened.
        const auto read = teach::readLessonFile(o.lesson);
        const auto folder = std::filesystem::path(o.lesson).parent_path();
        if (read && read.value().ok()) addLessonFiles(read.value().lesson, folder, inputs);
    }
    return inputs;
}

}  // namespace

Status requireInputsKept(const Options& o) {
    const auto isUnnamed = [](const NamedFile& each) { return each.path.empty(); };
    std::vector<NamedFile> outputs{{"--screenshot", o.screenshot}, {"--result", o.resultFile}};
    if (o.exported) {
        const std::vector<std::filesystem::path> one{o.exported->path};
        for (const auto& each : o.exported->several() ? seriesFilesAt(o.exported->path) : one)
            outputs.push_back({"-o", each});
    }
    std::erase_if(outputs, isUnnamed);
    if (const Status apart = requireApart(outputs); !apart) return apart;
    if (o.force || outputs.empty()) return success();
    std::vector<NamedFile> inputs = filesRead(o);
    std::erase_if(inputs, isUnnamed);
    return requireKept(inputs, outputs);
}

ParsedOptions parseOptions(int argc, const char* const* argv) {
    Options o;
    CLI::App app{"Watch the Spiraling Edge algorithm triangulate points, decision by decision.",
                 "spiraling-edge-viewer"};
    RawOptions raw;
    addOptions(app, o, raw);
    if (const std::vector<std::string> words(argv + 1, argv + argc); asksForOptionList(words)) {
        printLines(stdout, optionList(app, SE_VERSION));
        return {std::nullopt, kExitGood};
    }
    try {
        app.parse(argc, argv);
        takeOverLink(app, o);
        takeOverShared(app, raw, o);
        takeOverInput(app, raw, o);
        takeOver(raw, o);
        takeOverPicture(raw, o);
        takeOverExport(app, raw.exported, o);
        if (app.count("--screenshot") > 0) {
            requirePngName(o.screenshot);
            requireWritable(o.screenshot, "--screenshot");
        }
        if (app.count("--result") > 0) requireWritable(o.resultFile, "--result");
        const bool ofLesson = app.count("--step") + app.count("--result") > 0;
        if (ofLesson && !isLesson(o.input.source))
            throw CLI::ValidationError("--step, --result", "need a lesson as FILE");
        if (!o.startFile.empty() && (o.input.source.empty() || isLesson(o.input.source)))
            throw CLI::ValidationError("--start", "needs points as FILE");
    } catch (const CLI::ParseError& e) {
        std::ostringstream out;
        std::ostringstream err;
        const int code = app.exit(e, out, err);
        printLines(stdout, out.str());
        printLines(stderr, err.str());
        return {std::nullopt, code == 0 ? kExitGood : kExitUsage};
    }
    if (raw.actions) {
        std::fputs(listActions().c_str(), stdout);
        return {std::nullopt, kExitGood};
    }
    if (!raw.other.empty() && !o.layout) o.layout = LayoutPreset::Compare;
    return {std::move(o), kExitGood};
}

ViewSettings keptSettings(const Options& options, Theme usual) {
    if (!options.noConfig && !options.onPaper()) return readSettings(settingsPath(), usual);
    ViewSettings settings;
    settings.theme = usual;
    return settings;
}

ViewSettings settingsFor(const Options& options, ViewSettings settings) {
    if (options.size) {
        settings.width = options.size->x;
        settings.height = options.size->y;
    }
    if (options.theme) settings.theme = *options.theme;
    if (options.meshStyle) settings.meshStyle = *options.meshStyle;
    if (options.pointTint) settings.pointTint = *options.pointTint;
    if (options.uiScale > 0.0) settings.uiScale = options.uiScale;
    return settings;
}

ViewSettings settingsToKeep(const Options& options, const Application& application,
                            const ViewSettings& before) {
    ViewSettings keep = application.settings();
    const Looks& linked = application.document().linkedLooks();
    if (options.theme || keep.theme == linked.theme) keep.theme = before.theme;
    if (options.meshStyle || keep.meshStyle == linked.meshStyle) keep.meshStyle = before.meshStyle;
    if (options.pointTint || keep.pointTint == linked.pointTint) keep.pointTint = before.pointTint;
    if (options.uiScale > 0.0) keep.uiScale = before.uiScale;
    if (options.session && options.session->layers) keep.layers = before.layers;
    if (options.size) keep.width = before.width;
    if (options.size) keep.height = before.height;
    return keep;
}

}  // namespace se::view
