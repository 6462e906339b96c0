#include "interface/go_to_box.h"

#include <doctest/doctest.h>

#include <string_view>

using namespace se::view;

namespace {

void type(GoToBox& box, std::string_view text) {
    for (const char c : text) {
        // A key comes first, then its sign, as from a window.
        CHECK(box.press({c, kNoMods}));
        box.type(static_cast<unsigned char>(c));
    }
}

}  // namespace

TEST_CASE("What is typed into the go-to box is handed over by Enter, once") {
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
    CHECK(box.press(*keyFromString("Space")));
    CHECK(box.press(*keyFromString("L")));
    CHECK(box.active());
}

TEST_CASE("The box takes no more than an address can be long, and no signs that none has") {
    GoToBox box;
    box.open();
    for (int i = 0; i < 1000; ++i) box.type('7');
    CHECK(box.text().size() <= 64);
    box.open();
    for (const unsigned sign : {0x0AU, 0x20U, 0x7FU, 0xE9U, 0x1F600U}) box.type(sign);
    CHECK(box.text().empty());
}
