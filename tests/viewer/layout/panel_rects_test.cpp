#include "layout/panel_rects.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace se::view;

namespace {

struct Screen {
    glm::vec2 size;
    float em;
};

constexpr Screen kScreens[] = {{{1280, 800}, 16},  {{1600, 900}, 16},  {{1024, 640}, 16},
                               {{1280, 800}, 32},  {{3840, 2160}, 32}, {{640, 400}, 16},
                               {{2560, 1440}, 32}, {{390, 844}, 16}};

struct Case {
    Screen screen;
    WindowState state;
};

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const Screen& screen : kScreens) {
        for (const LayoutPresetRow& row : layoutPresets()) {
            for (const StripChoice strip :
                 {StripChoice::Auto, StripChoice::Folded, StripChoice::Open}) {
                for (const bool finished : {false, true}) {
                    WindowState state;
                    state.layoutPreset = row.id;
                    state.strip = strip;
                    state.finished = finished;
                    state.sheet = finished;
                    all.push_back({screen, state});
                }
            }
        }
    }
    return all;
}

bool overlapping(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

float areaOf(const Rect& rect) { return rect.size.x * rect.size.y; }

/// Share of the window that the view has.
float shareOf(const Screen& screen, const WindowState& state = {}) {
    const PanelRects l = computePanelRects(screen.size, screen.em, state);
    return areaOf(l.view) / (screen.size.x * screen.size.y);
}

}  // namespace

TEST_CASE("Areas fill the window without overlap, at every size") {
    for (const auto& [screen, state] : allCases()) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        CAPTURE(rowOf(state.layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, state);
        const Rect all[] = {l.menu,      l.view,  l.narration,  l.column, l.rail,
                            l.otherView, l.title, l.otherTitle, l.strip};
        float area = 0.0F;
        for (const Rect& a : all) {
            area += areaOf(a);
            CHECK(a.min.x >= 0.0F);
            CHECK(a.max().x <= screen.size.x);
            CHECK(a.max().y <= screen.size.y);
            for (const Rect& b : all) CHECK((&a == &b || !overlapping(a, b)));
        }
        CHECK(area == doctest::Approx(screen.size.x * screen.size.y));
    }
}

TEST_CASE("The parts of the strip lie in it without overlap") {
    for (const auto& [screen, state] : allCases()) {
        CAPTURE(screen.size.x);
        CAPTURE(rowOf(state.layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, state);
        const Rect all[] = {l.transport, l.pivotStrip, l.figures, l.runStrip, l.stageStrip};
        for (const Rect& a : all) {
            if (areaOf(a) <= 0.0F) continue;
            CHECK(a.min.y >= l.strip.min.y);
            CHECK(a.max().y <= l.strip.max().y + 0.01F);
            CHECK(a.max().x <= l.strip.max().x + 0.01F);
            for (const Rect& b : all) CHECK((&a == &b || areaOf(b) <= 0.0F || !overlapping(a, b)));
        }
    }
}

TEST_CASE("The view has most of the window: 58 percent while stepping, 64 when finished") {
    WindowState finished;
    finished.finished = true;
    WindowState folded;
    folded.sizes.folded = true;
    CHECK(shareOf({{1280, 800}, 16}) >= 0.58F);
    CHECK(shareOf({{1280, 800}, 16}, finished) >= 0.64F);
    CHECK(shareOf({{1280, 720}, 16}) >= 0.58F);
    CHECK(shareOf({{2560, 1440}, 32}) == doctest::Approx(shareOf({{1280, 720}, 16})).epsilon(0.01));
    CHECK(shareOf({{1920, 1080}, 16}) >= 0.58F);
    CHECK(shareOf({{1024, 640}, 16}) >= 0.5F);
    CHECK(shareOf({{1024, 640}, 16}, finished) >= 0.6F);
    folded.finished = true;
    CHECK(shareOf({{1024, 640}, 16}, folded) >= 0.85F);
}

TEST_CASE("The view always has some room") {
    for (const auto& [screen, state] : allCases()) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        CAPTURE(rowOf(state.layoutPreset).name);
        const PanelRects l = computePanelRects(screen.size, screen.em, state);
        // Where there are two, both together.
        const bool beside = l.otherView.min.y == l.view.min.y;
        CHECK(l.view.size.x + (beside ? l.otherView.size.x : 0.0F) >= 0.4F * screen.size.x);
        CHECK(l.view.size.y >= 0.14F * screen.size.y);
    }
}

