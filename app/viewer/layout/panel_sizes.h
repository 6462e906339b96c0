/// Sizes of panels that the user sets. Plain values.
#pragma once

namespace se::view {

struct PanelSizes {
    float column = 0.0F;  ///< Width of the column in em; 0: automatic.
    bool folded = false;  ///< The column is folded to its rail.
    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

}  // namespace se::view
