#include "input/typing_wait.h"

#include <doctest/doctest.h>

#include "panel_state/ui_state.h"

using namespace se::view;

TEST_CASE("Keys wait from the command that opens a text field until the field takes them") {
    TypingWait wait;
    CHECK_FALSE(wait.waits());
    wait.see(kQueryField);
    CHECK(wait.waits());
    // The panel has requested the keyboard, but does not have it.
    wait.endFrame(false);
    wait.see(kNoField);
    CHECK(wait.waits());
    // It is active, but plain keys still go to actions.
    wait.takesKeys();
    wait.endFrame(false);
    CHECK(wait.waits());
    wait.takesKeys();
    wait.endFrame(true);
    CHECK_FALSE(wait.waits());
}

TEST_CASE("A text field that had the keyboard before does not end the wait for another one") {
    TypingWait wait;
    wait.see(kPaletteField);
    wait.takesKeys();
    wait.endFrame(true);
    REQUIRE_FALSE(wait.waits());
    wait.see(kPaletteField);
    CHECK_FALSE(wait.waits());
    // The palette runs "Find decisions...": its own line is gone, the other one is about to appear.
    wait.see(kQueryField);
    CHECK(wait.waits());
    wait.endFrame(true);
    CHECK(wait.waits());
}

TEST_CASE("Keys do not wait forever for a text field that never appears") {
    TypingWait wait;
    wait.see(kLedgerField);
    int frames = 0;
    for (; wait.waits() && frames < 100; ++frames) wait.endFrame(false);
    CHECK(frames > 4);
    CHECK(frames < 30);
}

TEST_CASE("All text fields that commands open are waited for") {
    UiState ui;
    CHECK(ui.typedFields() == kNoField);
    ui.palette.show();
    ui.fileBrowser = true;
    ui.query.wantsKeyboard = true;
    ui.ledger.wantsKeyboard = true;
    CHECK(ui.typedFields() == (kPaletteField | kBrowserField | kQueryField | kLedgerField));
}
