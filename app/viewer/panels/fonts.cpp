#include "fonts.h"

#include <imgui.h>

#include <array>
#include <filesystem>

#include "font_paths.h"

namespace se::view {

namespace {

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

}  // namespace

Fonts loadFonts(float em) {
    ImGui::GetIO().Fonts->Clear();
    const std::string symbols = findFont(kFontSymbol);
    const std::string text = findFont(kFontText);
    const std::string strong = findFont(kFontStrong);
    const std::string mono = findFont(kFontMono);
    Fonts fonts;
    fonts.text = addWithSymbols(text.empty() ? symbols : text, symbols, em);
    fonts.strong = addWithSymbols(strong.empty() ? text : strong, symbols, em);
    fonts.mono = addWithSymbols(mono.empty() ? text : mono, symbols, 0.88F * em);
    fonts.small = addWithSymbols(text.empty() ? symbols : text, symbols, 0.84F * em);
    fonts.large = addWithSymbols(text.empty() ? symbols : text, symbols, 1.12F * em);
    fonts.caption = addWithSymbols(text.empty() ? symbols : text, symbols, 1.5F * 1.12F * em);
    fonts.symbols = !symbols.empty();
    return fonts;
}

}  // namespace se::view
