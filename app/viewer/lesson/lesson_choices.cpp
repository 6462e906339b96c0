#include "lesson_choices.h"

#include <algorithm>

#include "compare/compared_runs.h"
#include "document/ui_state.h"

namespace se::view {

void LessonChoices::pinLayers(const teach::LessonStep& step) {
    for (const Layer& layer : layers()) {
        const auto among = [&](const std::vector<std::string>& names) {
            return std::find(names.begin(), names.end(), layer.name) != names.end();
        };
        const bool pins = among(step.pin);
        if (!pins && !among(step.hide)) continue;
        LayerMode& mode = modeOf(c_.ui.settings.layers, layer.id);
        layers_.emplace_back(layer.id, mode);
        mode = pins ? LayerMode::PinnedOn : LayerMode::PinnedOff;
    }
}

void LessonChoices::play(PlayUnit unit, double rate, const Address& until) {
    if (!speed_) speed_ = c_.playback.speed();
    c_.playback.setUnit(unit);
    c_.playback.setRate(rate);
    c_.playback.play();
    c_.playback.until = until;
}

void LessonChoices::compare(CompareWith with) {
    compares_ = true;
    c_.ui.compare.inPresent = true;
    if (c_.ui.layoutPreset != LayoutPreset::Present) {
        if (!layout_) layout_ = c_.ui.layoutPreset;
        c_.ui.layoutPreset = LayoutPreset::Compare;
    }
    c_.compare.begin(std::move(with));
}

void LessonChoices::putBack() {
    for (const auto& [layer, mode] : std::exchange(layers_, {}))
        modeOf(c_.ui.settings.layers, layer) = mode;
    c_.playback.pause();
    if (speed_) c_.playback.setSpeed(*std::exchange(speed_, std::nullopt));
    if (!std::exchange(compares_, false)) return;
    c_.compare.stop();
    c_.ui.compare.inPresent = false;
    const auto before = std::exchange(layout_, std::nullopt);
    // The user may have chosen another layout meanwhile.
    if (!before || c_.ui.layoutPreset != LayoutPreset::Compare) return;
    c_.ui.layoutPreset = *before;
    c_.ui.column.choose(Task::Lesson);
}

}  // namespace se::view
