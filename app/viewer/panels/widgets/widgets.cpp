#include "widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <utility>

#include "document/ui_state.h"
#include "input/key_routing.h"
#include "input/view_drag.h"
#include "layout/overlays.h"
#include "paint/text_cut.h"
#include "panel_state/settings.h"
#include "rows/evidence_rows.h"
#include "rows/paper_text.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "screen_painter.h"
#include "session/playback.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

namespace {

constexpr const char* kEllipsis = "\xE2\x80\xA6";

void chevron(ImDrawList* list, ImVec2 c, float r, float direction, ImU32 color) {
    list->AddTriangleFilled({c.x - direction * 0.5F * r, c.y - r},
                            {c.x + direction * 0.75F * r, c.y},
                            {c.x - direction * 0.5F * r, c.y + r}, color);
}

void drawIcon(ImDrawList* list, ImVec2 c, float r, Icon icon, ImU32 color) {
    const auto bar = [&](float from, float to) {
        list->AddRectFilled({c.x + from * r, c.y - r}, {c.x + to * r, c.y + r}, color);
    };
    // Points to the right, or to the left if `way` is -1.
    const auto arrow = [&](float x, float size, float way) {
        chevron(list, {c.x + x * r, c.y}, size * r, way, color);
    };
    const bool back = icon == Icon::SkipStart || icon == Icon::Back || icon == Icon::StepBack;
    const float way = back ? -1.0F : 1.0F;
    if (icon == Icon::Bookmark) {
        // A ribbon with a notch.
        for (const float side : {-1.0F, 1.0F})
            list->AddQuadFilled({c.x, c.y - r}, {c.x + 0.7F * side * r, c.y - r},
                                {c.x + 0.7F * side * r, c.y + 1.1F * r}, {c.x, c.y + 0.5F * r},
                                color);
    } else if (icon == Icon::Pause) {
        bar(-0.7F, -0.2F);
        bar(0.2F, 0.7F);
    } else if (icon == Icon::Play) {
        arrow(-0.1F, 1.15F, 1.0F);
    } else if (icon == Icon::StepBack || icon == Icon::StepForward) {
        arrow(0.1F * way, 0.85F, way);
    } else if (icon == Icon::Back || icon == Icon::Forward) {
        arrow(-0.5F, 0.85F, way);
        arrow(0.5F, 0.85F, way);
    } else {
        bar(0.8F * way - 0.16F, 0.8F * way + 0.16F);
        arrow(-0.2F * way, 1.0F, way);
    }
}

/// Dear ImGui calls back to resize the text whenever it grows.
int grow(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
    auto& text = *static_cast<std::string*>(data->UserData);
    text.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = text.data();
    return 0;
}

/// A press that moves by this share of the window's height is a drag.
constexpr float kDragShare = 0.01F;

}  // namespace

ImU32 toU32(const Color& color) { return ImGui::ColorConvertFloat4ToU32(toVec4(color)); }

void nameItem(const PanelContext& context, const std::string& name, const std::string& tip) {
    context.where()[name] = lastItem();
    // Items of our own drawing have no frame where the keyboard is; others draw the same one.
    const ImGuiLastItemData& item = ImGui::GetCurrentContext()->LastItemData;
    ImGui::RenderNavHighlight(item.NavRect, item.ID);
    if (!tip.empty()) tooltip(tip);
}

bool textButton(const PanelContext& context, const std::string& label, const std::string& name,
                const std::string& tip, float width) {
    const bool clicked = ImGui::Button(label.c_str(), {width, 0.0F});
    nameItem(context, name, tip);
    return clicked;
}

bool smallButton(const PanelContext& context, const std::string& label, const std::string& name,
                 const std::string& tip) {
    const bool clicked = ImGui::SmallButton(label.c_str());
    nameItem(context, name, tip);
    return clicked;
}

bool selectable(const PanelContext& context, const std::string& label, bool on,
                const std::string& name, const std::string& tip) {
    const bool clicked = ImGui::Selectable(label.c_str(), on);
    nameItem(context, name, tip);
    return clicked;
}

