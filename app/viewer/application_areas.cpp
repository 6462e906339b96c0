/// Sizes of text and panels in the present layout.
#include <algorithm>
#include <cmath>

#include "application.h"

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

/// Learn shows a step of a lesson.
bool Application::showsLesson() const {
    constexpr auto kUnderstand = static_cast<std::size_t>(PanelGroup::Understand);
    return ui_.lesson.walk.isOpen() && ui_.layoutPreset == LayoutPreset::Learn &&
           (ui_.tab.learn[kUnderstand] == kLessonTab || ui_.lesson.hides());
}

/// The user's sizes. A line in Find leaves its room to an open panel of Change; in Learn the dial
/// belongs to Understand, and leaves its room to the other groups and to a lesson.
PanelSizes Application::panelSizes() const {
    constexpr float kTabsOfFind = 26.0F;
    PanelSizes sizes = ui_.settings.panels;
    sizes.quiet = ui_.panelsQuiet;
    sizes.lesson = ui_.lesson.walk.isOpen();
    const bool asks = sizes.lesson && ui_.lesson.walk.question() != nullptr;
    sizes.caption = asks ? ui_.lesson.captionEms : 0.0F;
    sizes.beside = ui_.compare.isIn(LayoutPreset::Present);
    const auto asked = [&](PanelGroup group) {
        return ui_.tab.asked[static_cast<std::size_t>(group)];
    };
    const bool lesson = showsLesson();
    if (ui_.tab.group == PanelGroup::Find || ui_.tab.group == PanelGroup::Change || lesson)
        sizes.of(Splitter::LearnDial) = -1.0F;
    float& find = sizes.of(Splitter::Find);
    if (find <= 0.0F && asked(PanelGroup::Change) && !asked(PanelGroup::Find)) find = kTabsOfFind;
    return sizes;
}

PanelRects Application::areasIn(glm::vec2 size) const {
    const float em = imgui_->em();
    if (ui_.picture.viewAlone) {
        const bool two = ui_.layoutPreset == LayoutPreset::Compare;
        const float dial = std::clamp(kDialShare * size.x, kDialLeast * em, kDialMost * em);
        return viewAlone(size, {ui_.picture.caption ? std::round(kCaption * em) : 0.0F,
                                two ? std::round(kViewTitle * em) : 0.0F,
                                ui_.picture.dial ? std::round(dial) : 0.0F});
    }
    if (ui_.growth.open) return computePageRects(size, em);
    const bool folds = showsLesson() && ui_.navigation.drawer == DrawerChoice::Auto;
    return computePanelRects(size, em, ui_.layoutPreset,
                             folds ? DrawerChoice::Folded : ui_.navigation.drawer, panelSizes());
}

}  // namespace se::view
