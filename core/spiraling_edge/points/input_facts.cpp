#include "spiraling_edge/points/input_facts.h"

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"

namespace se {

std::array<std::size_t, kAsides> InputFacts::asideAlways() const {
    std::array<std::size_t, kAsides> some = aside;
    for (const Aside each : {Aside::Stray, Aside::Noise}) some[static_cast<std::size_t>(each)] = 0;
    return some;
}

std::array<std::size_t, kAsides> InputFacts::asideByRobust() const {
    std::array<std::size_t, kAsides> some{};
    for (const Aside each : {Aside::Stray, Aside::Noise})
        some[static_cast<std::size_t>(each)] = count(each);
    return some;
}

std::string spacingText(const InputFacts& facts) {
    if (facts.nearestMost == 0.0) return {};
    if (facts.across > 0.0)
        return shortNumber(facts.along) + " along lines, " + shortNumber(facts.across) + " across";
    return shortNumber(facts.nearestMedian) + " between points";
}

std::string piecesText(const InputFacts& facts) {
    std::string text = facts.pieces > 0 ? counted(facts.pieces, "piece") : "";
    if (facts.openings > 0) text += (text.empty() ? "" : ", ") + counted(facts.openings, "opening");
    return text;
}

std::string sizeText(const InputFacts& facts) {
    if (facts.nearestMost == 0.0) return {};
    const Vec3 extent = facts.extent();
    return spacingText(facts) + ", " + shortNumber(extent.x) + " x " + shortNumber(extent.y) +
           " x " + shortNumber(extent.z);
}

}  // namespace se
