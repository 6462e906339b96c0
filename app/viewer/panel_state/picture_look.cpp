#include "picture_look.h"

#include <glm/common.hpp>

namespace se::view {

namespace {

/// Parts begin at multiples of this: the patterns of occlusion.frag repeat every eight pixels.
constexpr int kPartGrid = 8;

int gridBelow(int pixel) { return pixel - pixel % kPartGrid; }

}  // namespace

std::vector<PictureTile> tilesOf(glm::ivec2 size, int most, int margin, int multiple) {
    std::vector<PictureTile> tiles;
    const int side = (most - 2 * margin - kPartGrid) / multiple * multiple;
    if (side < multiple) return tiles;
    for (int y = 0; y < size.y; y += side) {
        for (int x = 0; x < size.x; x += side) {
            const glm::ivec2 corner(x, y);
            tiles.push_back({corner, glm::min(glm::ivec2(side), size - corner), margin});
        }
    }
    return tiles;
}

PixelRect partOfView(const Rect& view, const std::optional<PictureTile>& tile) {
    const glm::ivec2 size(view.size);
    if (!tile) return {glm::ivec2(0), size};
    const glm::ivec2 from = tile->min - glm::ivec2(view.min);
    const glm::ivec2 to = from + tile->size;
    const PixelRect upright{{from.x, size.y - to.y}, {to.x, size.y - from.y}};
    if (!upright.meets({glm::ivec2(0), size})) return {};
    PixelRect part = upright.grown(tile->margin, size);
    part.min = {gridBelow(part.min.x), gridBelow(part.min.y)};
    return part;
}

}  // namespace se::view
