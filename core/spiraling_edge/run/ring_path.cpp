#include "spiraling_edge/run/ring_path.h"

#include <algorithm>

namespace se {

RingPath ringPath(const EdgeRings& rings, Index ring) {
    RingPath path;
    for (const Index entry : rings.entriesOf(ring)) {
        path.points.push_back(rings.point(entry));
        path.open.push_back(rings.open(entry));
    }
    path.active = ring == rings.active();
    const Index depth = rings.depthFromTop(ring);
    path.depth = depth == kNone ? 0 : depth;
    path.id = ring;
    path.number = rings.number(ring);
    return path;
}

std::string ringName(Index number) {
    std::string name(1, static_cast<char>('a' + number % 26));
    return number < 26 ? name : ringName(number / 26 - 1) + name;
}

std::vector<RingPath> ringPaths(const EdgeRings& rings) {
    std::vector<RingPath> paths;
    if (rings.active() != kNone) paths.push_back(ringPath(rings, rings.active()));
    for (std::size_t i = rings.stack().size(); i > 0; --i) {
        paths.push_back(ringPath(rings, rings.stack()[i - 1]));
    }
    return paths;
}

std::size_t stackedCount(std::span<const RingPath> rings) {
    const auto waiting = [](const RingPath& ring) { return !ring.active; };
    return static_cast<std::size_t>(std::count_if(rings.begin(), rings.end(), waiting));
}

}  // namespace se
