#include "export_options.h"

#include "export/formats.h"
#include "lesson/lesson_frames.h"
#include "options.h"
#include "spiraling_edge/base/files.h"

namespace se::view {

namespace {

constexpr const char* kHidden = "";

void requireExport(const CLI::App& app, const RawExport& raw) {
    for (const char* name : {"--from", "--to", "--around", "--unit", "--lesson-steps", "--captions",
                             "--fps", "--dial", "--app", "--viewer"}) {
        if (raw.path.empty() && app.count(name) > 0)
            throw CLI::ValidationError(name, "is for spiraling-edge export");
    }
}

/// The program has neither frames nor links to a program elsewhere.
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

/// Throws unless links of the page can lead there.
void requireViewer(const CLI::App& app, const RawExport& raw) {
    if (app.count("--viewer") > 0 && lowerExtension(raw.path) != ".html")
        throw CLI::ValidationError("--viewer", "is for pages; name a file that ends in .html");
    if (const Status good = checkViewerAddress(raw.viewer); !good)
        throw CLI::ValidationError("--viewer", good.error().message);
}

FrameRange rangeOf(const RawExport& raw) {
    const FrameUnit unit = frameUnitFromName(raw.unit).value_or(FrameUnit::SubStep);
    if (raw.around.empty()) return {raw.from, raw.to, unit};
    Result<FrameRange> range = rangeAround(raw.around);
    if (!range) throw CLI::ValidationError("--around", range.error().message);
    return range.value();
}

}  // namespace

void addExportOptions(CLI::App& app, RawExport& raw) {
    const auto add = [&](const char* name, auto& value) {
        return app.add_option(name, value)->group(kHidden);
    };
    add("--export", raw.path);
    auto* from = add("--from", raw.from);
    from->needs(add("--to", raw.to)->needs(from));
    add("--around", raw.around)->excludes(from);
    add("--unit", raw.unit)->needs(from)->check(CLI::IsMember(frameUnitNames()));
    add("--lesson-steps", raw.steps)->excludes(from)->excludes("--around");
    add("--captions", raw.captions)->check(CLI::IsMember({"on", "off"}));
    add("--dial", raw.dial)->check(CLI::IsMember({"on", "off"}));
    add("--fps", raw.perSecond)->check(CLI::Range(kLeastPerSecond, kMostPerSecond));
    add("--viewer", raw.viewer);
    app.add_flag("--app", raw.program)->group(kHidden);
}

void takeOverExport(const CLI::App& app, const RawExport& raw, Options& o) {
    requireExport(app, raw);
    if (app.count("--export") == 0) return;
    const bool ranged = !raw.from.empty() || !raw.around.empty() || !raw.steps.empty();
    if (ranged && app.count("--goto") > 0)
        throw CLI::ValidationError("--goto", "is one frame; --from, --around and --steps are more");
    if (raw.program) requireNoFrames(app);
    requireViewer(app, raw);
    ExportOrder order;
    order.path = raw.path;
    order.program = raw.program;
    order.viewer = raw.viewer;
    if (!raw.from.empty() || !raw.around.empty()) order.range = rangeOf(raw);
    order.perSecond = raw.perSecond;
    order.dial = raw.dial == "on";
    order.captions = raw.captions != "off";
    order.stepsText = raw.steps;
    if (o.input.source.empty()) throw CLI::ValidationError("export", "needs an input");
    if (raw.path.empty()) throw CLI::ValidationError("-o", "needs the name of a file");
    o.exported = std::move(order);
}

Status adoptLesson(Options& o, int& code) {
    if (!o.exported) return success();
    ExportOrder& order = *o.exported;
    code = kExitInput;
    Result<std::shared_ptr<const LessonFile>> lesson = lessonOfSource(o.input.source);
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

}  // namespace se::view
