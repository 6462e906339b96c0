#include "input_hash.h"

#include <array>
#include <cstdio>
#include <vector>

#include "spiraling_edge/base/float_bits.h"

namespace se::view {

namespace {

void addNumber(InputHash& hash, double number) {
    const auto bits = bitsAs<std::uint64_t>(number);
    std::array<char, 8> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
    }
    hash.add({bytes.data(), bytes.size()});
}

void addAll(InputHash& hash, const std::vector<Vec3>& vectors) {
    for (const Vec3& v : vectors) {
        for (int i = 0; i < 3; ++i) addNumber(hash, v[i]);
    }
}

}  // namespace

void InputHash::add(std::string_view bytes) {
    constexpr std::uint64_t kPrime = 0x100000001b3U;
    for (const char byte : bytes) {
        state_ = (state_ ^ static_cast<unsigned char>(byte)) * kPrime;
    }
}

std::string InputHash::text() const {
    char text[32];
    std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(state_));
    return text;
}

std::string hashOfPoints(const PointFile& points) {
    InputHash hash;
    addAll(hash, points.position);
    addAll(hash, points.normal);
    return hash.text();
}

}  // namespace se::view
