/// Points that take no part in the run: set aside when it was prepared, dropped by a fix, or left
/// out by the user.
#include "layer.h"

namespace se::view {

namespace {

constexpr float kAsideSize = 0.5F;
/// Number of points beyond which the marks are small and faint: they must not cover the run.
constexpr std::size_t kLargeAside = 300;
constexpr float kSmallAside = 0.22F;
constexpr float kFaint = 0.55F;
/// Marks of points that are no points of the run: of more, evenly chosen ones.
constexpr std::size_t kMaxOutside = 20'000;

}  // namespace

void addAside(const LayerInput& in, DrawList& out) {
    const bool many = countOf(in.model.aside) > kLargeAside;
    const PointStyle style{in.palette.unused.withAlpha(many ? kFaint : 1.0F),
                           many ? kSmallAside : kAsideSize, Shape::Plus};
    out.cloudStyles.styles[CloudStyles::kAside] = style;
    std::size_t outside = 0;
    for (const AsidePoints& each : in.model.aside) outside += each.position.size();
    const std::size_t stride = outside / kMaxOutside + 1;
    for (const AsidePoints& each : in.model.aside) {
        for (std::size_t i = 0; i < each.position.size(); i += stride)
            out.sprites.push_back({in.model.toView(each.position[i]), style});
    }
}

}  // namespace se::view
