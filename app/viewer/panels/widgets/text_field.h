/// Text fields without a limit of length.
#pragma once

#include <imgui.h>

#include <string>

namespace se::view {

/// For a field that takes effect on Enter. A click selects its text, so that typing replaces it.
inline constexpr ImGuiInputTextFlags kEntered =
    ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;

/// One line, with a hint while it is empty. True if the text changed, or with
/// ImGuiInputTextFlags_EnterReturnsTrue on Enter.
bool textField(const char* label, const char* hint, std::string& text,
               ImGuiInputTextFlags flags = 0);
/// Many lines. True if the text changed.
bool textArea(const char* label, std::string& text, const ImVec2& size);

}  // namespace se::view
