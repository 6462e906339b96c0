#include "screen_space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include "scene/screen_rect.h"
#include "spiraling_edge/base/lists.h"

namespace se::view {

// A triangle covers the pixels whose centers lie within it; its depth is linear on the screen, so
// that no division is needed in the loop.

namespace {

constexpr float kFarthestDepth = 2.0F;
/// Depth by which a triangle has to be nearer, so that it does not hide what lies on it.
constexpr float kSlack = 2e-5F;

}  // namespace

ScreenSpace::ScreenSpace(const CameraMatrices& camera, glm::vec2 size)
    : camera_(camera), toClip_(camera.viewProjection()), size_(size) {}

glm::vec3 ScreenSpace::toEye(const glm::vec3& position) const {
    if (camera_.orthographic) return glm::vec3(glm::row(camera_.view, 2));
    return glm::normalize(camera_.eye - position);
}

glm::vec3 ScreenSpace::right() const { return glm::vec3(glm::row(camera_.view, 0)); }

glm::vec3 ScreenSpace::up() const { return glm::vec3(glm::row(camera_.view, 1)); }

std::optional<glm::vec3> ScreenSpace::at(const glm::vec3& position, float bias) const {
    const glm::vec3 moved = bias == 0.0F ? position : position + bias * toEye(position);
    const glm::vec4 clip = toClip_ * glm::vec4(moved, 1.0F);
    if (clip.w < 1e-4F) return std::nullopt;
    const glm::vec3 ndc = glm::vec3(clip) / clip.w;
    return glm::vec3((0.5F * ndc.x + 0.5F) * size_.x, (0.5F - 0.5F * ndc.y) * size_.y, ndc.z);
}

DepthPicture::DepthPicture(glm::vec2 size, float most)
    : scale_(std::min(1.0F, most / std::max(size.x, size.y))),
      size_(glm::ivec2(glm::ceil(size * scale_))) {
    const auto count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    depth_.assign(count, kFarthestDepth);
    number_.assign(count, kNobody);
}

void DepthPicture::add(const std::array<glm::vec3, 3>& corners, std::uint32_t number) {
    std::array<glm::vec2, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = scale_ * glm::vec2(corners[i]) - glm::vec2(0.5F);
    const float area = crossOf(p[1] - p[0], p[2] - p[0]);
    if (!(std::abs(area) > 1e-6F)) return;
    const glm::vec2 low = glm::min(p[0], glm::min(p[1], p[2]));
    const glm::vec2 high = glm::max(p[0], glm::max(p[1], p[2]));
    const glm::vec2 most = glm::vec2(size_ - 1);
    const glm::ivec2 from(glm::ceil(glm::clamp(low, glm::vec2(0.0F), most)));
    const glm::ivec2 to(glm::floor(glm::clamp(high, glm::vec2(-1.0F), most)));
    for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
            const glm::vec2 at(x, y);
            const float a = crossOf(p[1] - at, p[2] - at) / area;
            const float b = crossOf(p[2] - at, p[0] - at) / area;
            const float c = 1.0F - a - b;
            if (a < 0.0F || b < 0.0F || c < 0.0F) continue;
            const float depth = a * corners[0].z + b * corners[1].z + c * corners[2].z;
            const auto place = static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
                               static_cast<std::size_t>(x);
            // Of two in a plane the later one is seen, as on the graphics card.
            if (depth > depth_[place] + kSlack) continue;
            depth_[place] = std::min(depth, depth_[place]);
            number_[place] = number;
        }
    }
}

bool DepthPicture::hides(const glm::vec3& place) const {
    const glm::ivec2 at(glm::floor(scale_ * glm::vec2(place)));
    if (at.x < 0 || at.y < 0 || at.x >= size_.x || at.y >= size_.y) return false;
    const auto index = static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(at.x);
    return depth_[index] < place.z - kSlack;
}

std::vector<std::uint32_t> DepthPicture::visible() const {
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < number_.size(); ++i) {
        const bool fresh = i == 0 || number_[i] != number_[i - 1];
        if (fresh && number_[i] != kNobody) seen.push_back(number_[i]);
    }
    sortUnique(seen);
    return seen;
}

float lightOn(const glm::vec3& normal, const glm::vec3& toEye, const ScreenSpace& screen) {
    const glm::vec3 key =
        glm::normalize(0.75F * toEye + 0.75F * screen.up() - 0.65F * screen.right());
    const float lit = std::max((glm::dot(normal, key) + 0.15F) / 1.15F, 0.0F);
    const float sky = 0.5F + 0.5F * glm::dot(normal, screen.up());
    const float gloss =
        std::pow(std::max(glm::dot(normal, glm::normalize(key + toEye)), 0.0F), 30.0F);
    return 0.30F + 0.14F * sky + 0.12F * std::max(glm::dot(normal, toEye), 0.0F) + 0.45F * lit +
           0.07F * gloss;
}

}  // namespace se::view
