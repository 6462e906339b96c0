/// The tabs of the side columns, by their titles. Plain values.
#pragma once

#include <string>

namespace se::view {

/// The tab that opens by itself when the doctor has found a problem.
inline constexpr const char* kDoctorTab = "Doctor";
inline constexpr const char* kBreakpointsTab = "Breakpoints";
inline constexpr const char* kWatchTab = "Watch";

/// The tab with the alerts.
inline constexpr const char* kAlertsTab = "Alerts";

/// The tab with all rules as switches.
inline constexpr const char* kRulesTab = "Rules";

/// The tab for overriding decisions.
inline constexpr const char* kWhatIfTab = "What if";

/// Tabs of the query panels.
inline constexpr const char* kLedgerTab = "Ledger";
inline constexpr const char* kQueryTab = "Query";
inline constexpr const char* kChartsTab = "Charts";

/// The tab of the right column.
struct OpenTab {
    std::string title;   ///< As last drawn.
    std::string wanted;  ///< To be opened in the next frame; empty: unchanged.
};

}  // namespace se::view
