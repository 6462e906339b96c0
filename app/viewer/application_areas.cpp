/// Sizes of text and panels in the present layout.
#include <algorithm>
#include <cmath>

#include "application.h"
#include "document/actions.h"

namespace se::view {

namespace {

/// Height of the sentence below a view alone, in em.
constexpr float kCaption = 3.6F;
/// Width of the dial beside a view alone, as a share of all, and its limits in em.
constexpr float kDialShare = 0.3F;
constexpr float kDialLeast = 10.0F;
constexpr float kDialMost = 22.0F;

}  // namespace

/// The scale of text and panels. Present is read from a distance: it is so large that at most
/// kPresentLines em fit the height of the window, whatever its resolution.
float Application::scaleIn(glm::ivec2 size) const {
    constexpr float kPresentLines = 32.0F;
    constexpr float kLargest = 3.0F;
    const double chosen = ui_.settings.uiScale > 0.0 ? ui_.settings.uiScale : contentScale_;
    const auto scale = static_cast<float>(chosen);
    const bool present = ui_.layoutPreset == LayoutPreset::Present && !ui_.picture.viewAlone;
    const float fitting = static_cast<float>(size.y) / (kPresentLines * kEmPixels);
    return present ? std::max(scale, std::min(fitting, kLargest)) : scale;
}

WindowState Application::windowState() const {
    WindowState state;
    state.layoutPreset = ui_.layoutPreset;
    state.strip = ui_.navigation.strips;
    state.sizes = ui_.settings.panels;
    state.sheet = ui_.column.sheet;
    state.finished = session_.ready() && session_.atEnd();
    state.lesson = ui_.lesson.walk.isOpen();
    const bool asks = state.lesson && ui_.lesson.walk.question() != nullptr;
    state.captionEms = asks ? ui_.lesson.captionEms : 0.0F;
    state.beside = ui_.compare.isIn(LayoutPreset::Present);
    // The lesson is needed for the answer.
    if (ui_.lesson.hides()) state.sizes.folded = false;
    return state;
}

/// Switches the column to the task that the run calls for, unless the user has picked one.
void Application::followTask() {
    const std::string& source = session_.input().spec().source;
    if (std::exchange(taskOf_, source) != source && !ui_.lesson.walk.isOpen()) {
        ui_.column.reset();
        if (ui_.layoutPreset == LayoutPreset::Compare) actions::openPart(context_, kComparePart);
        finished_ = false;
        judged_ = false;
    }
    const bool finished = session_.ready() && session_.atEnd();
    if (std::exchange(finished_, finished) != finished && finished)
        ui_.column.suggest(Task::Faults);
    const AlertSearch& alerts = session_.alerts().search();
    if (std::exchange(judged_, alerts.done()) != alerts.done() && alerts.done() && !alerts.sound())
        ui_.column.note(Task::Faults);
}

PanelRects Application::areasIn(glm::vec2 size) const {
    const float em = imgui_->em();
    if (ui_.picture.viewAlone) {
        const bool two = ui_.layoutPreset == LayoutPreset::Compare;
        const float dial = std::clamp(kDialShare * size.x, kDialLeast * em, kDialMost * em);
        // Each of two views has its own caption, in it.
        const bool below = ui_.picture.caption && !two;
        return viewAlone(size, {below ? std::round(kCaption * em) : 0.0F,
                                two ? std::round(kViewTitle * em) : 0.0F,
                                ui_.picture.dial ? std::round(dial) : 0.0F});
    }
    if (ui_.growth.open) return computePageRects(size, em);
    PanelRects rects = computePanelRects(size, em, windowState());
    // The start page replaces all panels.
    if (session_.startPage()) {
        rects.view = {{0.0F, rects.menu.size.y}, size - glm::vec2(0.0F, rects.menu.size.y)};
        rects.narration = {};
    }
    return rects;
}

}  // namespace se::view
