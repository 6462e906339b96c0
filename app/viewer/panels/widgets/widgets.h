/// Small elements that several panels draw.
#pragma once

#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "panel_state/forms.h"
#include "panels/panel.h"
#include "run/strings.h"
#include "teach/lesson_text.h"

namespace se::view {

enum class KeyStop : std::uint8_t;
enum class TypedField : std::uint8_t;

enum class Icon { SkipStart, Back, StepBack, Play, Pause, StepForward, Forward, SkipEnd, Bookmark };

ImU32 toU32(const Color& color);
inline ImVec4 toVec4(const Color& color) { return {color.r, color.g, color.b, color.a}; }
inline ImVec2 toVec2(glm::vec2 v) { return {v.x, v.y}; }

/// Rectangle of the item drawn last.
inline Rect lastItem() {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    return {{low.x, low.y}, {high.x - low.x, high.y - low.y}};
}

/// Gives the item drawn last a name, by which test scripts find its rectangle, and a tooltip.
void nameItem(const PanelContext& context, const std::string& name, const std::string& tip = {});
/// Buttons with a text, a name and a tooltip, `width` pixels wide: 0: as wide as the text,
/// negative: up to that distance from the right end. True if clicked.
bool textButton(const PanelContext& context, const std::string& label, const std::string& name,
                const std::string& tip = {}, float width = 0.0F);
bool smallButton(const PanelContext& context, const std::string& label, const std::string& name,
                 const std::string& tip = {});
/// A row of a list with a name and a tooltip, highlighted if `on`. True if clicked.
bool selectable(const PanelContext& context, const std::string& label, bool on,
                const std::string& name, const std::string& tip = {});
/// A textButton() in the accent color if `on`: the next thing to do, or what is chosen.
bool accentButton(const PanelContext& context, bool on, const std::string& label,
                  const std::string& name, const std::string& tip = {}, float width = 0.0F);
/// Width of buttons with these texts beside each other.
float buttonsWidth(std::initializer_list<const char*> labels);
/// Puts the next item beside the last one if buttons with these texts fit there, else below it.
void sameLineFor(std::initializer_list<const char*> labels);
/// Enter, also that of the number pad. Space is Dear ImGui's own key for the focused button.
bool enterPressed();
/// A bar of progress with a button after it, which has the rest of the line. `text`: on the bar;
/// null: the percentage. True if the button was clicked.
bool progressAndStop(const PanelContext& context, double share, const char* text,
                     const std::string& name, float buttonEms = 4.0F);
/// For a text field that takes effect on Enter. A click selects its text, so that typing replaces
/// it.
inline constexpr ImGuiInputTextFlags kEntered =
    ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
/// A text field of one line without a limit of length, with a hint while it is empty. True if the
/// text changed, or with ImGuiInputTextFlags_EnterReturnsTrue on Enter.
bool textField(const char* label, const char* hint, std::string& text,
               ImGuiInputTextFlags flags = 0);
/// A line that actions open, with a button after it.
struct AskedLine {
    bool active = false;  ///< It has the keyboard focus.
    bool asked = false;   ///< By Enter or a click.
};
/// Draws one, as the item `name`.
AskedLine askingLine(const PanelContext& context, TypedField field, const char* hint,
                     std::string& text, const char* button, const std::string& name);
/// A dim name before the next item, which is at `x` em.
void fieldName(const PanelContext& context, const char* name, float x);
/// A text field of many lines without a limit of length. True if the text changed.
bool textArea(const char* label, std::string& text, const ImVec2& size);
/// Draws the items of a list, each with an id of its own, and removes the one whose drawing
/// `draw(item, number)` returns true.
template <class Items, class Draw>
void drawRemovable(Items& items, const Draw& draw) {
    std::size_t gone = items.size();
    for (std::size_t i = 0; i < items.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (draw(items[i], i)) gone = i;
        ImGui::PopID();
    }
    if (gone < items.size()) items.erase(items.begin() + static_cast<std::ptrdiff_t>(gone));
}
/// Draws those of `count` rows that can be seen, by `draw(number)`, and the row `kept` in any case.
/// `pitch`: their height in pixels; -1: that of the first.
template <class Draw>
void drawSeen(std::size_t count, float pitch, const Draw& draw,
              std::optional<std::size_t> kept = std::nullopt) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), pitch);
    const int row = static_cast<int>(kept.value_or(0));
    if (kept) clipper.ForceDisplayRangeByIndices(row, row + 1);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw(static_cast<std::size_t>(i));
    }
}
/// Width of a text in the current type.
inline float textWidth(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }
/// A dim text `margin` pixels before the right end of the current line.
void dimAtRight(const std::string& text, float margin = 0.0F);
/// A line across, with space above and below it.
void separator();
/// The item whose place on the screen is nearest to the pointer, and nearer than `reach` pixels;
/// null if none is. `placeOf(item)` is a position in pixels.
template <class Items, class PlaceOf>
auto nearestToPointer(const Items& items, float reach, const PlaceOf& placeOf) {
    const ImVec2 mouse = ImGui::GetMousePos();
    decltype(&*items.begin()) best = nullptr;
    for (const auto& item : items) {
        const glm::vec2 place = placeOf(item);
        const float distance = std::hypot(mouse.x - place.x, mouse.y - place.y);
        if (distance >= reach) continue;
        reach = distance;
        best = &item;
    }
    return best;
}
/// A line of text in this font, and in a color of its own.
void textIn(ImFont* font, const std::string& text);
void textIn(ImFont* font, const std::string& text, const Color& color);
/// Draws the blocks of a text, as wide as there is room. The target of the link that was clicked;
/// empty if none was.
std::string drawTextBlocks(const PanelContext& context,
                           const std::vector<teach::TextBlock>& blocks);

