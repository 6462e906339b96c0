#include "screen_rect.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace se::view {

namespace {

/// Keeps the part to the left of the line through a and b.
std::vector<glm::vec2> leftOf(const std::vector<glm::vec2>& polygon, const glm::vec2& a,
                              const glm::vec2& b) {
    std::vector<glm::vec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::vec2& here = polygon[i];
        const glm::vec2& next = polygon[(i + 1) % polygon.size()];
        const float sideHere = crossOf(b - a, here - a);
        const float sideNext = crossOf(b - a, next - a);
        if (sideHere >= 0.0F) kept.push_back(here);
        if ((sideHere > 0.0F && sideNext < 0.0F) || (sideHere < 0.0F && sideNext > 0.0F)) {
            kept.push_back(here + sideHere / (sideHere - sideNext) * (next - here));
        }
    }
    return kept;
}

}  // namespace

std::vector<glm::vec2> clipConvex(std::span<const glm::vec2> subject,
                                  std::span<const glm::vec2> window) {
    std::vector<glm::vec2> rest(subject.begin(), subject.end());
    for (std::size_t i = 0; i < window.size() && !rest.empty(); ++i) {
        rest = leftOf(rest, window[i], window[(i + 1) % window.size()]);
    }
    // A common corner or side is no area.
    if (rest.size() < 3 || !(areaOf(rest) > 0.0F)) rest.clear();
    return rest;
}

float areaOf(std::span<const glm::vec2> polygon) {
    float twice = 0.0F;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        // Relative to the first corner, so that no digits are lost far from the origin.
        twice += crossOf(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    }
    return 0.5F * twice;
}

void Bounds::add(const glm::vec3& place) {
    low = glm::min(low, place);
    high = glm::max(high, place);
}

void Bounds::add(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

bool PixelRect::meets(const PixelRect& other) const {
    return !empty() && !other.empty() && min.x < other.max.x && other.min.x < max.x &&
           min.y < other.max.y && other.min.y < max.y;
}

PixelRect PixelRect::grown(int by, glm::ivec2 size) const {
    if (empty()) return *this;
    return {glm::max(min - by, glm::ivec2(0)), glm::min(max + by, size)};
}

PixelRect PixelRect::with(const PixelRect& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {glm::min(min, other.min), glm::max(max, other.max)};
}

PixelRect pixelsOf(const CameraMatrices& camera, const Bounds& bounds, glm::ivec2 size) {
    if (bounds.empty()) return {};
    const glm::mat4 toClip = camera.viewProjection();
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(-low);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::vec4 clip =
            toClip * glm::vec4((corner & 1U) != 0 ? bounds.high.x : bounds.low.x,
                               (corner & 2U) != 0 ? bounds.high.y : bounds.low.y,
                               (corner & 4U) != 0 ? bounds.high.z : bounds.low.z, 1.0F);
        if (clip.w <= 1e-4F) return {glm::ivec2(0), size};
        const glm::vec2 at = (glm::vec2(clip) / clip.w * 0.5F + 0.5F) * glm::vec2(size);
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const glm::vec2 all(size);
    const glm::vec2 from = glm::clamp(glm::floor(low) - 1.0F, glm::vec2(0.0F), all);
    const glm::vec2 to = glm::clamp(glm::ceil(high) + 1.0F, glm::vec2(0.0F), all);
    const PixelRect rect{glm::ivec2(from), glm::ivec2(to)};
    return rect.empty() ? PixelRect{} : rect;
}

CameraMatrices croppedTo(const PixelRect& part, const CameraMatrices& camera, glm::ivec2 size) {
    if (part == PixelRect{glm::ivec2(0), size}) return camera;
    const glm::vec2 whole(size);
    const glm::vec2 scale = whole / glm::vec2(part.max - part.min);
    const glm::vec2 shift = scale - 2.0F * glm::vec2(part.min) / whole * scale - 1.0F;
    glm::mat4 crop(1.0F);
    crop[0][0] = scale.x;
    crop[1][1] = scale.y;
    crop[3][0] = shift.x;
    crop[3][1] = shift.y;
    CameraMatrices cropped = camera;
    cropped.projection = crop * camera.projection;
    return cropped;
}

void BlockBounds::add(std::size_t item, const glm::vec3& place) {
    const std::size_t block = item / kBlock;
    if (block >= blocks_.size()) blocks_.resize(block + 1);
    blocks_[block].add(place);
}

Bounds BlockBounds::of(Range items) const {
    Bounds all;
    if (items.first >= items.second) return all;
    const std::size_t end = std::min((items.second - 1) / kBlock + 1, blocks_.size());
    for (std::size_t b = items.first / kBlock; b < end; ++b) all.add(blocks_[b]);
    return all;
}

std::vector<BlockBounds::Range> BlockBounds::within(const CameraMatrices& camera, glm::ivec2 size,
                                                    const PixelRect& rect,
                                                    std::size_t count) const {
    std::vector<Range> ranges;
    const std::size_t blocks = std::min(blocks_.size(), (count + kBlock - 1) / kBlock);
    for (std::size_t b = 0; b < blocks; ++b) {
        if (!pixelsOf(camera, blocks_[b], size).meets(rect)) continue;
        const Range range{b * kBlock, std::min(count, (b + 1) * kBlock)};
        if (!ranges.empty() && ranges.back().second == range.first) {
            ranges.back().second = range.second;
        } else {
            ranges.push_back(range);
        }
    }
    return ranges;
}

}  // namespace se::view
