// The triangles that the other mesh lacks are computed once for the whole run. Since a run only
// appends triangles, those present at any time are a prefix, found by binary search. Only the mesh
// that is edited after the last pivot has to be compared again.
#include "difference.h"

#include <algorithm>

namespace se::view {

DifferenceShade::DifferenceShade(std::span<const Triangle> inOrder,
                                 std::shared_ptr<const TriangleSet> other)
    : other_(std::move(other)), parts_(partsOf(inOrder, *other_)) {}

std::array<DifferenceShade::Part, 2> DifferenceShade::partsOf(std::span<const Triangle> triangles,
                                                              const TriangleSet& other) {
    std::array<std::vector<Triangle>, 2> found;
    std::array<Part, 2> parts;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Match match = other.find(triangles[i]);
        if (match == Match::Same) continue;
        const std::size_t kind = match == Match::Missing ? 0 : 1;
        found[kind].push_back(triangles[i]);
        parts[kind].places.push_back(i);
    }
    for (std::size_t kind = 0; kind < 2; ++kind)
        parts[kind].triangles =
            std::make_shared<const std::vector<Triangle>>(std::move(found[kind]));
    return parts;
}

std::array<TintedTriangles, 2> DifferenceShade::at(
    std::size_t finished, const std::shared_ptr<const std::vector<Triangle>>& repaired,
    const Color& only, const Color& turned) const {
    if (!other_) return {};
    if (repaired && repaired_ != repaired) {
        repairedParts_ = partsOf(*repaired, *other_);
        repaired_ = repaired;
    }
    const std::array<Part, 2>& parts = repaired ? repairedParts_ : parts_;
    std::array<TintedTriangles, 2> tinted;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const auto& places = parts[kind].places;
        const auto end =
            repaired ? places.end() : std::lower_bound(places.begin(), places.end(), finished);
        tinted[kind] = {parts[kind].triangles, static_cast<std::size_t>(end - places.begin()),
                        kind == 0 ? only : turned};
    }
    return tinted;
}

}  // namespace se::view
