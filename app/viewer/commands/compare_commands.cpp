#include "compare_commands.h"

#include "command_actions.h"

namespace se::view::actions {

void toggleCompare(CommandContext& c) {
    const bool on = c.ui.layoutPreset == LayoutPreset::Compare;
    applyLayoutPreset(c, on ? LayoutPreset::Debug : LayoutPreset::Compare);
}

void compareUsual(CommandContext& c) {
    if (!c.session.ready()) return c.session.messages().say("There is nothing open to compare.");
    pause(c);
    applyLayoutPreset(c, LayoutPreset::Compare);
    c.ui.compare.ask = CompareAsk::Usual;
}

void compareMesh(CommandContext& c) {
    if (!c.session.ready()) return c.session.messages().say("There is nothing open to compare.");
    pause(c);
    applyLayoutPreset(c, LayoutPreset::Compare);
    c.ui.browser = BrowserTask::Mesh;
    c.ui.fileBrowser = true;
}

void askOfComparison(CommandContext& c, CompareAsk ask) {
    const Comparison* now = c.ui.compare.now;
    if (now == nullptr || !now->chosen())
        return c.session.messages().say("No comparison: press Ctrl+D, then choose the other run.");
    pause(c);
    c.ui.compare.ask = ask;
}

}  // namespace se::view::actions
