#include "input/go_to_box.h"

#include <doctest/doctest.h>

#include <string_view>

using namespace se::view;

namespace {

void type(GoToBox& box, std::string_view text) {
    for (const char c : text) {
        // A key comes first, then its character, as from a window.
        CHECK(box.press({c, kNoMods}));
        box.type(static_cast<unsigned char>(c));
    }
}

}  // namespace

TEST_CASE("Text typed into the go-to box is submitted by Enter, once") {
    GoToBox box;
    box.open();
    type(box, "137.sortx");
    CHECK(box.press({key::kBackspace, kNoMods}));
    type(box, ".3");
    CHECK_FALSE(box.takeSubmitted());
    CHECK(box.press({key::kEnter, kNoMods}));
    CHECK(box.takeSubmitted());
    CHECK_FALSE(box.takeSubmitted());
    CHECK_FALSE(box.active());
    CHECK(box.text() == "137.sort.3");
}

TEST_CASE("Esc and an empty box lead nowhere") {
    GoToBox box;
    box.open();
    type(box, "12");
    box.press({key::kEscape, kNoMods});
    CHECK_FALSE(box.active());
    CHECK_FALSE(box.takeSubmitted());
    box.open();
    CHECK(box.text().empty());
    box.press({key::kEnter, kNoMods});
    CHECK_FALSE(box.takeSubmitted());
}

TEST_CASE("Function keys and Ctrl chords go past the open box, plain keys do not") {
    GoToBox box;
    box.open();
    CHECK_FALSE(box.press(*keyFromString("F10")));
    CHECK_FALSE(box.press(*keyFromString("Ctrl+Q")));
    CHECK_FALSE(box.press(*keyFromString("Ctrl+1")));
    // Editing keys belong to the box, as in any text field.
    CHECK(box.press(*keyFromString("Ctrl+Z")));
    CHECK(box.press(*keyFromString("Alt+Left")));
    CHECK(box.press(*keyFromString("Space")));
    CHECK(box.press(*keyFromString("L")));
    CHECK(box.active());
}

TEST_CASE("The box takes at most the length of an address, and only characters of addresses") {
    GoToBox box;
    box.open();
    for (int i = 0; i < 1000; ++i) box.type('7');
    CHECK(box.text().size() <= 64);
    box.open();
    for (const unsigned sign : {0x0AU, 0x20U, 0x7FU, 0xE9U, 0x1F600U}) box.type(sign);
    CHECK(box.text().empty());
}

TEST_CASE("The text of the box is edited at the caret") {
    GoToBox box;
    box.open();
    type(box, "17.sot");
    for (int i = 0; i < 5; ++i) box.press({key::kLeft, kNoMods});
    type(box, "3");
    CHECK(box.text() == "137.sot");
    box.press({key::kEnd, kNoMods});
    box.press({key::kLeft, kNoMods});
    type(box, "r");
    CHECK(box.text() == "137.sort");
    box.press({key::kHome, kNoMods});
    box.press({key::kLeft, kNoMods});  // no farther
    box.press({key::kDelete, kNoMods});
    CHECK(box.text() == "37.sort");
    box.press({key::kEnd, kNoMods});
    box.press({key::kDelete, kNoMods});
    box.press({key::kBackspace, kNoMods});
    CHECK(box.text() == "37.sor");
    CHECK(box.caret() == 6);
}

TEST_CASE("Ctrl+A selects the text of the box, the next input replaces it") {
    GoToBox box;
    box.open();
    type(box, "137");
    CHECK_FALSE(box.marked());
    box.press(*keyFromString("Ctrl+C"));
    CHECK(box.takeCopied().empty());  // nothing is selected
    box.press(*keyFromString("Ctrl+A"));
    CHECK(box.marked());
    box.press(*keyFromString("Ctrl+C"));
    CHECK(box.takeCopied() == "137");
    CHECK(box.takeCopied().empty());
    type(box, "2");
    CHECK(box.text() == "2");
    CHECK_FALSE(box.marked());
    box.press(*keyFromString("Ctrl+A"));
    box.press(*keyFromString("Ctrl+X"));
    CHECK(box.takeCopied() == "2");
    CHECK(box.text().empty());
    box.paste("4.sphere.1");
    box.press(*keyFromString("Ctrl+A"));
    box.press({key::kLeft, kNoMods});
    CHECK_FALSE(box.marked());
    CHECK(box.text() == "4.sphere.1");
    box.press(*keyFromString("Ctrl+A"));
    box.press({key::kBackspace, kNoMods});
    CHECK(box.text().empty());
}