/// Begins a window without frame that fills `rect`. ImGui::End() must follow in any case.
bool beginRegion(const char* name, const Rect& rect, int extraFlags = 0);
/// A line with the title of a panel, and a dim note at its right end.
void heading(const PanelContext& context, const char* title, const std::string& note = {});
/// The note of a part of the column: dim, on a line of its own; nothing if empty.
void partNote(const std::string& note);
/// A button with a drawn icon, filled if `active`; `size` 0: of the usual size.
bool iconButton(const char* id, Icon icon, const char* tooltip, bool enabled, bool active,
                const PanelContext& context, ImVec2 size = {0.0F, 0.0F});
/// A button with a drawn icon that runs a command.
struct CommandButton {
    const char* id;
    Icon icon;
    const char* command;
    const char* text;
};
/// Draws it, filled if `active`, with a tooltip: its text, its keys and `help`.
void drawCommandButton(const PanelContext& context, const CommandButton& button,
                       const std::string& help, bool enabled, bool active = false,
                       ImVec2 size = {0.0F, 0.0F});
/// "Next pivot (F10, .)": with the user's keys.
std::string withKeys(const PanelContext& context, const std::string& text,
                     std::string_view command);
/// The buttons of a transport, side by side, with their keys; the next item follows them.
void drawButtons(const PanelContext& context, std::span<const CommandButton> buttons, bool enabled);
/// The speed of a playback, between the buttons that change it.
void drawSpeed(const PanelContext& context, const Playback& playback);
/// Gives the keyboard focus to the item drawn last.
void takeKeyboard();
/// Gives the keyboard focus to the first item of the current window; without one, arrows scroll
/// the window.
void takeKeyboardHere();
/// A text in lines that are broken at spaces only, never inside of a number: `width` pixels wide,
/// or as wide as there is room (0). One item, so that a tooltip is that of all lines. All running
/// text of panels goes through here, since Dear ImGui itself breaks lines after a decimal point.
void wrappedText(const std::string& text, float width = 0.0F);
void wrappedText(const std::string& text, const Color& color);
/// A complaint in the color of errors; nothing if the text is empty.
void complain(const PanelContext& context, const std::string& complaint);
/// wrappedText() in another font.
void wrappedIn(ImFont* font, const std::string& text);
/// The text with those line breaks, for other items.
std::string withBreaks(const std::string& text, float width = 0.0F);
/// A note in the color of less important text.
void dimText(const std::string& text, float width = 0.0F);
/// Tooltip of the item drawn last.
void tooltip(const std::string& text);
void showTooltip(const std::string& text);
/// A tooltip above `rect`, which it leaves visible.
void showTooltipAbove(const Rect& rect, const std::string& text);
/// Tooltip of the item drawn last with the definition of a word of the paper, if it is one.
void define(std::string_view word);
/// A triangle before what can be folded: it points down if that is open, otherwise to the right.
void drawFoldArrow(glm::vec2 middle, float radius, bool open, const Color& color);
/// Two columns: a dim name and a value.
void valueRow(const PanelContext& context, const char* name, const std::string& value);
void valueRow(const PanelContext& context, const char* name, const std::string& value,
              const Color& color);
