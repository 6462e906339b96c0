/// Areas, tabs, strips, the start page and keys that lead through all of them.
#include <doctest/doctest.h>

#include <set>

#include "driven_app.h"
#include "open_session.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;

namespace {

/// The names of the items that begin so, without that beginning.
std::vector<std::string> itemsOf(const DrivenApp& app, const std::string& beginning) {
    std::vector<std::string> names;
    for (const auto& [name, rect] : app.ui.where) {
        if (name.starts_with(beginning)) names.push_back(name.substr(beginning.size()));
    }
    return names;
}

/// Opens every visible tab.
void checkTabs(DrivenApp& app, std::size_t least) {
    std::size_t seen = 0;
    for (const std::string& name : itemsOf(app, "tab ")) {
        CAPTURE(name);
        // Where there is no room for all, another one may have replaced it.
        if (!app.shows("tab " + name)) continue;
        app.clickOn("tab " + name);
        CHECK(app["open_tab"] == name);
        ++seen;
    }
    CHECK(seen >= least);
}

/// Tabs that do not fit are opened from the list at their end.
void checkMoreTabs(DrivenApp& app) {
    if (!app.shows("more tabs")) return;
    app.clickOn("more tabs");
    const std::vector<std::string> names = itemsOf(app, "more ");
    CHECK(names.size() > 1);
    app.press("Esc");
    for (const std::string& name : names) {
        if (name == "tabs") continue;
        CAPTURE(name);
        // Opening another one may have made room for it.
        if (!app.shows("tab " + name)) {
            app.clickOn("more tabs");
            app.clickOn("more " + name);
        }
        if (app["open_tab"] != name) app.clickOn("tab " + name);
        CHECK(app["open_tab"] == name);
        CHECK(app.shows("tab " + name));
    }
}

/// No tab needs a second row or a list, and no region leaves the window.
void checkRoom(DrivenApp& app, glm::vec2 size, bool rows = true) {
    CAPTURE(size.x);
    if (rows) {
        CHECK_FALSE(app.shows("more tabs"));
        std::set<float> heights;
        for (const std::string& name : itemsOf(app, "tab "))
            heights.insert(app.ui.where.at("tab " + name).min.y);
        CHECK(heights.size() <= 2);
    }
    for (const char* name :
         {"view", "left", "dial", "right", "narration", "drawer", "find", "change"}) {
        const Rect area = app.ui.where.at(std::string("region ") + name);
        CAPTURE(name);
        if (area.size.x == 0.0F || area.size.y == 0.0F) continue;
        CHECK(area.max().x <= size.x);
        CHECK(area.max().y <= size.y);
    }
    const glm::vec2 view = app.app.areas().view.size;
    CHECK(view.x >= 0.39F * size.x);
    CHECK(view.y >= 150.0F);
}

}  // namespace

TEST_CASE("Every panel opens by its tab, in one row, in every size of the window") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    checkRoom(app, {1280, 800});
    checkTabs(app, 14);
    checkRoom(app, {1280, 800});
    app.resize({1600, 900});
    checkRoom(app, {1600, 900});
    app.resize({1024, 640});
    checkRoom(app, {1024, 640});
    checkTabs(app, 14);
    CHECK(app["drawer"] == "folded");
    CHECK(app.address() == "137.sphere.1");
}

TEST_CASE("At twice the scale one column has all groups, and a list the tabs beyond its rows") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1", "--ui-scale", "2"});
    if (!app) return;
    CHECK(app["em"] == "32.0");
    checkRoom(app, {1280, 800}, false);
    app.clickOn("group Steps");
    CHECK(app["open_tab"] == "Steps");
    for (const char* group : {"group Understand", "group Find", "group Change"}) {
        app.clickOn(group);
        checkTabs(app, 3);
        checkMoreTabs(app);
    }
}

