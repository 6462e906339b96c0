#include "availability.h"

#include <algorithm>
#include <array>

#include "compare/comparison.h"
#include "document/actions.h"
#include "document/edit_history.h"
#include "document/failure_link.h"
#include "document/ui_state.h"
#include "session/session.h"

namespace se::view {

namespace {

/// A condition of the commands whose ids begin so.
struct Need {
    std::string_view id;
    bool (*holds)(const CommandContext& context);
    std::string_view reason;  ///< Why they cannot act without it.
};

bool isOpen(const CommandContext& c) { return c.session.ready(); }
bool isBeforeEnd(const CommandContext& c) { return !c.session.atEnd(); }
bool isAfterStart(const CommandContext& c) { return !c.session.atStart(); }
bool hasWhatIfs(const CommandContext& c) { return !c.session.input().spec().whatIf.empty(); }
bool hasChangedRules(const CommandContext& c) { return !c.session.input().spec().choices.empty(); }
bool canUndo(const CommandContext& c) { return c.history.undoDepth() > 0; }
bool canRedo(const CommandContext& c) { return c.history.redoDepth() > 0; }
bool isChecked(const CommandContext& c) { return c.session.alerts().search().done(); }
bool hasPlaces(const CommandContext& c) { return !c.session.alerts().search().places().empty(); }
bool showsAlert(const CommandContext& c) { return c.session.alerts().shown() != nullptr; }
bool hasWindow(const CommandContext& c) { return c.ui.pageAddress.empty(); }
bool compares(const CommandContext& c) {
    return c.ui.compare.now != nullptr && c.ui.compare.now->chosen();
}

constexpr std::string_view kNothing = "Nothing is open.";
constexpr std::string_view kFinished = "The run is finished.";

/// The first one that does not hold is the reason.
constexpr auto kCommandNeeds = std::to_array<Need>({
    {"edit.", isOpen, kNothing},
    {"run.", isOpen, kNothing},
    {"step.", isOpen, kNothing},
    {"ask.", isOpen, kNothing},
    {"notes.", isOpen, kNothing},
    {"file.save", isOpen, kNothing},
    {"file.export", isOpen, kNothing},
    {"file.copycommand", isOpen, kNothing},
    {"file.restart", isOpen, kNothing},
    {"file.quit", hasWindow, "Close the page instead."},
    {"view.frame", isOpen, kNothing},
    {"view.follow", isOpen, kNothing},
    {"run.play", isBeforeEnd, kFinished},
    {"run.end", isBeforeEnd, kFinished},
    {"step.event.next", isBeforeEnd, kFinished},
    {"step.pivot.next", isBeforeEnd, kFinished},
    {"run.start", isAfterStart, "This is the start of the run."},
    {"step.alert.", isChecked, "The mesh is not checked yet."},
    {"step.alert.", hasPlaces, "The mesh has no faults."},
    {"step.copyfailure", showsAlert, kNoAlertShown},
    {"edit.undo", canUndo, "There is nothing to undo."},
    {"edit.redo", canRedo, "There is nothing to redo."},
    {"edit.rules.reset", hasChangedRules, kNoChangedRules},
    {"edit.whatif.clear", hasWhatIfs, kNoWhatIfs},
    {"run.compare.stop", compares, "Nothing is compared."},
    {"run.compare.swap", compares, "Nothing is compared."},
});

}  // namespace

std::string_view whyUnavailable(const Command& command, const CommandContext& context) {
    const auto missing = std::find_if(
        kCommandNeeds.begin(), kCommandNeeds.end(),
        [&](const Need& need) { return command.id.starts_with(need.id) && !need.holds(context); });
    return missing == kCommandNeeds.end() ? std::string_view{} : missing->reason;
}

}  // namespace se::view