bool progressAndStop(const PanelContext& context, double share, const char* text,
                     const std::string& name, float buttonEms) {
    const float width = ImGui::GetContentRegionAvail().x - buttonEms * context.em;
    ImGui::ProgressBar(static_cast<float>(share), {width, 0.0F}, text);
    ImGui::SameLine();
    return textButton(context, "Stop", name);
}

bool textField(const char* label, const char* hint, std::string& text, ImGuiInputTextFlags flags) {
    return ImGui::InputTextWithHint(label, hint, text.data(), text.capacity() + 1,
                                    flags | ImGuiInputTextFlags_CallbackResize, grow, &text);
}

AskedLine askingLine(const PanelContext& context, TypedField field, const char* hint,
                     std::string& text, const char* button, const std::string& name) {
    TypingWait& typing = context.state<TypingWait>();
    if (typing.takeFocus(field)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - textWidth(button) -
                            1.5F * context.em);
    const bool entered = textField("##asking", hint, text, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool active = ImGui::IsItemActive();
    if (active) typing.takesKeys();
    if (ImGui::IsItemVisible()) nameItem(context, name);
    ImGui::SameLine();
    const bool clicked = ImGui::Button(button);
    return {active, clicked || entered};
}

void fieldName(const PanelContext& context, const char* name, float x) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(x * context.em);
}

bool textArea(const char* label, std::string& text, const ImVec2& size) {
    return ImGui::InputTextMultiline(label, text.data(), text.capacity() + 1, size,
                                     ImGuiInputTextFlags_CallbackResize, grow, &text);
}

bool accentButton(const PanelContext& context, bool on, const std::string& label,
                  const std::string& name, const std::string& tip, float width) {
    if (!on) return textButton(context, label, name, tip, width);
    const Palette& colors = context.palette;
    ImGui::PushStyleColor(ImGuiCol_Button, toVec4(colors.accent));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, toVec4(mix(colors.accent, colors.text, 0.15F)));
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(colors.accentText));
    const bool clicked = ImGui::Button(label.c_str(), {width, 0.0F});
    ImGui::PopStyleColor(3);
    nameItem(context, name, tip);
    return clicked;
}

float buttonsWidth(std::initializer_list<const char*> labels) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = -style.ItemSpacing.x;
    for (const char* each : labels)
        width += textWidth(each) + 2.0F * style.FramePadding.x + style.ItemSpacing.x;
    return width;
}

void sameLineFor(std::initializer_list<const char*> labels) {
    ImGui::SameLine();
    if (buttonsWidth(labels) > ImGui::GetContentRegionAvail().x) ImGui::NewLine();
}

bool enterPressed() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) ||
           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter));
}

void dimAtRight(const std::string& text, float margin) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - textWidth(text) - margin);
    ImGui::TextDisabled("%s", text.c_str());
}

void separator() {
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
}

void textIn(ImFont* font, const std::string& text) {
    ImGui::PushFont(font);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
}

void textIn(ImFont* font, const std::string& text, const Color& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
    textIn(font, text);
    ImGui::PopStyleColor();
}

bool beginRegion(const char* name, const Rect& rect, int extraFlags) {
    ImGui::SetNextWindowPos(toVec2(rect.min));
    ImGui::SetNextWindowSize(toVec2(rect.size));
    return ImGui::Begin(name, nullptr,
                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                            ImGuiWindowFlags_NoBringToFrontOnFocus | extraFlags);
}

void partNote(const std::string& note) {
    if (!note.empty()) dimText(note);
}

void drawFoldArrow(glm::vec2 middle, float radius, bool open, const Color& color) {
    const ImVec2 tip = toVec2(middle + 0.8F * radius * (open ? glm::vec2(0, 1) : glm::vec2(1, 0)));
    const ImVec2 half = open ? ImVec2(radius, 1.3F * radius) : ImVec2(1.3F * radius, radius);
    ImGui::RenderArrowPointingAt(ImGui::GetWindowDrawList(), tip, half,
                                 open ? ImGuiDir_Down : ImGuiDir_Right, toU32(color));
}

