#include "file_bytes.h"

#include <array>
#include <cstdio>

#include "spiraling_edge/base/float_bits.h"

namespace se::teach {
namespace {

/// Number of bytes of the UTF-8 character at the start of `text`; 0 if it is none.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) return 0;
    }
    // Longer than needed, a surrogate, or beyond the last character.
    const unsigned second = byte(1);
    const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
                       (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
    return wrong ? 0 : length;
}

}  // namespace

void ByteHash::add(std::string_view bytes) {
    constexpr std::uint64_t kPrime = 0x100000001b3U;
    for (const char byte : bytes) state_ = (state_ ^ static_cast<unsigned char>(byte)) * kPrime;
}

void ByteHash::add(double number) {
    const auto bits = bitsAs<std::uint64_t>(number);
    std::array<char, 8> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
    add(std::string_view(bytes.data(), bytes.size()));
}

std::string ByteHash::text() const {
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(state_));
    return std::string("fnv1a64:") + digits.data();
}

std::string hashOfText(std::string_view text) {
    ByteHash hash;
    hash.add(text);
    return hash.text();
}

std::size_t lineOfBadByte(std::string_view text) {
    std::size_t line = 1;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        if (length == 0) return line;
        if (text.front() == '\n') ++line;
        text.remove_prefix(length);
    }
    return 0;
}

}  // namespace se::teach