TEST_CASE("The column is narrow in a small window, and can be folded to its rail") {
    const PanelRects wide = computePanelRects({1280, 800}, 16);
    const PanelRects small = computePanelRects({1024, 640}, 16);
    CHECK(small.column.size.x == 236.0F);
    CHECK(wide.column.size.x > small.column.size.x);
    WindowState state;
    state.sizes.folded = true;
    const PanelRects folded = computePanelRects({1280, 800}, 16, state);
    CHECK(areaOf(folded.column) == 0.0F);
    CHECK(folded.rail.size == wide.rail.size);
    CHECK(folded.view.size.x == wide.view.size.x + wide.column.size.x);
}

TEST_CASE("The user sets the width of the column, within limits") {
    for (const Screen& screen : kScreens) {
        for (const float ems : {1.0F, 22.0F, 500.0F}) {
            CAPTURE(screen.size.x);
            CAPTURE(ems);
            WindowState state;
            state.sizes.column = ems;
            const PanelRects l = computePanelRects(screen.size, screen.em, state);
            CHECK(l.view.size.x >= 0.4F * screen.size.x);
            CHECK(l.column.size.x <= 0.5F * screen.size.x);
            if (l.phone) continue;
            // The handle is where the border is.
            CHECK(l.splitter.min.x + 0.5F * l.splitter.size.x == l.column.min.x);
        }
    }
    WindowState state;
    state.sizes.column = 22.0F;
    CHECK(computePanelRects({1280, 800}, 16, state).column.size.x == 22.0F * 16.0F);
}

TEST_CASE("Lanes are folded on a finished run and in a low window, unless the user wants them") {
    WindowState state;
    const auto laidOut = [&](glm::vec2 size) { return computePanelRects(size, 16, state); };
    CHECK_FALSE(laidOut({1280, 800}).stripFolded);
    CHECK(laidOut({1280, 480}).stripFolded);
    CHECK(areaOf(laidOut({1280, 800}).pivotStrip) > 0.0F);
    CHECK(areaOf(laidOut({1280, 800}).stageStrip) == 0.0F);
    state.finished = true;
    CHECK(laidOut({1280, 800}).stripFolded);
    // No pivot has decisions: the run is a line in their place.
    CHECK(areaOf(laidOut({1280, 800}).pivotStrip) == 0.0F);
    CHECK(areaOf(laidOut({1280, 800}).runStrip) > 0.0F);
    state.strip = StripChoice::Open;
    CHECK_FALSE(laidOut({1280, 800}).stripFolded);
    CHECK(areaOf(laidOut({1280, 800}).stageStrip) > 0.0F);
    state = {};
    state.strip = StripChoice::Folded;
    CHECK(laidOut({1280, 800}).stripFolded);
    CHECK(areaOf(laidOut({1280, 800}).pivotStrip) > 0.0F);
}

TEST_CASE("A phone's shape has its parts below each other, and half of it is the sheet") {
    WindowState state;
    const PanelRects down = computePanelRects({390, 844}, 16, state);
    REQUIRE(down.phone);
    for (const Rect& each : {down.menu, down.view, down.narration, down.strip, down.rail})
        CHECK(each.size.x == 390.0F);
    CHECK(areaOf(down.column) == 0.0F);
    state.sheet = true;
    const PanelRects up = computePanelRects({390, 844}, 16, state);
    CHECK(up.column.size.x == 390.0F);
    CHECK(up.column.size.y >= 0.4F * 844.0F);
    CHECK(up.view.size.y >= 0.25F * 844.0F);
    CHECK(up.rail.min == down.rail.min);
    // Buttons that a finger hits.
    CHECK(up.strip.size.y >= 44.0F);
    // A question has the room of what it hides, and the view keeps its own.
    state.asks = true;
    const PanelRects asks = computePanelRects({390, 844}, 16, state);
    CHECK(asks.view.size == up.view.size);
    CHECK(asks.column.max().y == 844.0F);
    CHECK(areaOf(asks.strip) + areaOf(asks.rail) + areaOf(asks.transport) == 0.0F);
    // A small window is wider than high.
    CHECK_FALSE(computePanelRects({1280, 800}, 32).phone);
    CHECK_FALSE(computePanelRects({640, 400}, 16).phone);
}