void heading(const PanelContext& context, const char* title, const std::string& note) {
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextUnformatted(title);
    const float titleEnd = ImGui::GetCursorPosX() + ImGui::GetItemRectSize().x;
    ImGui::PopFont();
    define(title);
    if (!note.empty()) {
        const float width = textWidth(note);
        const float left = ImGui::GetContentRegionMax().x - width;
        // Text that does not fit beside the title goes below it.
        if (left >= titleEnd + context.em) ImGui::SameLine(left);
        ImGui::TextDisabled("%s", note.c_str());
    }
}

bool iconButton(const char* id, Icon icon, const char* text, bool enabled, bool active,
                const PanelContext& context, ImVec2 size) {
    if (size.x <= 0.0F) size = {(active ? 2.6F : 1.9F) * context.em, ImGui::GetFrameHeight()};
    ImGui::BeginDisabled(!enabled);
    if (active) {
        ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.accent));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                              toVec4(mix(context.palette.accent, context.palette.text, 0.15F)));
    }
    const bool pressed = ImGui::Button(id, size);
    if (active) ImGui::PopStyleColor(2);
    const Rect at = lastItem();
    const Color color = active ? context.palette.accentText : context.palette.text;
    drawIcon(ImGui::GetWindowDrawList(), toVec2(0.5F * (at.min + at.max())), 0.32F * context.em,
             icon, toU32(enabled ? color : color.withAlpha(0.35F)));
    ImGui::EndDisabled();
    tooltip(text);
    return pressed;
}

void drawCommandButton(const PanelContext& context, const CommandButton& button,
                       const std::string& help, bool enabled, bool active, ImVec2 size) {
    if (iconButton(button.id, button.icon, help.c_str(), enabled, active, context, size))
        context.run(button.command);
}

std::string withKeys(const PanelContext& context, const std::string& text,
                     std::string_view command) {
    const std::string keys = context.settings().keys.all(*findCommand(command));
    return keys.empty() ? text : text + " (" + keys + ")";
}

void drawButtons(const PanelContext& context, std::span<const CommandButton> buttons,
                 bool enabled) {
    for (const CommandButton& b : buttons) {
        drawCommandButton(context, b, withKeys(context, b.text, b.command), enabled);
        ImGui::SameLine(0.0F, 0.2F * context.em);
    }
}

void drawSpeed(const PanelContext& context, const Playback& playback) {
    if (ImGui::Button("\xE2\x88\x92##slower", {1.6F * context.em, 0})) context.run("run.slower");
    tooltip(withKeys(context, "Slower", "run.slower"));
    ImGui::SameLine(0.0F, 0.0F);
    const std::string shown = playback.unlimited() ? "max" : formatted("%.3g/s", playback.rate());
    const float width = 3.4F * context.em;
    const float pad = 0.5F * (width - ImGui::CalcTextSize(shown.c_str()).x);
    const float x = ImGui::GetCursorPosX();
    ImGui::SetCursorPosX(x + pad);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.c_str());
    ImGui::SameLine(x + width);
    if (ImGui::Button("+##faster", {1.6F * context.em, 0})) context.run("run.faster");
    tooltip(withKeys(context, "Faster; above 60 a second, as fast as drawn", "run.faster"));
}

void takeKeyboard() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImGui::FocusWindow(ImGui::GetCurrentWindow());
    ImGui::SetFocusID(ImGui::GetItemID(), ImGui::GetCurrentWindow());
    g.NavDisableHighlight = false;
    g.NavDisableMouseHover = true;
}

void takeKeyboardHere() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImGui::FocusWindow(ImGui::GetCurrentWindow());
    ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
    g.NavDisableHighlight = false;
}

void dimShortText(const std::string& text, float width) {
    const std::string shown = fittedWords(text, width);
    ImGui::TextDisabled("%s", shown.c_str());
    if (shown != text) tooltip(text);
}

void wrappedText(const std::string& text, float width) {
    ImGui::TextUnformatted(withBreaks(text, width).c_str());
}