TEST_CASE("Areas follow their splitters, and Find is folded by its button and its key") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    app.command("rules");
    const auto area = [&](const char* name) { return app.ui.where.at(name).size; };
    const float left = area("region left").x;
    const float lower = area("region find").y;
    app.drag(app.in("splitter left"), {-40, 0});
    CHECK(area("region left").x == left - 40.0F);
    app.drag(app.in("splitter lower", 0.3F, 0.5F), {0, -30});
    CHECK(area("region find").y == lower + 30.0F);
    app.clickOn("fold groups");
    CHECK(area("region find").y < 60.0F);
    app.clickOn("tab Ledger");
    CHECK(area("region find").y == lower + 30.0F);
    app.press("Ctrl+Shift+J");
    CHECK(area("region find").y < 60.0F);
}

TEST_CASE("The strips are clicked, dragged, zoomed and folded, the tree of steps is filtered") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    const auto strip = [&] { return app.ui.navigation.strip; };
    CHECK(app["drawer"] == "open");
    const glm::vec2 run = app.in("strip run", 0.5F, 0.6F);
    app.click(run);
    CHECK(app.session.record().pivot / 20 == 17);
    app.drag(run, {200, 0});
    CHECK(app.session.record().pivot / 100 == 4);
    app.wheel(run, 1.0F);
    app.wheel(run, 1.0F);
    CHECK_FALSE(strip().whole());
    app.doubleClick(run);
    CHECK(strip().whole());
    // STAGE and PIVOT: cells go to their tests.
    app.goTo("137.sphere.1");
    app.click(app.in("strip stage", 0.18F, 0.5F));
    CHECK(app.address() == "137.sphere.2");
    const glm::vec2 pivot = app.in("strip pivot", 0.01F, 0.5F);
    app.click(pivot);
    CHECK(app.address() == "137.pivot.1");
    app.wheel(pivot, -1.0F);
    CHECK(app.session.record().pivot == 138);
    app.press("Ctrl+J");
    CHECK(app["drawer"] == "folded");
    app.press("Ctrl+J");
    CHECK(app["drawer"] == "open");
    const std::size_t rows = app.ui.navigation.steps.rowCount();
    app.click(app.in("region left", 0.4F, 0.08F));
    app.type("split");
    CHECK(app.ui.navigation.steps.filterText() == "split");
    CHECK(app.ui.navigation.steps.rowCount() != rows);
}

TEST_CASE("By keyboard alone: Tab leads through the panels, arrows and Enter work in each") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.3"});
    if (!app) return;
    const auto tabTo = [&](std::initializer_list<const char*> stops) {
        for (const char* stop : stops) {
            app.press("Tab");
            CHECK(app["keyboard"] == stop);
        }
    };
    tabTo({"steps", "rings", "ring points", "tabs", "content", "find tabs", "change tabs", "view"});
    app.press("Ctrl+Tab");
    CHECK(app["keyboard"] == "steps");
    app.press("Shift+Tab Shift+Tab");
    CHECK(app["keyboard"] == "change tabs");
    app.press("Esc");
    // Steps: from the row of the cursor on; Enter goes there and stays in the list.
    tabTo({"steps"});
    app.press("Down Enter");
    CHECK(app.address() == "137.sphere.4");
    CHECK(app["keyboard"] == "steps");
    app.press("Up Up Enter");
    CHECK(app.address() == "137.sphere.2");
    // Plain keys belong to the list, function keys and chords do not.
    app.press("N");
    CHECK(app["pins"] == "{}");
    app.press("F10");
    CHECK(app.session.record().pivot == 138);
    app.press("Shift+F10 Esc");
    // Rings: Enter highlights one. Its points: Left and Right move, Enter selects.
    tabTo({"steps", "rings"});
    CHECK(app["highlighted_ring"] == "null");
    app.press("Enter");
    CHECK(app["highlighted_ring"] == "0");
    tabTo({"ring points"});
    app.press("Right Enter");
    CHECK(app.session.selected() != kNone);
    tabTo({"tabs"});
    CHECK(app["open_tab"] == "Inspect");
    app.press("Right Enter");
    CHECK(app["open_tab"] == "Paper");
    app.press("Left Enter");
    CHECK(app["open_tab"] == "Inspect");
    tabTo({"content"});
    const Picture before = app.picture();
    app.press("Down Down Down Down");
    CHECK(differing(before, app.picture()) > 200);
}

