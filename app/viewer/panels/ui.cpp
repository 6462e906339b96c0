#include "ui.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "font_paths.h"
#include "panels/widgets/widgets.h"
#include "render/context.h"

namespace se::view {

namespace {

void setColors(const Palette& c) {
    ImVec4* to = ImGui::GetStyle().Colors;
    const Color hover = mix(c.panelRaised, c.text, kHoverShare);
    const Color press = mix(c.panelRaised, c.text, 0.18F);
    to[ImGuiCol_Text] = toVec4(c.text);
    to[ImGuiCol_TextDisabled] = toVec4(c.textDim);
    to[ImGuiCol_WindowBg] = toVec4(c.panel);
    to[ImGuiCol_ChildBg] = toVec4(c.panel.withAlpha(0.0F));
    to[ImGuiCol_PopupBg] = toVec4(c.panel);
    to[ImGuiCol_Border] = toVec4(c.border);
    to[ImGuiCol_FrameBg] = toVec4(c.panelRaised);
    to[ImGuiCol_FrameBgHovered] = toVec4(hover);
    to[ImGuiCol_FrameBgActive] = toVec4(press);
    to[ImGuiCol_TitleBg] = to[ImGuiCol_TitleBgActive] = toVec4(c.panelRaised);
    to[ImGuiCol_MenuBarBg] = toVec4(c.panel);
    to[ImGuiCol_ScrollbarBg] = toVec4(c.panel.withAlpha(0.0F));
    to[ImGuiCol_ScrollbarGrab] = toVec4(c.border);
    to[ImGuiCol_ScrollbarGrabHovered] = to[ImGuiCol_ScrollbarGrabActive] = toVec4(c.textDim);
    to[ImGuiCol_CheckMark] = toVec4(c.used);
    to[ImGuiCol_SliderGrab] = to[ImGuiCol_SliderGrabActive] = toVec4(c.accent);
    to[ImGuiCol_Button] = toVec4(c.panelRaised);
    to[ImGuiCol_ButtonHovered] = toVec4(hover);
    to[ImGuiCol_ButtonActive] = toVec4(press);
    to[ImGuiCol_Header] = toVec4(c.accent.withAlpha(kSelectedShare));
    to[ImGuiCol_HeaderHovered] = toVec4(c.accent.withAlpha(0.22F));
    to[ImGuiCol_HeaderActive] = toVec4(c.accent.withAlpha(0.5F));
    to[ImGuiCol_Separator] = toVec4(c.border);
    to[ImGuiCol_Tab] = toVec4(c.panel);
    to[ImGuiCol_TabHovered] = toVec4(hover);
    to[ImGuiCol_TabActive] = to[ImGuiCol_TabUnfocusedActive] = toVec4(c.panelRaised);
    to[ImGuiCol_TabUnfocused] = toVec4(c.panel);
    to[ImGuiCol_PlotHistogram] = toVec4(c.accent);
    to[ImGuiCol_TableHeaderBg] = toVec4(c.panelRaised);
    to[ImGuiCol_TableBorderStrong] = to[ImGuiCol_TableBorderLight] = toVec4(c.border);
    to[ImGuiCol_TableRowBgAlt] = toVec4(c.text.withAlpha(0.025F));
    to[ImGuiCol_TextSelectedBg] = toVec4(c.accent.withAlpha(0.45F));
    to[ImGuiCol_NavHighlight] = toVec4(c.pivot);
    to[ImGuiCol_ModalWindowDimBg] = toVec4(c.background.withAlpha(0.6F));
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

// ---- fonts ----------------------------------------------------------------------------------

// Latin, Greek, punctuation, sub- and superscripts, arrows, operators, shapes, check marks.
constexpr std::array<ImWchar, 17> kRanges = {0x0020, 0x00FF, 0x0370, 0x03FF, 0x2000, 0x2027,
                                             0x2070, 0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF,
                                             0x25A0, 0x25FF, 0x2700, 0x27FF, 0};

constexpr std::array kOtherFolders = {
    "/usr/share/fonts/opentype/inter/",
    "/usr/share/fonts/truetype/inter/",
    "/usr/share/fonts/inter/",
    "/usr/share/fonts/truetype/dejavu/",
    "/usr/share/fonts/dejavu/",
    "/usr/share/fonts/TTF/",
    "/usr/share/fonts/dejavu-sans-fonts/",
    "/usr/local/share/fonts/",
};

bool exists(const std::string& path) {
    std::error_code error;
    return !path.empty() && std::filesystem::is_regular_file(path, error);
}

/// The configured path, or the same file name in a folder of other systems.
std::string findFont(const std::string& configured) {
    if (exists(configured)) return configured;
    const std::string name = std::filesystem::path(configured).filename().string();
    for (const char* folder : kOtherFolders) {
        if (const std::string path = folder + name; !name.empty() && exists(path)) return path;
    }
    return {};
}

ImFont* addFont(const std::string& path, float pixels, bool merge) {
    ImFontConfig config;
    config.MergeMode = merge;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), pixels, &config, kRanges.data());
}

ImFont* addWithSymbols(const std::string& path, const std::string& symbols, float pixels) {
    ImFont* font = nullptr;
    if (!path.empty()) font = addFont(path, pixels, false);
    if (font == nullptr) {
        ImFontConfig config;
        config.SizePixels = pixels;
        return ImGui::GetIO().Fonts->AddFontDefault(&config);
    }
    if (!symbols.empty() && symbols != path) addFont(symbols, pixels, true);
    return font;
}

/// Puts the fonts at `em` pixels into the atlas of the current ImGui context, replacing all others.
Fonts loadFonts(float em) {
    ImGui::GetIO().Fonts->Clear();
    const std::string symbols = findFont(kFontSymbol);
    const std::string text = findFont(kFontText);
    const std::string strong = findFont(kFontStrong);
    const std::string mono = findFont(kFontMono);
    Fonts fonts;
    const std::string& plain = text.empty() ? symbols : text;
    fonts.text = addWithSymbols(plain, symbols, em);
    fonts.strong = addWithSymbols(strong.empty() ? text : strong, symbols, em);
    fonts.mono = addWithSymbols(mono.empty() ? text : mono, symbols, 0.88F * em);
    fonts.small = addWithSymbols(plain, symbols, 0.84F * em);
    fonts.large = addWithSymbols(plain, symbols, 1.12F * em);
    fonts.caption = addWithSymbols(plain, symbols, 1.5F * 1.12F * em);
    return fonts;
}

template <class T>
void append(std::string& bytes, const T* values, int count) {
    bytes.append(reinterpret_cast<const char*>(values),
                 sizeof(T) * static_cast<std::size_t>(count));
}

/// Size, vertices, indices and commands, as bytes to compare.
std::string contentOf(const ImDrawData& data) {
    std::string bytes;
    append(bytes, &data.DisplaySize, 1);
    append(bytes, &data.FramebufferScale, 1);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        append(bytes, list.VtxBuffer.Data, list.VtxBuffer.Size);
        append(bytes, list.IdxBuffer.Data, list.IdxBuffer.Size);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            append(bytes, &command.ClipRect, 1);
            append(bytes, &command.TextureId, 1);
            append(bytes, &command.VtxOffset, 1);
            append(bytes, &command.IdxOffset, 1);
            append(bytes, &command.ElemCount, 1);
        }
    }
    return bytes;
}

}  // namespace

Ui::Ui() {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    // No layout file: the layout is fixed, and nothing may be left in the working directory.
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    ImGui_ImplOpenGL3_Init(shaderVersion());
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
        // The first texture is made by beginFrame().
        if (looksSet_) {
            ImGui_ImplOpenGL3_DestroyFontsTexture();
            ImGui_ImplOpenGL3_CreateFontsTexture();
        }
    }
    theme_ = theme;
    scale_ = scale;
    looksSet_ = true;
    setColors(paletteOf(theme));
    setSizes(em_);
}

void Ui::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::GetIO().Fonts->ClearTexData();  // It is a texture now.
    ImGui::NewFrame();
}

bool Ui::endFrame() {
    ImGui::Render();
    std::string content = contentOf(*ImGui::GetDrawData());
    const bool changed = content != content_;
    content_ = std::move(content);
    return changed;
}

void Ui::draw(const std::optional<PictureTile>& tile) const {
    ImDrawData* data = ImGui::GetDrawData();
    if (tile) {
        data->DisplayPos = toVec2(glm::vec2(tile->min));
        data->DisplaySize = toVec2(glm::vec2(tile->size));
    }
    ImGui_ImplOpenGL3_RenderDrawData(data);
}

}  // namespace se::view