void wrappedText(const std::string& text, const Color& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
    wrappedText(text);
    ImGui::PopStyleColor();
}

void complain(const PanelContext& context, const std::string& complaint) {
    if (!complaint.empty()) wrappedText("! " + complaint, context.palette.rejected);
}

void wrappedIn(ImFont* font, const std::string& text) {
    ImGui::PushFont(font);
    wrappedText(text);
    ImGui::PopFont();
}

void dimText(const std::string& text, float width) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    wrappedText(text, width);
    ImGui::PopStyleColor();
}

void tooltip(const std::string& text) {
    // Keyboard navigation must show the next rows.
    if (ImGui::GetCurrentContext()->NavDisableMouseHover) return;
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) showTooltip(text);
}

void showTooltip(const std::string& text) {
    ImGui::BeginTooltip();
    wrappedText(text, 22.0F * ImGui::GetFontSize());
    ImGui::EndTooltip();
}

void showTooltipAbove(const Rect& rect, const std::string& text) {
    const float gap = 0.3F * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({rect.min.x, rect.min.y - gap}, ImGuiCond_Always, {0.0F, 1.0F});
    showTooltip(text);
}

void define(std::string_view word) {
    if (const std::string text = definitionOf(word); !text.empty()) tooltip(text);
}

bool beginValues(const char* id, const PanelContext& context, float names) {
    // In proportion to the content, a column would have no width in its first frame.
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchSame)) return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, names * context.em);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    return true;
}

void valueRow(const PanelContext& context, const char* name, const std::string& value) {
    valueRow(context, name, value, context.palette.text);
}

void valueRow(const PanelContext& context, const char* name, const std::string& value,
              const Color& color) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(toVec4(context.palette.textDim), "%s", name);
    define(name);
    ImGui::TableNextColumn();
    wrappedText(value, color);
}

void textAtRight(const std::string& text, const Color& color) {
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, room - textWidth(text)));
    ImGui::TextColored(toVec4(color), "%s", text.c_str());
}

std::string fitted(const std::string& text, float width) {
    if (textWidth(text) <= width) return text;
    std::string cut = text;
    while (!cut.empty() && textWidth(cut + kEllipsis) > width) {
        cut = withoutLastSign(std::move(cut));
    }
    return cut + kEllipsis;
}

std::string fittedName(const std::string& name, float width) {
    return withoutMiddle(name, width, textWidth);
}

std::string fittedWords(const std::string& text, float width) {
    if (textWidth(text) <= width) return text;
    for (std::size_t end = text.rfind(' '); end != std::string::npos && end > 0;
         end = text.rfind(' ', end - 1)) {
        // A number stays with what it counts.
        if (text[end - 1] >= '0' && text[end - 1] <= '9') continue;
        const std::string cut = text.substr(0, end) + " " + kEllipsis;
        if (textWidth(cut) <= width) return cut;
    }
    return fitted(text, width);
}

std::vector<std::string> wrapped(const std::string& text, float width) {
    return linesAtBlanks(text, width, textWidth);
}

std::string withBreaks(const std::string& text, float width) {
    std::string all;
    for (const std::string& line :
         wrapped(text, width > 0.0F ? width : ImGui::GetContentRegionAvail().x))
        all += line + "\n";
    all.pop_back();
    return all;
}

std::string_view wordOf(const Event& event) {
    if (const auto* ring = std::get_if<RingEvidence>(&event.evidence)) {
        return ring->inserted ? "in" : "out";
    }
    if (std::holds_alternative<StrandEvidence>(event.evidence)) return "stranded";
    if (std::holds_alternative<ShelveEvidence>(event.evidence)) return "ring shelved";
    if (std::holds_alternative<TakeUpEvidence>(event.evidence)) return "taken up";
    if (const auto* free = std::get_if<FreeEvidence>(&event.evidence))
        return free->seed ? "seed freed" : "ring freed";
    if (std::holds_alternative<ComponentEvidence>(event.evidence)) return "complete";
    if (const auto* alert = std::get_if<AlertEvidence>(&event.evidence)) {
        return alertName(alert->kind);
    }
    return {};
}

