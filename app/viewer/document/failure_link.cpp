#include "failure_link.h"

#include <string>

#include "link.h"
#include "link_actions.h"
#include "run/packed_file.h"
#include "session/session.h"
#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/io/write_mesh.h"
#include "ui_state.h"

namespace se::view {

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
