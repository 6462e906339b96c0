/// Areas, column, strips, the start page and keys that lead through all of them.
#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "driven_app.h"
#include "open_session.h"
#include "run/strings.h"
#include "spiraling_edge/base/atomic_file.h"

using namespace se;
using namespace se::view;
using test::differing;
using test::DrivenApp;

namespace {

/// Opens every part of every task.
void checkParts(DrivenApp& app) {
    for (const PartRow& row : partRows()) {
        const std::string title(row.title);
        CAPTURE(title);
        // It is there while two runs are compared.
        if (title == kComparePart) continue;
        app.part(title);
        CHECK(app.ui.column.task == row.task);
        CHECK(app.shows("part " + title));
        CHECK(isOpen(app.ui.settings.parts, row));
    }
    app.clickOn("rail Step");
}

/// No region leaves the window, and the view has most of it.
void checkRoom(DrivenApp& app, glm::vec2 size, float share) {
    CAPTURE(size.x);
    for (const char* name : {"view", "column", "rail", "strip", "narration"}) {
        const Rect area = app.ui.where.at(std::string("region ") + name);
        CAPTURE(name);
        CHECK(area.max().x <= size.x);
        CHECK(area.max().y <= size.y);
    }
    const glm::vec2 view = app.app.areas().view.size;
    CHECK(view.x * view.y >= share * size.x * size.y);
}

}  // namespace

TEST_CASE("Every part opens from the rail, in every size of the window") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    checkRoom(app, {1280, 800}, 0.58F);
    checkParts(app);
    app.resize({1600, 900});
    checkRoom(app, {1600, 900}, 0.58F);
    app.resize({1024, 640});
    checkRoom(app, {1024, 640}, 0.5F);
    checkParts(app);
    app.resize({390, 844});
    checkRoom(app, {390, 844}, 0.25F);
    checkParts(app);
    CHECK(app.address() == "137.sphere.1");
}

TEST_CASE("The sheet of the keys fits a window of 1280x800 without scrolling") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    app.press("F1");
    const ImGuiWindow* sheet = ImGui::FindWindowByName("Keys and mouse");
    REQUIRE(sheet != nullptr);
    CHECK(sheet->ScrollMax.y == 0.0F);
}

TEST_CASE("The decisions of a stage fill their strip from end to end") {
    DrivenApp app({"scene:torus", "--goto", "137.emit.1"});
    if (!app) return;
    app.press("Ctrl+J Ctrl+J");
    app.click(app.in("strip stage", 0.95F));
    CHECK(app.address() == "137.emit.3");
    app.click(app.in("strip stage", 0.05F));
    CHECK(app.address() == "137.emit.1");
}

TEST_CASE("All stages of a pivot are named where there is room for their names") {
    for (const char* place : {"71.sphere.2", "262.sphere.2"}) {
        CAPTURE(place);
        DrivenApp app({"scene:torus", "--goto", place});
        if (!app) return;
        for (const char* stage : {"pivot", "sort", "limits", "sphere", "emit", "ring", "advance"})
            CHECK(app.shows(std::string("stage name ") + stage));
    }
}

TEST_CASE("Lanes have the names of their rings, in Present too") {
    for (const char* layout : {"debug", "present"}) {
        CAPTURE(layout);
        DrivenApp app({"scene:torus", "--goto", "137.sphere.3", "--layout", layout});
        if (!app) return;
        for (const char* ring : {"a", "b", "c", "f"}) CHECK(app.shows(std::string("lane ") + ring));
    }
}

TEST_CASE("The sentence with all digits stands above the caption that it repeats") {
    for (const char* layout : {"debug", "present"}) {
        CAPTURE(layout);
        DrivenApp app({"scene:torus", "--goto", "137.sphere.3", "--layout", layout});
        if (!app) return;
        const bool over = app.shows("caption");
        const Rect caption = over ? app.ui.where.at("caption") : app.app.areas().narration;
        app.moveTo(caption.min + 0.5F * caption.size);
        const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
        REQUIRE(tip != nullptr);
        REQUIRE(tip->Active);
        CHECK(tip->Pos.y + tip->Size.y <= caption.min.y);
        CHECK(tip->Pos.y > 0.0F);
    }
}

