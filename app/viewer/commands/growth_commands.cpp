// Commands of the growing points: the groups about the run, which does not exist yet, are replaced.

#include <algorithm>
#include <array>
#include <string_view>

#include "document/actions.h"
#include "document/new_points.h"

namespace se::view {

namespace {

struct Meaning {
    std::string_view id;
    void (NewPoints::*act)();
};

constexpr auto kMeanings = std::to_array<Meaning>({
    {"run.play", &NewPoints::playOrPause},
    {"run.step", &NewPoints::step},
    {"step.event.next", &NewPoints::step},
    {"step.pivot.next", &NewPoints::step},
    {"run.end", &NewPoints::finish},
    {"run.continue", &NewPoints::finish},
    {"run.continue.back", &NewPoints::start},
    {"run.start", &NewPoints::start},
    {"file.restart", &NewPoints::start},
    {"view.home", &NewPoints::home},
    {"view.all", &NewPoints::home},
    {"view.frame", &NewPoints::home},
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