/// Begins the table that valueRow() fills; `names`: the width of the first column, in em.
/// ImGui::EndTable() must follow if it returns true.
bool beginValues(const char* id, const PanelContext& context, float names = 7.2F);
/// A text at the right end of a cell of a table.
void textAtRight(const std::string& text, const Color& color);
/// A text that is cut with dots if it does not fit `width`.
std::string fitted(const std::string& text, float width);
/// The name of a file or a run, cut in the middle if it does not fit `width`.
std::string fittedName(const std::string& name, float width);
/// A dim line of text, shortened to `width` between two words; where it is, the tooltip has all.
void dimShortText(const std::string& text, float width);
/// A text cut between two words, with dots, if it does not fit `width`.
std::string fittedWords(const std::string& text, float width);
/// The lines of linesAtBlanks(), measured in the current type.
std::vector<std::string> wrapped(const std::string& text, float width);
/// Outcome of an event without a verdict: "in", "stranded", the
/// kind of an alert. Empty if there is no such word.
std::string_view wordOf(const Event& event);
/// Why there is no pivot at the cursor.
std::string noPivotText(const Session& session);
/// "137.sphere.3", or "start".
std::string addressText(const Session& session);
/// "137.sphere.3 · 6.3", with the section of the paper.
std::string addressAndSection(const Session& session);

// ---- Dialogs, plates over the view, the view itself ----
inline void fill(ImDrawList* list, const Rect& rect, const Color& color, float rounding = 0.0F) {
    list->AddRectFilled(toVec2(rect.min), toVec2(rect.max()), toU32(color), rounding);
}

/// Places the next window in the middle of the screen: `ems` large, if it fits with a margin. Its
/// size in pixels.
glm::vec2 placeDialog(const PanelContext& context, glm::vec2 ems, glm::vec2 margin = {2.0F, 2.0F});
/// Begins a dialog placed by placeDialog(). ImGui::End() must follow in any case.
bool beginDialog(const char* title, bool* open, int extraFlags = 0);

/// Begins a window without frame over the view: `top` em below its upper edge, otherwise in the
/// middle; at most `width` em wide, otherwise as wide as its content. ImGui::End() must follow.
bool beginOverView(const PanelContext& context, const char* name, std::optional<float> top,
                   std::optional<float> width, Color Palette::*border = &Palette::border);

/// Begins the window of a view; false if nothing of it is visible. ImGui::End() must follow.
bool beginView(const PanelContext& context, const char* name);
/// The item that takes the mouse in all of the view, but not where an earlier item is.
void offerView(const PanelContext& context);
/// The rendered picture of the view.
void drawViewPicture(const PanelContext& context);

// ---- Orbit, pan and zoom with the mouse, in any view ----
/// Moves the camera by the mouse on the item drawn last, which must fill the view.
void moveCameraByMouse(const PanelContext& context);
/// A press of the button on the item drawn last that was no drag, when it ends. To be called after
/// moveCameraByMouse().
bool isClick(const PanelContext& context, ImGuiMouseButton button);

// ---- What is derived from the points of an input ----
/// True if Enter was pressed in one of them. Test scripts find the items as `prefix` and their
/// names.
bool drawPrepareFields(const PanelContext& context, PrepareForm& form, const std::string& prefix);

/// Six fields in two rows, the lower corner first. True if Enter was pressed in one.
bool drawBoxFields(const PanelContext& context, BoxFields& fields);

/// The three axes on a plate in the lower right corner of the view, beside `taken`; a click on an
/// end looks from there. To be called before the scene takes the remaining clicks. The plate, in
/// pixels of the window; nothing if there is no room.
std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken);

}  // namespace se::view
