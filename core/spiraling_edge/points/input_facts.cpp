#include "spiraling_edge/points/input_facts.h"

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"

namespace se {

std::string spacingText(const InputFacts& facts) {
    if (facts.nearestMost == 0.0) return {};
    if (facts.across > 0.0)
        return shortNumber(facts.along) + " along lines, " + shortNumber(facts.across) + " across";
    return shortNumber(facts.nearestMedian) + " between points";
}

std::string sizeText(const InputFacts& facts) {
    if (facts.nearestMost == 0.0) return {};
    const Vec3 extent = facts.extent();
    return spacingText(facts) + ", " + shortNumber(extent.x) + " x " + shortNumber(extent.y) +
           " x " + shortNumber(extent.z);
}

}  // namespace se
