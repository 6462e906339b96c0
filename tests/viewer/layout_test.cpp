#include "layout.h"

#include <doctest/doctest.h>

using namespace se::view;

namespace {

struct Screen {
    glm::vec2 size;
    float em;
};

constexpr Screen kScreens[] = {{{1280, 800}, 16}, {{1600, 900}, 16},  {{1024, 640}, 16},
                               {{1280, 800}, 32}, {{3840, 2160}, 32}, {{640, 400}, 16}};

bool overlap(const Rect& a, const Rect& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

}  // namespace

TEST_CASE("Panels fill the window without overlap, at every size") {
    for (const Screen& screen : kScreens) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.em);
        const Layout l = computeLayout(screen.size, screen.em);
        const Rect all[] = {l.menu, l.transport, l.left,   l.dial,  l.right,
                            l.view, l.narration, l.drawer, l.status};
        float area = 0.0F;
        for (const Rect& a : all) {
            area += a.size.x * a.size.y;
            CHECK(a.min.x >= 0.0F);
            CHECK(a.max().x <= screen.size.x);
            CHECK(a.max().y <= screen.size.y);
            for (const Rect& b : all) CHECK((&a == &b || !overlap(a, b)));
        }
        CHECK(area == doctest::Approx(screen.size.x * screen.size.y));
    }
}

TEST_CASE("The view never has less than 40 percent of the width") {
    for (const Screen& screen : kScreens) {
        const Layout l = computeLayout(screen.size, screen.em);
        CHECK(l.view.size.x >= 0.4F * screen.size.x);
        CHECK(l.view.size.y >= 0.2F * screen.size.y);
    }
}

TEST_CASE("Small windows have one column, low ones one strip") {
    CHECK_FALSE(computeLayout({1280, 800}, 16).narrow);
    CHECK(computeLayout({1280, 800}, 32).narrow);
    CHECK(computeLayout({1280, 800}, 16).stageStrip);
    CHECK_FALSE(computeLayout({1280, 800}, 32).stageStrip);
}