TEST_CASE("Present has no panels, and a large caption") {
    WindowState state;
    state.layoutPreset = LayoutPreset::Present;
    const PanelRects present = computePanelRects({1280, 800}, 16, state);
    CHECK(present.view.size.x == 1280.0F);
    for (const Rect& each : {present.menu, present.column, present.rail, present.transport})
        CHECK(areaOf(each) == 0.0F);
    CHECK(areaOf(present.runStrip) > 0.0F);
    CHECK(present.caption > 1.0F);
    // It has the address, which no other part has.
    CHECK(present.addressLine > 0.0F);
    CHECK(present.narration.size.y - present.addressLine >= 2.0F * present.caption * 16.0F);
    CHECK(computePanelRects({1280, 800}, 16).captionInView());
    const PanelRects low = computePanelRects({1024, 640}, 32, state);
    CHECK(low.view.size.y >= 0.49F * (low.view.size.y + low.narration.size.y));
}

TEST_CASE("Layouts are found by name, and the cycle reaches all of them") {
    for (const LayoutPresetRow& row : layoutPresets()) {
        CHECK(layoutPresetFromName(row.name) == row.id);
        CHECK(&rowOf(row.id) == &row);
        CHECK_FALSE(opensLessons(row.name));
    }
    CHECK(layoutPresetFromName("wide") == std::nullopt);
    // That of version 0.2.
    CHECK(layoutPresetFromName("learn") == LayoutPreset::Debug);
    CHECK(opensLessons("learn"));
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

TEST_CASE("Compare has two views of the same size, beside the column") {
    WindowState state;
    state.layoutPreset = LayoutPreset::Compare;
    for (const Screen& screen : kScreens) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        const PanelRects l = computePanelRects(screen.size, screen.em, state);
        CHECK(std::abs(l.view.size.x - l.otherView.size.x) <= 1.0F);
        CHECK(std::abs(l.view.size.y - l.otherView.size.y) <= 1.0F);
        CHECK(l.title.size.y == l.otherTitle.size.y);
        CHECK(areaOf(l.rail) > 0.0F);
        // They are placed so that each has as much room as possible.
        const bool beside = l.otherView.min.y == l.view.min.y;
        const glm::vec2 both(l.otherView.max() - l.title.min);
        CHECK(beside == (std::min(0.5F * both.x, both.y) >= std::min(both.x, 0.5F * both.y)));
    }
    const PanelRects debug = computePanelRects({1280, 800}, 16);
    CHECK(debug.otherView.size == glm::vec2(0.0F));
    CHECK(debug.title.size == glm::vec2(0.0F));
}

TEST_CASE("Present has a second view beside the first where a step of a lesson compares") {
    WindowState state;
    state.layoutPreset = LayoutPreset::Present;
    state.lesson = state.beside = true;
    for (const Screen& screen : kScreens) {
        const PanelRects l = computePanelRects(screen.size, screen.em, state);
        CHECK(std::abs(l.view.size.x - l.otherView.size.x) <= 1.0F);
        CHECK(std::abs(l.view.size.y - l.otherView.size.y) <= 1.0F);
        CHECK(l.narration.size.x == screen.size.x);
        // The text has the height that it needs, up to a limit.
        state.captionEms = 8.0F;
        const PanelRects low = computePanelRects(screen.size, screen.em, state);
        CHECK(low.narration.size.y == std::min(8.0F * screen.em, std::round(0.4F * screen.size.y)));
        state.captionEms = 1000.0F;
        const PanelRects high = computePanelRects(screen.size, screen.em, state);
        CHECK(high.narration.size.y == std::round(0.4F * screen.size.y));
        state.captionEms = 0.0F;
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
            CHECK(l.window == size);
        }
    }
}

TEST_CASE("A view alone leaves room for what a picture has with it") {
    const PanelRects alone = viewAlone({1000.0F, 800.0F});
    CHECK(alone.view.size == glm::vec2(1000.0F, 800.0F));
    CHECK(areaOf(alone.dial) == 0.0F);
    const PanelRects all = viewAlone({1600.0F, 800.0F}, {60.0F, 27.0F, 300.0F});
    CHECK(all.layoutPreset == LayoutPreset::Compare);
    CHECK(all.dial.min == glm::vec2(1300.0F, 0.0F));
    CHECK(all.view.size == glm::vec2(650.0F, 713.0F));
    CHECK(all.otherView.min == glm::vec2(650.0F, 27.0F));
    CHECK(all.otherTitle.size == glm::vec2(650.0F, 27.0F));
    CHECK(all.narration.min.y == 740.0F);
}