std::string noPivotText(const Session& session) {
    return session.atEnd() ? "No pivot here: the run is finished."
                           : "No pivot here. Step forward: F11 or \xE2\x86\x92.";
}

std::string addressText(const Session& session) {
    return session.ready() && session.event() != nullptr ? toString(session.address()) : "start";
}

std::string addressAndSection(const Session& session) {
    const std::string address = addressText(session);
    if (!session.ready() || session.event() == nullptr) return address;
    const std::string section = sectionOf(*session.event());
    return address + " \xC2\xB7 " + (section.empty() ? "not in the paper" : section);
}

glm::vec2 placeDialog(const PanelContext& context, glm::vec2 ems, glm::vec2 margin) {
    const glm::vec2 screen = context.rects.window;
    const glm::vec2 size = glm::min(ems * context.em, screen - margin * context.em);
    ImGui::SetNextWindowPos(toVec2(0.5F * screen), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(toVec2(size));
    return size;
}

bool beginDialog(const char* title, bool* open, int extraFlags) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown = ImGui::Begin(title, open,
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoSavedSettings | extraFlags);
    ImGui::PopStyleVar();
    return shown;
}

bool beginOverView(const PanelContext& context, const char* name, std::optional<float> top,
                   std::optional<float> width, Color Palette::*border) {
    const Rect& view = context.rects.view;
    const float y = top ? *top * context.em : 0.5F * view.size.y;
    ImGui::SetNextWindowPos({view.min.x + 0.5F * view.size.x, view.min.y + y}, ImGuiCond_Always,
                            {0.5F, top ? 0.0F : 0.5F});
    if (width) ImGui::SetNextWindowSize({std::min(*width * context.em, 0.9F * view.size.x), 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_Border, toVec4(context.palette.*border));
    const bool shown = ImGui::Begin(
        name, nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return shown;
}

bool beginView(const PanelContext& context, const char* name) {
    const Rect& view = context.rects.view;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(context.palette.background));
    const bool open =
        beginRegion(name, view, ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return open && view.size.x >= 1.0F && view.size.y >= 1.0F;
}

void offerView(const PanelContext& context) {
    ImGui::SetCursorScreenPos(toVec2(context.rects.view.min));
    ImGui::InvisibleButton("##scene", toVec2(context.rects.view.size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
}

void drawViewPicture(const PanelContext& context) {
    const Rect& view = context.rects.view;
    const auto texture =
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(context.viewTexture));
    const auto& tile = context.ui().picture.tile;
    if (!tile)
        return ImGui::GetWindowDrawList()->AddImage(texture, toVec2(view.min), toVec2(view.max()),
                                                    {0, 1}, {1, 0});
    const PixelRect part = partOfView(view, tile);
    const float bottom = view.min.y + std::floor(view.size.y);
    ImGui::GetWindowDrawList()->AddImage(
        texture,
        {view.min.x + static_cast<float>(part.min.x), bottom - static_cast<float>(part.max.y)},
        {view.min.x + static_cast<float>(part.max.x), bottom - static_cast<float>(part.min.y)},
        {0, 1}, {1, 0});
}

bool isClick(const PanelContext& context, ImGuiMouseButton button) {
    return ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(button) &&
           !context.state<ViewDrag>().drags();
}

void moveCameraByMouse(const PanelContext& context) {
    const Rect& view = context.rects.view;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer(io.MousePos.x, io.MousePos.y);
    ViewDrag& drag = context.state<ViewDrag>();
    if (ImGui::IsItemActivated()) drag.begin();
    if (ImGui::IsItemActive() && ImGui::IsMousePosValid()) {
        const glm::vec2 moved = drag.move(pointer, kDragShare * io.DisplaySize.y);
        const bool turns = ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift;
        if (moved != glm::vec2(0.0F))
            turns ? context.camera().orbit(moved, view.size.y)
                  : context.camera().pan(moved, view.size.y);
    }
    if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0F) return;
    const glm::vec2 at = (pointer - view.min) / view.size;
    context.camera().zoomAt(io.MouseWheel, {2.0F * at.x - 1.0F, 1.0F - 2.0F * at.y},
                            view.size.x / view.size.y);
}

// The axes on a plate: a disc with a letter at each positive end, an open one at each negative end.

namespace {

/// Sizes in em.
constexpr float kPlate = 5.4F;
constexpr glm::vec2 kLeastRoom{18.0F, 12.0F};
constexpr float kArm = 1.75F;
constexpr float kEnd = 0.62F;
constexpr float kFarEnd = 0.42F;
constexpr std::array kNames = {"x", "y", "z"};
/// Colors of the axes in all programs; softer than those of decisions, and with letters.
constexpr std::array kColors = {fromHex(0xC2504F), fromHex(0x5C9440), fromHex(0x4478C4)};

/// An end of an axis.
struct AxisEnd {
    std::size_t axis = 0;  ///< 0 to 2: x, y, z.
    bool positive = true;
    glm::vec2 at{0.0F};  ///< Middle, in pixels of the window.
    float near = 0.0F;   ///< From -1, away from the eye, to 1, toward it.
    bool hovered = false;
};

std::string nameOf(const AxisEnd& end) {
    return (end.positive ? "" : "-") + std::string(kNames[end.axis]);
}

/// The ends, those nearest to the eye first.
std::array<AxisEnd, 6> endsOf(const PanelContext& context, const Rect& plate) {
    const CameraMatrices camera = context.camera().matrices(1.0F);
    const glm::vec2 origin = plate.min + 0.5F * plate.size;
    std::array<AxisEnd, 6> ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        AxisEnd& end = ends[i];
        end.axis = i / 2;
        end.positive = i % 2 == 0;
        const float sign = end.positive ? 1.0F : -1.0F;
        const glm::vec3 seen = sign * glm::vec3(camera.view[static_cast<int>(end.axis)]);
        end.at = origin + glm::vec2(seen.x, -seen.y) * (kArm * context.em);
        end.near = seen.z;
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const AxisEnd& a, const AxisEnd& b) { return a.near > b.near; });
    return ends;
}

void drawEnd(const PanelContext& context, const AxisEnd& end, const glm::vec2& origin) {
    const float em = context.em;
    ScreenPainter p(context);
    // What points away from the eye steps back.
    const float share = 0.55F + 0.45F * std::clamp(end.near + 0.6F, 0.0F, 1.0F);
    const Color color = mix(context.palette.panel, kColors[end.axis], share);
    const float radius = (end.positive ? kEnd : kFarEnd) * em;
    if (end.positive) p.line(origin, end.at, Ink(color).line(std::max(1.5F, 0.14F * em)));
    const bool full = end.positive || end.hovered;
    p.circle(end.at, radius, Ink(full ? color : mix(context.palette.panel, color, 0.25F)));
    p.circle(end.at, radius,
             Ink(end.hovered ? context.palette.text : color).line(std::max(1.2F, 0.09F * em)));
    if (!end.positive) return;
    const Type type{0.85F * em, Typeface::Strong, Align::Middle};
    p.text(end.at - glm::vec2(0.0F, 0.54F * type.size), kNames[end.axis],
           p.ink(&Palette::accentText), type);
}

}  // namespace