TEST_CASE(
    "Esc leads from a panel to the view and keeps the selection, in a narrow window as well") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.3"});
    if (!app) return;
    app.goTo("p12");
    app.press("Tab Esc");
    CHECK(app["keyboard"] == "view");
    CHECK(app.session.selected() == 12);
    // Find and Change are a line each until a tab is opened.
    app.press("Tab Tab Tab Tab Tab Tab Right Enter");
    CHECK(app["open_tab"] == "Ledger");
    app.press("Tab");
    CHECK(app["keyboard"] == "find");
    app.resize({640, 640});
    app.clickOn("group Steps");
    app.press("Tab");
    CHECK(app["keyboard"] == "steps");
    const std::string at = app.address();
    app.press("Down Enter");
    CHECK(app.address() != at);
}

TEST_CASE("On the start page keys of a run do nothing, and a tile opens its scene") {
    DrivenApp app({});
    if (!app) return;
    app.press("F10 F5 F Enter Space 1 Ctrl+B Ctrl+Z Ctrl+S Home");
    CHECK(app["start_page"] == "true");
    CHECK_FALSE(app.ui.fileBrowser);
    // Without waiting until the points of the page have spread.
    app.moveTo(app.in("start file.new.shape"));
    for (const bool down : {true, false}) app.hold(0, down);
    CHECK(app.ui.growth.open);
    app.press("Esc");
    app.clickOn("tile figure-1");
    CHECK(app["input"] == "scene:figure-1");
    CHECK(app["layout"] == "learn");
}

TEST_CASE("A key, a drag in the view and the go-to box are one step of undo each") {
    DrivenApp app({"scene:sphere"});
    if (!app) return;
    app.press("N");
    app.drag(app.in("region view", 0.5F, 0.3F), {80, 20});
    app.goTo("p12");
    CHECK(app["undo"] == "3");
    app.press("Ctrl+Z Ctrl+Z Ctrl+Z");
    CHECK(app["redo"] == "3");
    CHECK(app["layers"].find("normals") == std::string::npos);
    app.press("Ctrl+Shift+Z Ctrl+Y Ctrl+Y");
    CHECK(app.session.selected() == 12);
}

TEST_CASE("Another key for an action is pressed in its row, a used one only by a second press") {
    DrivenApp app({"scene:sphere"});
    if (!app) return;
    app.command("change keys");
    app.wheel({640, 400}, -2.0F);
    app.clickOn("key run.unit");
    app.press("N");
    CHECK(app["changed_keys"] == "0");
    app.press("N");
    CHECK(app["changed_keys"] == "2");
    app.press("Esc");
    const std::string unit = app["unit"];
    app.press("N");
    CHECK(app["unit"] != unit);
}

TEST_CASE("Notes are typed and saved while their field has the keyboard, the text grows by a key") {
    const test::OwnFolder folder;
    DrivenApp app({"scene:sphere", "--goto", "40.sphere.2"});
    if (!app) return;
    app.save(folder / "one.sesession");
    app.clickOn("tab Notes");
    app.clickOn("field notes");
    app.type("look here n");
    CHECK(app.ui.notes == "look here n");
    CHECK(app["title"].find("unsaved") != std::string::npos);
    app.press("F10 Ctrl+S");
    CHECK(app.session.record().pivot == 41);
    CHECK(app["unsaved"] == "false");
    app.press("Esc Ctrl+=");
    CHECK(app.ui.notes == "look here n");
    CHECK(app["em"] == "20.0");
    app.press("Ctrl+-");
    CHECK(app["em"] == "16.0");
}
