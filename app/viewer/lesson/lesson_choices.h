/// Choices of the user that a step of a lesson changes, and that are put back when it is left:
/// layers, playback, the layout for a comparison.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "document/context.h"
#include "layers/layer.h"
#include "session/compare_with.h"
#include "session/layout_preset.h"
#include "session/playback.h"
#include "teach/lesson.h"

namespace se::view {

class LessonChoices {
  public:
    explicit LessonChoices(CommandContext& context) : c_(context) {}

    /// Pins and hides the layers of the step.
    void pinLayers(const teach::LessonStep& step);
    /// Plays from the cursor to an address.
    void play(PlayUnit unit, double rate, const Address& until);
    /// Shows another run beside this one: in the layout Compare, or within Present.
    void compare(CompareWith with);
    void putBack();

  private:
    CommandContext& c_;
    std::vector<std::pair<LayerId, LayerMode>> layers_;
    std::optional<PlaySpeed> speed_;
    bool compares_ = false;
    std::optional<LayoutPreset> layout_;  ///< Before the layout Compare.
};

}  // namespace se::view