std::optional<Rect> drawAxes(const PanelContext& context, std::span<const Rect> taken) {
    const float em = context.em;
    // In a small view the decision needs the room.
    const glm::vec2 room = context.rects.view.size / em;
    if (room.x < kLeastRoom.x || room.y < kLeastRoom.y) return std::nullopt;
    // The button Layers and the legend have the upper ones.
    constexpr std::array kCorners = {Corner::BottomRight};
    const std::optional<Rect> place =
        freeCorner({context.rects.view, 0.5F * em, taken, {}}, glm::vec2(kPlate * em), kCorners);
    if (!place) return std::nullopt;
    std::array<AxisEnd, 6> ends = endsOf(context, *place);
    for (AxisEnd& end : ends) {
        const glm::vec2 half(kEnd * em);
        const std::string name = "axis " + nameOf(end);
        ImGui::SetCursorScreenPos(toVec2(end.at - half));
        if (ImGui::InvisibleButton(("##" + name).c_str(), toVec2(2.0F * half))) {
            glm::vec3 from(0.0F);
            from[static_cast<int>(end.axis)] = end.positive ? 1.0F : -1.0F;
            context.camera().faceStraight(from);
        }
        end.hovered = ImGui::IsItemHovered();
        tooltip("Look from " + nameOf(end) + ".");
        context.where()[name] = {end.at - half, 2.0F * half};
    }
    const glm::vec2 origin = place->min + 0.5F * place->size;
    ScreenPainter painter(context);
    painter.circle(origin, 0.5F * place->size.x, painter.ink(&Palette::panel, 0.82F));
    for (auto end = ends.rbegin(); end != ends.rend(); ++end) drawEnd(context, *end, origin);
    return place;
}

