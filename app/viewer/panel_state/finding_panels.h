/// State of the panels that list what was found in a run: alerts, watched numbers, the doctor's
/// findings. Plain values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rows/watch_plot.h"

namespace se::view {

struct AlertsPanel {
    std::map<std::string, bool> open;  ///< Classes that were folded or unfolded by the user.
    bool reveal = false;               ///< The list scrolls to the chosen alert.
};

struct DoctorPanel {
    std::string shownCheck;  ///< The finding whose points are highlighted.
};

struct WatchPanel {
    std::vector<std::string> expressions;  ///< See core's watch.h.
    std::map<std::string, PaintedPlot> plots;
};

}  // namespace se::view
