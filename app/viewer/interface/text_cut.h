/// Cutting texts to a width.
#pragma once

#include <string>

namespace se::view {

/// A UTF-8 text less its last sign, however many bytes that has.
inline std::string withoutLastSign(std::string text) {
    const auto continues = [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
    };
    while (!text.empty() && continues(text.back())) text.pop_back();
    if (!text.empty()) text.pop_back();
    return text;
}

}  // namespace se::view
