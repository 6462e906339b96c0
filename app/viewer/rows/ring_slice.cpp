#include "ring_slice.h"

#include <algorithm>

namespace se::view {

std::optional<std::size_t> workPlace(const DecisionState& picture, const RingPath& ring) {
    const std::size_t size = ring.points.size();
    std::optional<std::size_t> pivot;
    std::optional<std::size_t> next;
    std::optional<std::size_t> end;
    for (std::size_t i = 0; i < size; ++i) {
        const Index point = ring.points[i];
        if (point == picture.pivot && picture.pivot != kNone) {
            const bool between = ring.points[(i + size - 1) % size] == picture.first &&
                                 ring.points[(i + 1) % size] == picture.last;
            if (between || !pivot) pivot = i;
            if (between) break;
        }
        if (point == picture.nextPivot && picture.nextPivot != kNone && !next) next = i;
        if (point == picture.end && picture.end != kNone && !end) end = i;
    }
    return pivot ? pivot : next ? next : end;
}

RingSlice sliceAbout(std::size_t size, std::size_t middle, long shift, std::size_t fits) {
    if (size == 0) return {};
    const std::size_t count = std::min(size, std::max<std::size_t>(1, fits));
    const auto n = static_cast<long>(size);
    const long first = static_cast<long>(middle) + shift - static_cast<long>(count / 2);
    return {static_cast<std::size_t>(((first % n) + n) % n), count, size};
}

const RingPath* ringToShow(const DecisionState& picture, Index id) {
    const RingPath* active = nullptr;
    for (const RingPath& ring : picture.rings) {
        if (id != kNone && ring.id == id) return &ring;
        if (ring.active) active = &ring;
    }
    return active;
}

}  // namespace se::view
