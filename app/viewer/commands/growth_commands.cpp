// Commands of the growing points: the groups about the run, which does not exist yet, are replaced.

#include <algorithm>
#include <array>
#include <string_view>

#include "command_actions.h"
#include "controllers/sampling.h"

namespace se::view {

namespace {

struct Meaning {
    std::string_view id;
    void (SamplingController::*act)();
};

constexpr auto kMeanings = std::to_array<Meaning>({
    {"run.play", &SamplingController::playOrPause},
    {"run.step", &SamplingController::step},
    {"step.event.next", &SamplingController::step},
    {"step.pivot.next", &SamplingController::step},
    {"run.end", &SamplingController::finish},
    {"run.continue", &SamplingController::finish},
    {"run.continue.back", &SamplingController::start},
    {"run.start", &SamplingController::start},
    {"file.restart", &SamplingController::start},
    {"view.home", &SamplingController::home},
    {"view.all", &SamplingController::home},
    {"view.frame", &SamplingController::home},
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
    context.ui.closesPopups = true;
    const bool nothingChosen = from == GrowthSource::Volume && page.form.volume.empty();
    if (another && !nothingChosen) context.sampling.start();
    if (!nothingChosen) return;
    actions::openBrowser(context, BrowserTask::Volume);
}

bool runOnGrowthPage(const Command& command, CommandContext& context) {
    const auto found = std::find_if(kMeanings.begin(), kMeanings.end(),
                                    [&](const Meaning& m) { return m.id == command.id; });
    if (found != kMeanings.end()) {
        (context.sampling.*found->act)();
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
