#include "ui.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>

namespace se::view {

namespace {

constexpr float kEmPixels = 16.0F;

ImVec4 imColor(const Color& c) { return {c.r, c.g, c.b, c.a}; }

void setColors(const Palette& c) {
    ImVec4* to = ImGui::GetStyle().Colors;
    const Color hover = mix(c.panelRaised, c.text, 0.10F);
    const Color press = mix(c.panelRaised, c.text, 0.18F);
    to[ImGuiCol_Text] = imColor(c.text);
    to[ImGuiCol_TextDisabled] = imColor(c.textDim);
    to[ImGuiCol_WindowBg] = imColor(c.panel);
    to[ImGuiCol_ChildBg] = imColor(c.panel.withAlpha(0.0F));
    to[ImGuiCol_PopupBg] = imColor(c.panel);
    to[ImGuiCol_Border] = imColor(c.border);
    to[ImGuiCol_FrameBg] = imColor(c.panelRaised);
    to[ImGuiCol_FrameBgHovered] = imColor(hover);
    to[ImGuiCol_FrameBgActive] = imColor(press);
    to[ImGuiCol_TitleBg] = to[ImGuiCol_TitleBgActive] = imColor(c.panelRaised);
    to[ImGuiCol_MenuBarBg] = imColor(c.panel);
    to[ImGuiCol_ScrollbarBg] = imColor(c.panel.withAlpha(0.0F));
    to[ImGuiCol_ScrollbarGrab] = imColor(c.border);
    to[ImGuiCol_ScrollbarGrabHovered] = to[ImGuiCol_ScrollbarGrabActive] = imColor(c.textDim);
    to[ImGuiCol_CheckMark] = imColor(c.used);
    to[ImGuiCol_SliderGrab] = to[ImGuiCol_SliderGrabActive] = imColor(c.accent);
    to[ImGuiCol_Button] = imColor(c.panelRaised);
    to[ImGuiCol_ButtonHovered] = imColor(hover);
    to[ImGuiCol_ButtonActive] = imColor(press);
    to[ImGuiCol_Header] = imColor(c.accent.withAlpha(0.38F));
    to[ImGuiCol_HeaderHovered] = imColor(c.accent.withAlpha(0.22F));
    to[ImGuiCol_HeaderActive] = imColor(c.accent.withAlpha(0.5F));
    to[ImGuiCol_Separator] = imColor(c.border);
    to[ImGuiCol_Tab] = imColor(c.panel);
    to[ImGuiCol_TabHovered] = imColor(hover);
    to[ImGuiCol_TabActive] = to[ImGuiCol_TabUnfocusedActive] = imColor(c.panelRaised);
    to[ImGuiCol_TabUnfocused] = imColor(c.panel);
    to[ImGuiCol_PlotHistogram] = imColor(c.accent);
    to[ImGuiCol_TableHeaderBg] = imColor(c.panelRaised);
    to[ImGuiCol_TableBorderStrong] = to[ImGuiCol_TableBorderLight] = imColor(c.border);
    to[ImGuiCol_TableRowBgAlt] = imColor(c.text.withAlpha(0.025F));
    to[ImGuiCol_TextSelectedBg] = imColor(c.accent.withAlpha(0.45F));
    to[ImGuiCol_NavHighlight] = imColor(c.pivot);
    to[ImGuiCol_ModalWindowDimBg] = imColor(c.background.withAlpha(0.6F));
}

void setSizes(float em) {
    ImGuiStyle& style = ImGui::GetStyle();
    const float px = std::max(1.0F, std::round(em / 16.0F));
    style.WindowPadding = {0.7F * em, 0.55F * em};
    style.FramePadding = {0.5F * em, 0.28F * em};
    style.ItemSpacing = {0.5F * em, 0.35F * em};
    style.ItemInnerSpacing = {0.4F * em, 0.3F * em};
    style.CellPadding = {0.3F * em, 0.16F * em};
    style.IndentSpacing = em;
    style.ScrollbarSize = 0.7F * em;
    style.GrabMinSize = 0.7F * em;
    style.WindowBorderSize = 0.0F;
    style.PopupBorderSize = px;
    style.FrameRounding = style.GrabRounding = 0.25F * em;
    style.PopupRounding = style.WindowRounding = 0.3F * em;
    style.TabRounding = 0.25F * em;
    style.ScrollbarRounding = 0.35F * em;
    style.TabBorderSize = 0.0F;
}

}  // namespace

Ui::Ui() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    // No layout file: the layout is fixed, and nothing may be left in the working directory.
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Ui::~Ui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void Ui::setLooks(float scale, Theme theme) {
    if (looksSet_ && scale == scale_ && theme == theme_) return;
    if (!looksSet_ || scale != scale_) {
        em_ = std::round(kEmPixels * scale);
        fonts_ = loadFonts(em_);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    theme_ = theme;
    scale_ = scale;
    looksSet_ = true;
    setColors(paletteOf(theme));
    setSizes(em_);
}

void Ui::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void Ui::endFrame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace se::view
