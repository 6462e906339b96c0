#include "file_bytes.h"

#include <array>
#include <cstdio>

#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/base/outside_text.h"

namespace se::teach {

void ByteHash::add(std::string_view bytes) {
    constexpr std::uint64_t kPrime = 0x100000001b3U;
    for (const char byte : bytes) state_ = (state_ ^ static_cast<unsigned char>(byte)) * kPrime;
}

void ByteHash::add(double number) {
    const auto bits = bitsAs<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8) {
        const char byte = static_cast<char>(static_cast<unsigned char>(bits >> shift));
        add(std::string_view(&byte, 1));
    }
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
        const std::size_t length = utf8Length(text);
        if (length == 0) return line;
        if (text.front() == '\n') ++line;
        text.remove_prefix(length);
    }
    return 0;
}

}  // namespace se::teach
