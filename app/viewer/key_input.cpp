/// Dispatch of a key: to a question, the go-to box, a text field, a panel or an action.
#include <imgui.h>
#include <imgui_internal.h>

#include "application.h"
#include "commands/commands.h"
#include "document/link.h"
#include "document/piece_actions.h"
#include "input/key_routing.h"
#include "lesson/lesson_actions.h"
#include "session/view_position.h"

namespace se::view {

void Application::character(const KeyPress& typed) {
    if (ui_.goTo.active()) {
        if (isText(typed)) ui_.goTo.type(typed.sign);
        return;
    }
    if (ui_.keyEditor) return;
    // The position of digits and signs differs between keyboards; a key with a command has acted.
    const std::optional<KeyChord> chord = chordOfSign(typed);
    if (chord && commandFor(typed.chord) == nullptr) key(*chord, typed.repeated);
}

/// The go-to box comes before all actions.
bool Application::goToBoxTakes(const KeyChord& chord) {
    GoToBox& box = ui_.goTo;
    if (chord == KeyChord{'V', kCtrl}) {
        const std::string text = ui_.clipboard.text();
        const Result<ViewPosition> place = viewPositionFromText(text);
        const Result<Options> link = isLink(text) ? optionsFromLink(text) : Error{};
        const std::string& address = link    ? link.value().goTo
                                     : place ? place.value().address
                                             : text;
        box.paste(address);
        return true;
    }
    if (!box.press(chord)) return false;
    if (const std::string copied = box.takeCopied(); !copied.empty()) ui_.clipboard.copy(copied);
    if (box.takeSubmitted()) goToTyped();
    return true;
}

void Application::goToTyped() {
    playback_.pause();
    const Status status = session_.moves().goToText(ui_.goTo.text());
    if (!status) session_.messages().say(status.error().message);
}

bool Application::key(const KeyChord& chord, bool repeated) {
    if (ui_.keyCapture.active()) {
        ui_.keyCapture.press(chord, ui_.settings.keys);
        return false;
    }
    if (firstRun_.key()) return false;
    if (ui_.goTo.active() && goToBoxTakes(chord)) return false;
    const ImGuiIO& io = ImGui::GetIO();
    if (chord.key == key::kEscape && io.WantTextInput && !ui_.dialogOpen()) {
        // Dear ImGui would undo the edit of the text.
        ImGui::ClearActiveID();
        return true;
    }
    const bool enter = chord.key == key::kEnter || chord.key == key::kKeypadEnter;
    const bool panel = ui_.walk.at() != KeyStop::View || (session_.startPage() && !ui_.growth.open);
    if (enter && chord.mods == kNoMods && panel && io.NavVisible && !io.WantTextInput &&
        !ui_.dialogOpen()) {
        // Dear ImGui itself handles Space only.
        ImGui::ActivateItem(ImGui::GetFocusID());
        return true;
    }
    if (endsBlankScreen(chord)) return true;
    const bool over = io.WantTextInput || ui_.dialogOpen() || ui_.popupOpen;
    if (!over && !repeated && runOnPieceTool(chord, context_)) return true;
    if (!over && !repeated && answerByKey(chord, context_)) return true;
    if (isShiftKey(chord.key) && !repeated) ui_.look.shift(true, ui_.clock);
    const Command* command = commandFor(chord);
    // A question comes first.
    if (ui_.leaving.asked && command != findCommand("help.leave")) return false;
    if (command == nullptr || (repeated && !command->repeats)) return false;
    const bool closes = ui_.cheatSheet && command == findCommand("help.keys");
    const Keyboard keyboard{io.WantTextInput, ui_.dialogOpen() && !closes,
                            io.NavVisible && io.WantCaptureKeyboard && !isOfLesson(*command)};
    const bool reaches = reachesActions(chord, keyboard);
    if (reaches && !holdsLook(*command, chord.key)) runCommand(*command, context_);
    ui_.typing.see(ui_.typedFields());
    // Dear ImGui's own navigation is not used.
    return reaches && chord.key == key::kTab;
}

/// Any key shows the blanked window again, and does nothing else.
bool Application::endsBlankScreen(const KeyChord& chord) {
    if (ui_.blank == BlankScreen::None || isModifierKey(chord.key)) return false;
    ui_.blank = BlankScreen::None;
    return true;
}

/// The commands of the open lesson come before those of panels and of a presenter's remote control.
bool Application::isOfLesson(const Command& command) const {
    return ui_.lesson.walk.isOpen() && command.id.starts_with("lesson.");
}

/// The command of a key in the present layout.
const Command* Application::commandFor(const KeyChord& chord) const {
    const Command* usual = ui_.settings.keys.commandFor(chord);
    if (usual != nullptr && isOfLesson(*usual)) return usual;
    const bool present = ui_.layoutPreset == LayoutPreset::Present && !ui_.growth.open;
    const Command* first = present ? presenterCommandFor(chord) : nullptr;
    // Where a question is open, the start of what is shown is its position.
    if (first != nullptr && first == findCommand("run.start") && ui_.lesson.hides())
        return findCommand("lesson.return");
    return first != nullptr ? first : usual;
}

/// The two actions that last while their key is held.
bool Application::holdsLook(const Command& command, int key) {
    if (ui_.growth.open) return false;
    const bool blinks = &command == findCommand("step.blink");
    if (!blinks && &command != findCommand("step.before")) return false;
    ui_.look.begin(blinks ? LookBack::Mode::Blink : LookBack::Mode::Before, key, ui_.clock);
    return true;
}

void Application::keyReleased(const KeyChord& chord) {
    ui_.look.released(chord.key);
    if (isShiftKey(chord.key)) ui_.look.shift(false, ui_.clock);
}

}  // namespace se::view