// The fields of the preparation: one form for two panels.

namespace {

constexpr float kChoice = 11.0F;  ///< Width of a choice before its field, in em.
constexpr float kField = 4.5F;    ///< Minimum width of a field.
constexpr float kTwo = 22.0F;     ///< Width from which two switches are side by side.

/// Position of a field after its choice.
float xOfFields(const PanelContext& context) {
    const float room = ImGui::GetContentRegionMax().x - kField * context.em;
    return std::min(kChoice * context.em, room);
}

void besideIfRoom(const PanelContext& context) {
    if (ImGui::GetContentRegionMax().x >= kTwo * context.em) ImGui::SameLine(kChoice * context.em);
}

/// The form and the context of its drawing.
struct Fields {
    const PanelContext& context;
    PrepareForm& form;
    const std::string& prefix;

    /// Names the last item, if it can be seen, and gives it a tooltip.
    void name(const char* item, const char* tip = "") const {
        if (ImGui::IsItemVisible()) nameItem(context, prefix + item, tip);
    }
};

/// A choice; the next item is beside it.
template <typename T>
void choice(const Fields& fields, const char* label, T& value, T mine, const char* help) {
    if (ImGui::RadioButton(label, value == mine)) value = mine;
    fields.name(label, help);
}

void toggle(const Fields& fields, const char* label, bool& value, const char* help) {
    ImGui::Checkbox(label, &value);
    fields.name(label, help);
}

/// A title, and whether the current data was derived.
void part(const PanelContext& context, const char* title, bool derived) {
    ImGui::Spacing();
    heading(context, title, derived ? "derived now" : "from the input now");
}

/// A field; typing in it makes its choice.
template <typename T>
bool valueField(const Fields& fields, const char* id, std::string& text, T& value, T mine) {
    ImGui::SameLine(xOfFields(fields.context));
    ImGui::SetNextItemWidth(-1.0F);
    const std::string before = text;
    const bool entered = textField(id, "", text, kEntered);
    if (ImGui::IsItemActive()) fields.context.state<TypingWait>().takesKeys();
    if (text != before) value = mine;
    fields.name(id + 2);
    return entered;
}

bool drawNeighbors(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    using Reach = PrepareForm::Reach;
    const Session& session = context.session();
    const bool computed = session.model().report.neighborsComputed;
    part(context, "Neighbors", computed);
    const bool none = computed && !session.input().spec().neighbors.recompute;
    choice(fields, none ? "The 12 nearest, as the input has no lists" : "From the input##n",
           form.reach, Reach::File, "Its lists; if it has none, the 12 nearest");
    choice(fields, "K nearest", form.reach, Reach::Nearest, "The k nearest points (--neighbors)");
    if (context.state<TypingWait>().takeFocus(TypedField::Prepare)) ImGui::SetKeyboardFocusHere();
    bool entered = valueField(fields, "##count", form.count, form.reach, Reach::Nearest);
    choice(fields, "Within a radius", form.reach, Reach::Radius, "In scene units (--radius)");
    entered = valueField(fields, "##radius", form.radius, form.reach, Reach::Radius) || entered;
    choice(fields, "Within spacings", form.reach, Reach::Spacings,
           "A multiple of the mean distance to the nearest point (--reach)");
    entered =
        valueField(fields, "##spacings", form.spacings, form.reach, Reach::Spacings) || entered;
    toggle(fields, "Symmetric", form.symmetric, "Make neighbor lists symmetric (--symmetric)");
    besideIfRoom(context);
    toggle(fields, "Keep opposing normals", form.keepOpposing,
           "Keep neighbors whose normal opposes that of the point (--keep-opposing)");
    return entered;
}

/// Three fields beside each other. True if Enter was pressed in one.
bool drawCoordinates(const PanelContext& context, const std::string& name,
                     std::span<std::string> texts) {
    bool entered = false;
    const float gap = 0.3F * context.em;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(width);
        const std::string id = "##" + name + std::to_string(i);
        constexpr const char* kHints[] = {"x", "y", "z"};
        entered = textField(id.c_str(), kHints[i], texts[i], kEntered) || entered;
    }
    return entered;
}

