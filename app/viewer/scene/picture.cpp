#include "picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace se::view {

namespace {

/// Sum of the colors, weighted by alpha, and of alpha.
using Sum = std::array<unsigned, 4>;

void addPixel(const std::uint8_t* pixel, Sum& sum) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += unsigned{pixel[c]} * pixel[3];
    sum[3] += pixel[3];
}

}  // namespace

Picture cutOut(const Picture& onBlack, const Picture& onWhite) {
    assert(onBlack.size == onWhite.size);
    Picture out = onBlack;
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        int through = 0;
        for (std::size_t c = 0; c < 3; ++c)
            through = std::max(through, onWhite.rgba[i + c] - onBlack.rgba[i + c]);
        const int alpha = 255 - through;
        for (std::size_t c = 0; c < 3; ++c) {
            const int color = alpha > 0 ? (onBlack.rgba[i + c] * 255 + alpha / 2) / alpha : 0;
            out.rgba[i + c] = static_cast<std::uint8_t>(std::min(color, 255));
        }
        out.rgba[i + 3] = static_cast<std::uint8_t>(alpha);
    }
    return out;
}

void copyInto(Picture& whole, glm::ivec2 at, const Picture& part) {
    assert(at.x >= 0 && at.y >= 0 && at.x + part.size.x <= whole.size.x &&
           at.y + part.size.y <= whole.size.y);
    const auto row = static_cast<std::size_t>(part.size.x) * 4;
    for (int y = 0; y < part.size.y; ++y) {
        const std::size_t to =
            (static_cast<std::size_t>(at.y + y) * static_cast<std::size_t>(whole.size.x) +
             static_cast<std::size_t>(at.x)) *
            4;
        std::copy_n(&part.rgba[static_cast<std::size_t>(y) * row], row, &whole.rgba[to]);
    }
}

Picture reduced(const Picture& picture, int factor) {
    assert(factor > 0 && picture.size.x % factor == 0 && picture.size.y % factor == 0);
    if (factor == 1) return picture;
    Picture out{picture.size / factor, {}};
    out.rgba.reserve(picture.rgba.size() / static_cast<std::size_t>(factor * factor));
    const auto pixels = static_cast<unsigned>(factor * factor);
    for (int y = 0; y < out.size.y; ++y) {
        for (int x = 0; x < out.size.x; ++x) {
            Sum sum{};
            for (int i = 0; i < factor * factor; ++i) {
                const glm::ivec2 from(x * factor + i % factor, y * factor + i / factor);
                const auto row = static_cast<std::size_t>(from.y);
                const auto column = static_cast<std::size_t>(from.x);
                const auto width = static_cast<std::size_t>(picture.size.x);
                addPixel(&picture.rgba[4 * (row * width + column)], sum);
            }
            const unsigned weight = std::max(sum[3], 1U);
            for (std::size_t c = 0; c < 3; ++c)
                out.rgba.push_back(static_cast<std::uint8_t>((sum[c] + weight / 2) / weight));
            out.rgba.push_back(static_cast<std::uint8_t>((sum[3] + pixels / 2) / pixels));
        }
    }
    return out;
}

}  // namespace se::view