TEST_CASE("On a phone the menu has address, layers, legend and bookmarks, and the sentence stays") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"}, {390, 844});
    if (!app) return;
    const auto choose = [&](const std::string& item) {
        app.clickOn("menu");
        app.clickOn("item " + item);
    };
    app.clickOn("rail Step");
    CHECK(app.app.areas().column.size.y > 300.0F);
    CHECK(app.app.areas().narration.size.y > 60.0F);
    app.clickOn("rail Step");
    CHECK_FALSE(app.shows("legend"));
    choose("view.legend");
    CHECK(app.shows("legend"));
    choose("view.legend");
    CHECK_FALSE(app.shows("legend"));
    choose("step.goto");
    app.type("140.sphere.1");
    app.press("Enter");
    CHECK(app.address() == "140.sphere.1");
    for (const char* item : {"view.layers", "notes.show"}) {
        choose(item);
        CHECK(app.ui.popupOpen);
        app.press("Esc");
        CHECK_FALSE(app.ui.popupOpen);
    }
}

TEST_CASE("The offer of the tour lies in the column, not over the model") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    app.ui.offersTour = true;
    app.settle();
    app.frames(2);
    const Rect offer = app.ui.where.at("tour take");
    const Rect column = app.app.areas().column;
    CHECK(column.contains(offer.min));
    CHECK(column.contains(offer.max()));
    app.clickOn("tour later");
    CHECK_FALSE(app.shows("tour take"));
}

TEST_CASE("At twice the scale the view keeps its share") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1", "--ui-scale", "2"}, {2560, 1440});
    if (!app) return;
    CHECK(app["em"] == "32.0");
    checkRoom(app, {2560, 1440}, 0.58F);
    app.resize({1280, 800});
    checkRoom(app, {1280, 800}, 0.3F);
    checkParts(app);
}

TEST_CASE("The finished mesh has two thirds of the window, and no strip of a pivot") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    CHECK(app.shows("strip pivot"));
    CHECK(app.shows("part Dial"));
    app.press("End");
    checkRoom(app, {1280, 800}, 0.64F);
    CHECK_FALSE(app.shows("strip pivot"));
    app.clickOn("rail Step");
    CHECK_FALSE(app.shows("part Dial"));
    CHECK_FALSE(app.shows("part Rings"));
}

TEST_CASE("The task chooses the panel, until the user does") {
    DrivenApp app({"scene:noise"});
    if (!app) return;
    const auto task = [&] { return app["task"]; };
    CHECK(task() == "Step");
    app.press("End");
    CHECK(task() == "Faults");
    app.press("Shift+F10");
    CHECK(task() == "Step");
    app.press("F8");
    CHECK(task() == "Faults");
    app.press("W");
    CHECK(task() == "Why");
    app.press("F10");
    CHECK(task() == "Step");
    // What the user has picked stays, but a command shows its panel.
    app.clickOn("rail Find");
    app.press("Home F10 F11 End");
    CHECK(task() == "Find");
    app.press("F8");
    CHECK(task() == "Faults");
}

TEST_CASE("What is found meanwhile marks its place in the rail and switches nothing") {
    DrivenApp app({"scene:noise"});
    if (!app) return;
    CHECK(app["task"] == "Step");
    CHECK(app.shows("news Faults"));
    app.clickOn("rail Faults");
    CHECK_FALSE(app.shows("news Faults"));
}

TEST_CASE("The column follows its splitter, and is folded by its rail and by a key") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    const auto width = [&] { return app.ui.where.at("region column").size.x; };
    const float before = width();
    app.drag(app.in("splitter column"), {-40, 0});
    CHECK(width() == before + 40.0F);
    app.clickOn("rail Step");
    CHECK(width() == 0.0F);
    app.clickOn("rail Find");
    CHECK(width() == before + 40.0F);
    CHECK(app["task"] == "Find");
    app.press("Ctrl+Shift+J");
    CHECK(width() == 0.0F);
    // A command that needs the panel unfolds it.
    app.command("rules");
    CHECK(width() == before + 40.0F);
    CHECK(app["part"] == "Rules");
}

TEST_CASE("Folded parts stay folded") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    CHECK(isOpen(app.ui.settings.parts, *partNamed("Dial")));
    app.clickOn("part Dial");
    CHECK_FALSE(isOpen(app.ui.settings.parts, *partNamed("Dial")));
    app.clickOn("rail Find");
    app.clickOn("rail Step");
    CHECK_FALSE(isOpen(app.ui.settings.parts, *partNamed("Dial")));
    app.clickOn("part Dial");
    CHECK(isOpen(app.ui.settings.parts, *partNamed("Dial")));
}

