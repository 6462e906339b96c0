#include "first_run.h"

#include <algorithm>
#include <utility>

#include "jobs/open_lesson.h"
#include "session/session.h"
#include "ui_state.h"

namespace se::view {

bool FirstRun::poll() {
    // Paused by the mouse, moved elsewhere, or at the end.
    if (plays_ && !c_.playback.playing()) {
        end();
        return true;
    }
    const Session& session = c_.session;
    if (seconds_ <= 0.0 || !session.ready() || !session.overview().complete) return false;
    const double pivots = std::max(1U, session.overview().lastPivot);
    before_ = c_.playback.speed();
    c_.playback.setSpeed({PlayUnit::Pivot, pivots / std::exchange(seconds_, 0.0), false});
    c_.playback.play();
    c_.ui.column.suggest(Task::Step);
    plays_ = true;
    return true;
}

bool FirstRun::key() {
    if (!active()) return false;
    seconds_ = 0.0;
    if (plays_) end();
    return true;
}

void FirstRun::end() {
    c_.playback.pause();
    c_.playback.setSpeed(before_);
    plays_ = false;
    const std::string tour = embeddedLessonSource("tour");
    c_.ui.offersTour =
        !c_.ui.lesson.walk.isOpen() && c_.document.kept().read().lessons.count(tour) == 0;
    // Once: the tour begins with its first step.
    c_.document.keep([&](KeptState& state) { state.lessons.try_emplace(tour, 0); });
}

}  // namespace se::view
