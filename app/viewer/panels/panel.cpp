#include "panel.h"

#include <tuple>

#include "panel_state/ui_state.h"

namespace se::view {

template <class State>
State& PanelContext::state() const {
    UiState& ui = commands.ui;
    return std::get<State&>(std::tie(ui.alerts, ui.bookmarks, ui.breakpoints, ui.doctor, ui.tab,
                                     ui.watch, ui.browsing, ui.click, ui.compare, ui.facts, ui.goTo,
                                     ui.growth, ui.lasso, ui.leaving, ui.ledger, ui.look, ui.mesh,
                                     ui.navigation, ui.palette, ui.prepare, ui.query, ui.startPage,
                                     ui.subjectMenu, ui.typing, ui.viewDrag, ui.walk, ui.whatIf));
}

template AlertsPanel& PanelContext::state() const;
template Bookmarks& PanelContext::state() const;
template DoctorPanel& PanelContext::state() const;
template OpenTab& PanelContext::state() const;
template WatchPanel& PanelContext::state() const;
template std::vector<Breakpoint>& PanelContext::state() const;
template CommandPalette& PanelContext::state() const;
template ComparePage& PanelContext::state() const;
template DoubleClickFilter& PanelContext::state() const;
template FactsCache& PanelContext::state() const;
template FileBrowsing& PanelContext::state() const;
template GoToBox& PanelContext::state() const;
template GrowthPage& PanelContext::state() const;
template KeyWalk& PanelContext::state() const;
template Lasso& PanelContext::state() const;
template LeaveQuestion& PanelContext::state() const;
template LedgerPanel& PanelContext::state() const;
template LookBack& PanelContext::state() const;
template MeshForm& PanelContext::state() const;
template Navigation& PanelContext::state() const;
template PrepareForm& PanelContext::state() const;
template QueryPanel& PanelContext::state() const;
template StartPage& PanelContext::state() const;
template SubjectMenu& PanelContext::state() const;
template TypingWait& PanelContext::state() const;
template ViewDrag& PanelContext::state() const;
template WhatIfForm& PanelContext::state() const;

ViewSettings& PanelContext::settings() const { return commands.ui.settings; }

UiRequests& PanelContext::requests() const { return commands.ui.requests; }

std::map<std::string, Rect>& PanelContext::where() const { return commands.ui.where; }

std::string PanelContext::key(const Command& command) const {
    return commands.ui.settings.keys.first(command);
}

}  // namespace se::view