TEST_CASE("The strips are clicked, dragged, zoomed and folded, the tree of steps is filtered") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.1"});
    if (!app) return;
    const auto strip = [&] { return app.ui.navigation.strip; };
    CHECK(app["strips"] == "open");
    app.press("Ctrl+J Ctrl+J");
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
    app.click(app.in("strip stage", 0.35F, 0.5F));
    CHECK(app.address() == "137.sphere.2");
    const glm::vec2 pivot = app.in("strip pivot", 0.01F, 0.5F);
    app.click(pivot);
    CHECK(app.address() == "137.pivot.1");
    app.wheel(pivot, -1.0F);
    CHECK(app.session.record().pivot == 138);
    app.press("Ctrl+J");
    CHECK(app["strips"] == "folded");
    app.press("Ctrl+J");
    CHECK(app["strips"] == "open");
    app.part("Steps");
    const std::size_t rows = app.ui.navigation.steps.rowCount();
    app.reach("region column", "steps filter");
    app.type("split");
    CHECK(app.ui.navigation.stepFilter.data() == std::string("split"));
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
    tabTo({"rail", "content", "view"});
    app.press("Ctrl+Tab");
    CHECK(app["keyboard"] == "rail");
    app.press("Shift+Tab Shift+Tab");
    CHECK(app["keyboard"] == "content");
    app.press("Esc");
    // The rail: Enter picks the task beside.
    tabTo({"rail"});
    app.press("Down Enter");
    CHECK(app["task"] == "Why");
    app.press("Up Enter");
    CHECK(app["task"] == "Step");
    app.press("Esc");
    app.part("Steps");
    app.part("Rings");
    app.press("Esc");
    tabTo({"rail", "content", "steps", "rings", "ring points", "view"});
    // Steps: from the row of the cursor on; Enter goes there and stays in the list.
    tabTo({"rail", "content", "steps"});
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
    tabTo({"rail", "content", "steps", "rings"});
    CHECK(app["highlighted_ring"] == "null");
    app.press("Enter");
    CHECK(app["highlighted_ring"] == "0");
    tabTo({"ring points"});
    app.press("Right Enter");
    CHECK(app.session.selected() != kNone);
}

TEST_CASE(
    "Esc leads from a panel to the view and keeps the selection, in a narrow window as well") {
    DrivenApp app({"scene:torus", "--goto", "137.sphere.3"});
    if (!app) return;
    app.goTo("p12");
    app.press("Tab Esc");
    CHECK(app["keyboard"] == "view");
    CHECK(app.session.selected() == 12);
    app.resize({640, 640});
    app.part("Steps");
    app.press("Esc Tab Tab Tab");
    CHECK(app["keyboard"] == "steps");
    const std::string at = app.address();
    app.press("Down Enter");
    CHECK(app.address() != at);
}

TEST_CASE("A file is replaced only at the second request, be it a session or a mesh") {
    const test::OwnFolder folder;
    DrivenApp app({"scene:sphere"});
    if (!app) return;
    const std::pair<const char*, const char*> dialogs[] = {{"Ctrl+Shift+S", "a.sesession"},
                                                           {"Ctrl+E", "a.ply"}};
    for (const auto& [key, name] : dialogs) {
        CAPTURE(name);
        const auto path = folder / name;
        REQUIRE(writeFileAtomically(path, "old").ok());
        for (const bool replaces : {false, true}) {
            app.press(key);
            app.press("Ctrl+A");
            app.type(path.string());
            app.press("Enter");
            CHECK(app.ui.states.of<FileBrowsing>().error ==
                  std::string(name) + " exists already. Replace it? Save again to do so.");
            app.press(replaces ? "Enter" : "Esc");
            CHECK_FALSE(app.ui.fileBrowser);
            CHECK((readText(path) == "old") != replaces);
        }
    }
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
    CHECK(app["task"] == "Step");
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

TEST_CASE("The sheet of keys has a row for every action") {
    DrivenApp app({"scene:sphere"});
    if (!app) return;
    app.command("change keys");
    for (const Command& command : commands()) {
        CAPTURE(std::string(command.id));
        // Esc cannot be changed.
        CHECK(app.ui.where.contains("key " + std::string(command.id)) !=
              (command.id == "help.leave"));
    }
}

TEST_CASE("Another key for an action is pressed in its row, a used one only by a second press") {
    DrivenApp app({"scene:sphere"});
    if (!app) return;
    app.command("change keys");
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
    app.clickOn("notes menu");
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
