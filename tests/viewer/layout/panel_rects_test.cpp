#include "layout/panel_rects.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace se::view;

namespace {

struct Screen {
    glm::vec2 size;
    float em;
};

constexpr Screen kScreens[] = {{{1280, 800}, 16}, {{1600, 900}, 16},  {{1024, 640}, 16},
                               {{1280, 800}, 32}, {{3840, 2160}, 32}, {{640, 400}, 16}};

struct Case {
    Screen screen;
    LayoutPreset layoutPreset;
};

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const Screen& screen : kScreens) {
        for (const LayoutPresetRow& row : layoutPresets()) all.push_back({screen, row.id});
    }
    return all;
}

bool overlapping(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

}  // namespace

TEST_CASE("Panels fill the window without overlap, at every size") {
    for (const Case& each : allCases()) {
        const Screen& screen = each.screen;
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        CAPTURE(rowOf(each.layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, each.layoutPreset);
        const Rect all[] = {l.menu,  l.transport, l.left,      l.dial,       l.right,
                            l.find,  l.change,    l.view,      l.narration,  l.drawer,
                            l.title, l.status,    l.otherView, l.otherTitle, l.otherNarration};
        float area = 0.0F;
        for (const Rect& a : all) {
            area += a.size.x * a.size.y;
            CHECK(a.min.x >= 0.0F);
            CHECK(a.max().x <= screen.size.x);
            CHECK(a.max().y <= screen.size.y);
            for (const Rect& b : all) CHECK((&a == &b || !overlapping(a, b)));
        }
        CHECK(area == doctest::Approx(screen.size.x * screen.size.y));
    }
}

TEST_CASE("The view never has less than 40 percent of the width") {
    for (const auto& [screen, layoutPreset] : allCases()) {
        CAPTURE(screen.size.x);
        CAPTURE(rowOf(layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, layoutPreset);
        // Where there are two, both together.
        const bool beside = l.otherView.min.y == l.view.min.y;
        CHECK(l.view.size.x + (beside ? l.otherView.size.x : 0.0F) >= 0.4F * screen.size.x);
        CHECK(l.view.size.y >= 0.2F * screen.size.y);
    }
}

TEST_CASE("Small windows have one column, low ones one strip") {
    CHECK_FALSE(computePanelRects({1280, 800}, 16).narrow);
    CHECK(computePanelRects({1280, 800}, 32).narrow);
    PanelSizes sizes;
    const auto folded = [&](float height, float em) {
        return computePanelRects({1280.0F, height}, em, LayoutPreset::Debug, DrawerChoice::Auto,
                                 sizes)
            .drawerFolded;
    };
    sizes.quiet = true;
    CHECK_FALSE(folded(800.0F, 16.0F));
    CHECK_FALSE(folded(700.0F, 16.0F));
    CHECK(folded(699.0F, 16.0F));
    CHECK(folded(800.0F, 32.0F));
    // Open panels below the view take the room of two strips, unless the window is high.
    sizes.quiet = false;
    CHECK(folded(800.0F, 16.0F));
    CHECK_FALSE(folded(900.0F, 16.0F));
}

TEST_CASE("Find and Change are side by side below the view, and can be folded") {
    PanelSizes sizes;
    const auto laidOut = [&] {
        return computePanelRects({1280, 800}, 16, LayoutPreset::Debug, DrawerChoice::Open, sizes);
    };
    const PanelRects open = laidOut();
    REQUIRE(open.groupsApart);
    CHECK(open.find.max().x == open.change.min.x);
    CHECK(open.change.max().x == open.right.min.x);
    sizes.quiet = true;
    const PanelRects quiet = laidOut();
    sizes.folded = true;
    const PanelRects folded = laidOut();
    CHECK(quiet.find.size.y < open.find.size.y);
    CHECK(folded.find.size.y < quiet.find.size.y);
    CHECK(folded.view.size.y - open.view.size.y == open.find.size.y - folded.find.size.y);
    // A small window has them in the column.
    CHECK_FALSE(computePanelRects({1280, 800}, 32).groupsApart);
    CHECK(computePanelRects({1024, 640}, 16).groupsApart);
}

TEST_CASE("Splitters set sizes, but the view keeps its share") {
    for (const Screen& screen : kScreens) {
        for (std::size_t i = 0; i < kSplitterCount; ++i) {
            for (const float ems : {1.0F, 22.0F, 500.0F}) {
                CAPTURE(screen.size.x);
                CAPTURE(screen.em);
                CAPTURE(kSplitterNames[i]);
                CAPTURE(ems);
                PanelSizes sizes;
                sizes.ems[i] = ems;
                for (const LayoutPresetRow& row : layoutPresets()) {
                    const PanelRects l = computePanelRects(screen.size, screen.em, row.id,
                                                           DrawerChoice::Auto, sizes);
                    const bool beside = l.otherView.min.y == l.view.min.y;
                    const float both = l.view.size.x + (beside ? l.otherView.size.x : 0.0F);
                    CHECK(both >= 0.399F * screen.size.x);
                    CHECK(l.view.size.y >= 0.2F * screen.size.y);
                    for (const Rect& a : {l.left, l.right, l.dial, l.rings, l.find, l.change}) {
                        CHECK(a.size.x >= 0.0F);
                        CHECK(a.size.y >= 0.0F);
                        CHECK(a.max().x <= screen.size.x);
                        CHECK(a.max().y <= screen.size.y);
                    }
                }
            }
        }
    }
}

TEST_CASE("A splitter dragged to a place puts the border of its part there") {
    const PanelRects before = computePanelRects({1600, 900}, 16);
    for (const auto& [splitter, grow] :
         {std::pair(Splitter::Left, -16.0F), std::pair(Splitter::Right, 16.0F),
          std::pair(Splitter::Lower, 16.0F), std::pair(Splitter::Find, -32.0F),
          std::pair(Splitter::Dial, -32.0F), std::pair(Splitter::Rings, 16.0F)}) {
        const auto at = static_cast<std::size_t>(splitter);
        CAPTURE(kSplitterNames[at]);
        const auto middle = [&](const PanelRects& l) {
            const SplitterPlace& place = l.splitters[at];
            const glm::vec2 center = place.handle.min + 0.5F * place.handle.size;
            return place.sideways ? center.x : center.y;
        };
        const SplitterPlace& place = before.splitters[at];
        PanelSizes sizes;
        const float target = middle(before) + grow;
        sizes.of(splitter) = place.sign * (target - place.from) / 16.0F;
        const PanelRects after =
            computePanelRects({1600, 900}, 16, LayoutPreset::Debug, DrawerChoice::Auto, sizes);
        CHECK(std::abs(middle(after) - target) <= 1.0F);
    }
}

TEST_CASE("Learn has the dial below the rule where there is room") {
    const PanelRects l = computePanelRects({1280, 800}, 16, LayoutPreset::Learn);
    CHECK(l.dialApart);
    CHECK(l.dial.min.y == l.left.max().y);
    CHECK(l.dial.size.x == l.left.size.x);
    CHECK_FALSE(computePanelRects({1280, 800}, 32, LayoutPreset::Learn).dialApart);
    PanelSizes without;
    without.of(Splitter::LearnDial) = -1.0F;
    CHECK_FALSE(computePanelRects({1280, 800}, 16, LayoutPreset::Learn, DrawerChoice::Auto, without)
                    .dialApart);
}

TEST_CASE("The drawer can be folded to three em by hand, and opened in a low window") {
    const PanelRects folded =
        computePanelRects({1280, 800}, 16, LayoutPreset::Debug, DrawerChoice::Folded);
    CHECK(folded.drawerFolded);
    CHECK(folded.drawer.size.y == doctest::Approx(3.0F * 16.0F));
    CHECK(folded.stageStrip.size.y == 0.0F);
    const PanelRects open =
        computePanelRects({1024, 640}, 16, LayoutPreset::Debug, DrawerChoice::Open);
    CHECK_FALSE(open.drawerFolded);
    CHECK(open.view.size.y >= 0.3F * 640.0F);
    // There is a limit: some of the view must be left.
    CHECK(computePanelRects({640, 400}, 16, LayoutPreset::Debug, DrawerChoice::Open).drawerFolded);
}

TEST_CASE("The strips fill the drawer without overlap") {
    for (const Screen& screen : kScreens) {
        CAPTURE(screen.size.x);
        const PanelRects l = computePanelRects(screen.size, screen.em);
        CHECK(l.runStrip.min.y == l.drawer.min.y);
        CHECK(l.runStrip.size.y + l.pivotStrip.size.y + l.stageStrip.size.y ==
              doctest::Approx(l.drawer.size.y));
        if (l.drawerFolded) continue;
        CHECK(l.pivotStrip.min.y == doctest::Approx(l.runStrip.max().y));
        CHECK(l.stageStrip.min.y == doctest::Approx(l.pivotStrip.max().y));
        CHECK(l.stageStrip.max().y == doctest::Approx(l.drawer.max().y));
    }
}

TEST_CASE("Learn has one column, Present none, and both a larger caption") {
    const PanelRects debug = computePanelRects({1280, 800}, 16);
    const PanelRects learn = computePanelRects({1280, 800}, 16, LayoutPreset::Learn);
    const PanelRects present = computePanelRects({1280, 800}, 16, LayoutPreset::Present);
    CHECK(learn.left.size.x > 0.0F);
    CHECK(learn.right.size.x == 0.0F);
    CHECK(learn.view.size.x > debug.view.size.x);
    CHECK(present.view.size.x == 1280.0F);
    CHECK(present.menu.size.y == 0.0F);
    CHECK(present.drawer.size.y > 0.0F);
    CHECK(learn.narration.size.y == doctest::Approx(1.5F * debug.narration.size.y).epsilon(0.02));
    CHECK(present.narration.size.y - present.addressLine == learn.narration.size.y);
}

TEST_CASE("Layouts are found by name, and the cycle reaches all of them") {
    for (const LayoutPresetRow& row : layoutPresets()) {
        CHECK(layoutPresetFromName(row.name) == row.id);
        CHECK(&rowOf(row.id) == &row);
    }
    CHECK(layoutPresetFromName("wide") == std::nullopt);
    // Compare has a key of its own.
    LayoutPreset at = LayoutPreset::Debug;
    std::size_t seen = 0;
    do {
        CHECK(at != LayoutPreset::Compare);
        at = following(at);
        ++seen;
    } while (at != LayoutPreset::Debug);
    CHECK(seen == layoutPresets().size() - 1);
    CHECK(following(LayoutPreset::Compare) == LayoutPreset::Debug);
}

TEST_CASE("Compare has two views of the same size, with the column beside them") {
    for (const Screen& screen : kScreens) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        const PanelRects l = computePanelRects(screen.size, screen.em, LayoutPreset::Compare);
        CHECK(std::abs(l.view.size.x - l.otherView.size.x) <= 1.0F);
        CHECK(std::abs(l.view.size.y - l.otherView.size.y) <= 1.0F);
        CHECK(l.title.size.y == l.otherTitle.size.y);
        CHECK(l.left.size.x > 0.0F);
        CHECK(l.right.size.x == 0.0F);
        // They are placed so that each has as much room as possible.
        const bool beside = l.otherView.min.y == l.view.min.y;
        const glm::vec2 both(l.status.size.x - l.left.size.x, l.narration.min.y - l.title.min.y);
        CHECK(beside == (std::min(0.5F * both.x, both.y) >= std::min(both.x, 0.5F * both.y)));
    }
    const PanelRects debug = computePanelRects({1280, 800}, 16);
    CHECK(debug.otherView.size == glm::vec2(0.0F));
    CHECK(debug.title.size == glm::vec2(0.0F));
}

TEST_CASE("Present has a second view beside the first where a step of a lesson compares") {
    PanelSizes sizes;
    sizes.lesson = sizes.beside = true;
    for (const Screen& screen : kScreens) {
        const PanelRects l =
            computePanelRects(screen.size, screen.em, LayoutPreset::Present, {}, sizes);
        CHECK(std::abs(l.view.size.x - l.otherView.size.x) <= 1.0F);
        CHECK(std::abs(l.view.size.y - l.otherView.size.y) <= 1.0F);
        CHECK(l.narration.size.x == screen.size.x);
        CHECK(l.otherNarration.size == glm::vec2(0.0F));
        sizes.caption = 1000.0F;
        const PanelRects asks =
            computePanelRects(screen.size, screen.em, LayoutPreset::Present, {}, sizes);
        CHECK(asks.narration.size.y > l.narration.size.y);
        sizes.caption = 0.0F;
    }
}

TEST_CASE("If no status bar has the address, a line above the caption has it") {
    for (const auto& [screen, layoutPreset] : allCases()) {
        CAPTURE(screen.size.x);
        CAPTURE(rowOf(layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, layoutPreset);
        CHECK((l.addressLine > 0.0F) == (l.status.size.y == 0.0F));
        // The caption keeps two lines.
        CHECK(l.narration.size.y - l.addressLine >= 2.0F * l.caption * screen.em);
    }
}

TEST_CASE("In a low window a large caption leaves the view half of the height") {
    for (const LayoutPreset layoutPreset : {LayoutPreset::Learn, LayoutPreset::Present}) {
        const PanelRects l = computePanelRects({1024, 640}, 32, layoutPreset);
        CHECK(l.view.size.y >= 0.49F * (l.view.size.y + l.narration.size.y));
    }
}

TEST_CASE("A page has its form, its view and its controls beside each other, none outside") {
    for (const glm::vec2 size :
         {glm::vec2(1280, 800), glm::vec2(640, 400), glm::vec2(2560, 1440)}) {
        for (const float em : {12.0F, 16.0F, 32.0F}) {
            const PanelRects l = computePageRects(size, em);
            CHECK(l.left.min.y == l.menu.max().y);
            CHECK(l.view.min.x == l.left.max().x);
            CHECK(l.view.max().x == size.x);
            CHECK(l.narration.min.y == l.view.max().y);
            CHECK(l.narration.max().y == size.y);
            CHECK(l.left.max().y == size.y);
            CHECK(l.view.size.x >= 0.5F * size.x);
            // Overlays depend on the size of the window.
            CHECK(l.status.max() == size);
        }
    }
}

TEST_CASE("A view alone leaves room for what a picture has with it") {
    const PanelRects alone = viewAlone({1000.0F, 800.0F});
    CHECK(alone.view.size == glm::vec2(1000.0F, 800.0F));
    CHECK_FALSE(alone.dialApart);
    const PanelRects all = viewAlone({1600.0F, 800.0F}, {60.0F, 27.0F, 300.0F});
    CHECK(all.layoutPreset == LayoutPreset::Compare);
    CHECK(all.dial.min == glm::vec2(1300.0F, 0.0F));
    CHECK(all.view.size == glm::vec2(650.0F, 713.0F));
    CHECK(all.otherView.min == glm::vec2(650.0F, 27.0F));
    CHECK(all.otherTitle.size == glm::vec2(650.0F, 27.0F));
    CHECK(all.narration.min.y == 740.0F);
}
