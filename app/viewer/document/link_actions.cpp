#include "link_actions.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "actions.h"
#include "compare/comparison.h"
#include "document.h"
#include "jobs/open_lesson.h"
#include "lesson/lesson_player.h"
#include "link.h"
#include "paint/svg_text.h"
#include "run/packed_file.h"
#include "session/compare_with.h"
#include "session/playback.h"
#include "session/session.h"
#include "session/view_position.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "teach/lesson_read.h"
#include "ui_state.h"

namespace se::view {

namespace {

/// Larger files are not tried.
constexpr std::uintmax_t kMostTried = std::uintmax_t{256} << 10U;

/// A file by its name alone.
LinkedSource named(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return {name, "The link names the file " + name + " but does not contain it."};
}

/// The file as a line of text; empty if it is too large, cannot be read, or needs other files.
std::string packedIfShort(const std::string& path) {
    std::error_code error;
    if (std::filesystem::file_size(path, error) > kMostTried || error) return {};
    const Result<std::string> bytes = readBytes(path, ByteLimit{kMostTried});
    if (!bytes) return {};
    const std::string source = packedSource({path, bytes.value()});
    if (source.size() > kMostLetters) return {};
    const bool alone =
        !isLessonFile(path) || fileOfLesson(teach::readLesson(bytes.value(), path).lesson).empty();
    return alone ? source : std::string{};
}

/// The text of --with for the run beside the open one; empty if no text stands for it.
std::string textOfOther(const CommandContext& c) {
    const Comparison* now = c.ui.compare.now;
    if (now == nullptr || now->with().kind != CompareWith::Kind::Run) return {};
    const RunSpec& open = c.session.input().spec();
    std::string text;
    for (const std::string& each : optionsOf(differenceOf(open, now->with().run)))
        text.append(text.empty() ? "" : " ").append(each);
    if (text.empty()) return {};
    const Result<CompareWith> read = compareWithFromText(text, open);
    return read && read.value().run == now->with().run ? text : std::string{};
}

/// What is shown, as options of the start; the source is changed to that of a link.
std::pair<Options, std::string> presentOptions(const CommandContext& c) {
    Options o;
    std::string notice;
    if (c.ui.layoutPreset != LayoutPreset::Debug) o.layout = c.ui.layoutPreset;
    if (const LessonWalk& walk = c.ui.lesson.walk; walk.isOpen()) {
        LinkedSource lesson = linkedSource(walk.source());
        o.lesson = std::move(lesson.source);
        o.lessonStep = walk.step();
        return {std::move(o), std::move(lesson.notice)};
    }
    const Session& session = c.session;
    o.input = session.input().spec();
    LinkedSource input = linkedSource(o.input.source);
    o.input.source = std::move(input.source);
    notice = std::move(input.notice);
    if (o.input.source.empty()) o.input = {};
    if (!o.input.start.empty())
        notice.append(notice.empty() ? "" : " ")
            .append("It leaves out the triangles and rings that the run begins with.");
    if (const auto end = session.runEnd(); end && o.input.start.empty())
        o.stateHash = end->stateHash;
    o.goTo = session.event() != nullptr ? toString(session.address()) : "0";
    o.camera = c.camera.pose();
    o.withText = textOfOther(c);
    return {std::move(o), std::move(notice)};
}

/// The link is to another place of the open input, by the same rules.
bool isOfOpenInput(const CommandContext& c, const Options& o) {
    const SessionInput& input = c.session.input();
    if (!c.session.ready() || input.phase() == SessionPhase::Loading) return false;
    // These are shown with a newly opened input.
    if (!o.alert.empty() || !o.withText.empty() || o.atDifference || o.session) return false;
    const RunSpec& open = input.spec();
    if (o.input.source.empty()) return true;
    RunSpec spec = o.input;
    const bool same = spec.source == open.source || spec.source == linkedSource(open.source).source;
    spec.source = open.source;
    spec.points = open.points;
    spec.maxBytes = open.maxBytes;
    spec.start = open.start;
    return same && spec == open;
}

Status moveTo(CommandContext& c, const ViewPosition& place) {
    if (place.camera) c.camera.setPose(*place.camera);
    if (place.address.empty()) return success();
    if (const Status status = c.session.moves().goToText(place.address); !status) return status;
    if (!place.camera) c.ui.frame = FrameRequest::Decision;
    return success();
}

PresentLink presentLink(const CommandContext& c) { return linkTo(c, linkBase(c)); }

}  // namespace

std::string_view linkBase(const CommandContext& context) {
    const std::string& page = context.ui.pageAddress;
    return page.empty() ? linkBase() : std::string_view(page);
}

LinkedSource linkedSource(const std::string& source) {
    if (isStandardInput(source))
        return {{}, "The points came from standard input: the link has no input."};
    const bool elsewhere = source.starts_with("https:") || source.starts_with("http:");
    const bool lesson = isLesson(source) && !isLessonFile(source);
    if (elsewhere || lesson || !isFilePath(source)) return {source, {}};
    std::string packed = packedIfShort(source);
    return packed.empty() ? named(source) : LinkedSource{std::move(packed), {}};
}

PresentLink linkTo(const CommandContext& context, std::string_view base) {
    auto [options, notice] = presentOptions(context);
    return {std::string(base) + "#" + linkText(options), std::move(notice)};
}

Status followLink(CommandContext& context, std::string_view text) {
    Result<Options> read = optionsFromLink(text);
    if (!read) return read.error();
    const Options& o = read.value();
    context.playback.pause();
    const LessonWalk& walk = context.ui.lesson.walk;
    const bool sameLesson =
        walk.isOpen() && !o.lesson.empty() &&
        (walk.source() == o.lesson || linkedSource(walk.source()).source == o.lesson);
    if (sameLesson) {
        context.document.applyLooks(o);
        context.lesson.toStep(o.lessonStep.value_or(walk.step()));
        return success();
    }
    if (o.lesson.empty() && isOfOpenInput(context, o)) {
        context.document.applyLooks(o);
        context.document.expectEnd(o.stateHash);
        return moveTo(context, {o.goTo, o.camera});
    }
    if (o.lesson.empty() && !o.session && o.input.source.empty())
        return Error{"The link names no input, and none is open."};
    context.document.openLink(o);
    return success();
}

namespace actions {

void copyLink(CommandContext& c) {
    const PresentLink link = presentLink(c);
    c.ui.clipboard.copy(link.text);
    c.session.messages().say("Link copied." + (link.notice.empty() ? "" : " " + link.notice));
}

void copyFrame(CommandContext& c) {
    const PresentLink link = presentLink(c);
    c.ui.clipboard.copy("<iframe src=\"" + escapedXml(link.text) +
                        "\" title=\"Spiraling Edge\" width=\"900\" height=\"600\" "
                        "allow=\"clipboard-write; fullscreen\"></iframe>");
    c.session.messages().say("Frame copied." + (link.notice.empty() ? "" : " " + link.notice));
}

void follow(CommandContext& c, const std::string& text) {
    if (isLink(text)) {
        const Status followed = followLink(c, text);
        if (!followed) c.session.messages().say(followed.error().message);
        return;
    }
    const Result<ViewPosition> place = viewPositionFromText(text);
    if (!place) return c.session.messages().say(place.error().message);
    c.playback.pause();
    if (const Status moved = moveTo(c, place.value()); !moved)
        c.session.messages().say(moved.error().message);
}

void goToTyped(CommandContext& c) {
    const std::string text = std::exchange(c.ui.goTo, {}).typed;
    const Result<Options> link = isLink(text) ? optionsFromLink(text) : Error{};
    const Result<ViewPosition> place = viewPositionFromText(text);
    const std::string& address = link ? link.value().goTo : place ? place.value().address : text;
    if (address.empty()) return;
    if (const Status moved = jumpingMoves(c).goToText(address); !moved)
        c.session.messages().say(moved.error().message);
}

}  // namespace actions

namespace {

/// Options that open the reduced points: rules and lists of the run, and the class of the alert.
Options optionsOf(const CommandContext& c, const Reduced& reduced, const FailureClass& kind) {
    Options o;
    o.input = withFixesAsOptions(c.session.input().spec());
    // Numbers of points were those of the whole input.
    o.input.piece = {};
    o.input.leftOut = {};
    o.input.fixes.clear();
    o.input.points.reset();
    o.input.source =
        packedSource({std::string(kind.name) + ".ply", meshPlyBytes(reduced.file, {})});
    o.alert = std::string(kind.name) + ":1";
    return o;
}

}  // namespace

std::string_view reasonAgainstFailureLink(const CommandContext& context) {
    const Session& session = context.session;
    const RunFailure* alert = session.ready() ? session.alerts().shown() : nullptr;
    if (alert == nullptr || !session.runEnd()) return kNoAlertShown;
    if (alert->failure.kind->find == nullptr) return "Points do not keep what this alert is about.";
    if (session.alerts().reduction().busy()) return "The points are being reduced.";
    const RunSpec& spec = session.input().spec();
    if (!spec.whatIf.empty() || !spec.start.empty())
        return "This run names points by numbers, which fewer points would change: remove what-ifs "
               "and given triangles first.";
    return {};
}

void finishFailureLink(CommandContext& context) {
    BackgroundQuery<Reduced>& job = context.session.alerts().reduction();
    Messages& messages = context.session.messages();
    const std::optional<Reduced> reduced = job.takeAnswer();
    if (!reduced) return;
    const FailureClass& kind = *context.session.alerts().reducedClass();
    const std::string points = counted(reduced->kept.size(), "point");
    const Options options = optionsOf(context, *reduced, kind);
    if (options.input.source.size() > kMostLetters)
        return messages.say(
            "The failure needs " + points +
            ", too many for a link: save the points and use spiraling-edge reduce.");
    context.ui.clipboard.copy(std::string(linkBase(context)) + "#" + linkText(options));
    messages.say("Link copied: " + points + " still end in: " + std::string(kind.singular) + "." +
                 (reduced->complete ? "" : " Fewer may be possible: the effort was used up."));
}

namespace actions {

void copyFailureLink(CommandContext& c) {
    if (const std::string_view reason = reasonAgainstFailureLink(c); !reason.empty())
        return c.session.messages().say(std::string(reason));
    const SessionInput& input = c.session.input();
    c.session.alerts().reduce(input.spec(), input.file(), c.session.runEnd());
    c.session.messages().say("The points are being reduced to those that still fail.");
}

}  // namespace actions

}  // namespace se::view
