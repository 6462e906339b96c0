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
        const std::size_t length = utf8Length(text);
        if (length == 0) return line;
        if (text.front() == '\n') ++line;
        text.remove_prefix(length);
    }
    return 0;
}

}  // namespace se::teach