bool drawNormals(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    const DerivedPieces& derived = context.session().model().report.derived;
    part(context, "Normals", derived.normals || derived.orientation);
    const bool none =
        derived.normals && context.session().input().spec().normals != NormalSource::Derived;
    choice(fields, none ? "Derived, as the input has none" : "From the input##m", form.normals,
           NormalSource::AsGiven, "Derived from the positions if it has none");
    choice(fields, "Flipped to agree with each other", form.normals, NormalSource::Oriented,
           "Those of the input, outward for closed parts (--orient)");
    choice(fields, "Derived from the positions", form.normals, NormalSource::Derived,
           "Planes through the nearest points, flipped to agree (--derive-normals)");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Facing a scanner at");
    ImGui::SameLine(xOfFields(context));
    const auto before = form.scanner;
    ImGui::BeginGroup();
    const bool entered = drawCoordinates(context, "scanner", form.scanner);
    ImGui::EndGroup();
    fields.name("scanner",
                "Flipped and derived normals face this position, part by part; empty: they face "
                "outward (--scanner)");
    // Normals of the input stay as they are.
    if (form.scanner != before && form.normals == NormalSource::AsGiven)
        form.normals = NormalSource::Oriented;
    return entered;
}

bool drawWalls(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    using From = WallChoice::From;
    const DerivedPieces& derived = context.session().model().report.derived;
    part(context, "Walls", derived.types || derived.rim);
    choice(fields, "From the input##w", form.walls, From::File,
           "The types of its points, if it has any");
    choice(fields, "The box around all points", form.walls, From::Around,
           "Points on its faces are boundary points (--box auto)");
    choice(fields, "This box", form.walls, From::Box,
           "Points on its faces are boundary points (--box)");
    const BoxFields before = form.box;
    const bool entered = drawBoxFields(context, form.box);
    if (form.box != before) form.walls = From::Box;
    toggle(fields, "Find rims without walls", form.rim,
           "Points where the surface ends without a wall are boundary points (--derive-rim); the "
           "rule rim finds them where the file has none");
    return entered;
}

}  // namespace

bool drawPrepareFields(const PanelContext& context, PrepareForm& form, const std::string& prefix) {
    const Fields fields{context, form, prefix};
    bool entered = drawNeighbors(fields);
    entered = drawNormals(fields) || entered;
    entered = drawWalls(fields) || entered;
    ImGui::Spacing();
    heading(context, "Noise and strays");
    toggle(fields, "Keep all points of noisy input", form.keepNoise,
           "Robust rules set aside points that lie above or below others (--keep-noise)");
    toggle(fields, "Keep points far from all others", form.keepStrays,
           "Corrected and robust rules set them aside (--keep-strays)");
    return entered;
}

bool drawBoxFields(const PanelContext& context, BoxFields& fields) {
    bool entered = false;
    for (std::size_t row = 0; row < 2; ++row) {
        fieldName(context, row == 0 ? "from" : "to", 3.0F);
        const auto texts = std::span(fields).subspan(3 * row, 3);
        entered = drawCoordinates(context, row == 0 ? "low" : "high", texts) || entered;
    }
    return entered;
}

}  // namespace se::view
