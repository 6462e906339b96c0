// Commands of the growing points: the groups about the run, which does not exist yet, are replaced.

#include <algorithm>
#include <array>
#include <string_view>

#include "command_actions.h"

namespace se::view {

namespace {

struct Meaning {
    std::string_view id;
    GrowthAsk ask;
};

constexpr auto kMeanings = std::to_array<Meaning>({
    {"run.play", GrowthAsk::PlayOrPause},
    {"run.step", GrowthAsk::Step},
    {"step.event.next", GrowthAsk::Step},
    {"step.pivot.next", GrowthAsk::Step},
    {"run.end", GrowthAsk::Finish},
    {"run.continue", GrowthAsk::Finish},
    {"run.continue.back", GrowthAsk::Begin},
    {"run.start", GrowthAsk::Begin},
    {"file.restart", GrowthAsk::Begin},
    {"view.home", GrowthAsk::Home},
    {"view.all", GrowthAsk::Home},
    {"view.frame", GrowthAsk::Home},
});

/// Groups about the run, which does not exist yet.
constexpr std::array<std::string_view, 5> kAside = {"Run", "Step", "Layers", "Notes", "Edit"};

bool isAside(const Command& command) {
    return std::find(kAside.begin(), kAside.end(), command.group) != kAside.end() ||
           command.id == "file.prepare" || command.id.starts_with("view.layout.") ||
           command.id.starts_with("view.mesh.") || command.id == "view.doctor" ||
           command.id == "view.breakpoints" || command.id == "view.watch" ||
           command.id == "view.strips" || command.id == "view.column" ||
           command.id == "view.legend";
}

}  // namespace

void openGrowthPage(CommandContext& context, GrowthSource from) {
    GrowthPage& page = context.ui.growth;
    context.playback.pause();
    const bool another = !page.open || page.form.from != from;
    page.form.from = from;
    page.open = true;
    page.complaint.clear();
    page.message.clear();
    context.ui.requests.closePopups = true;
    const bool nothingChosen = from == GrowthSource::Volume && page.form.volume.empty();
    if (another && !nothingChosen) page.asked = GrowthAsk::Begin;
    if (!nothingChosen) return;
    actions::openBrowser(context, BrowserTask::Volume);
}

bool runOnGrowthPage(const Command& command, CommandContext& context) {
    const auto found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                    [&](const Meaning& m) { return m.id == command.id; });
    if (found != kMeanings.end()) {
        context.ui.growth.asked = found->ask;
        return true;
    }
    if (command.id == "file.save" || command.id == "file.saveas") {
        findCommand("file.savepoints")->run(context);
        return true;
    }
    if (command.id == "file.savemesh" || command.id == "file.copycommand" ||
        command.id == "file.export") {
        context.ui.growth.complaint = "There is no mesh yet: choose Use these points first.";
        return true;
    }
    return isAside(command);
}

}  // namespace se::view
