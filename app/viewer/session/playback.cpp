#include "playback.h"

#include <algorithm>
#include <cmath>

#include "run/strings.h"

namespace se::view {

namespace {

constexpr std::array kNotches = {0.5, 1.0, 2.0, 4.0, 8.0, 15.0, 30.0, 60.0};
constexpr int kMaxAtOnce = 8;

}  // namespace

std::optional<PlayUnit> unitFromName(std::string_view name) {
    return idNamed<PlayUnit>(teach::kPlayUnits, name);
}

PlayUnit following(PlayUnit unit) {
    return static_cast<PlayUnit>((static_cast<int>(unit) + 1) % 3);
}

void PlayLoop::setFrom(const Address& address) {
    from = address;
    if (to && to->pivot < address.pivot) to.reset();
}

void PlayLoop::setTo(const Address& address) {
    to = address;
    if (from && from->pivot > address.pivot) from.reset();
}

void Playback::setRate(double rate) {
    speed_.rate = std::clamp(rate, kSlowest, kFastest);
    speed_.unlimited = false;
}

void Playback::faster() {
    const auto next = std::upper_bound(kNotches.begin(), kNotches.end(), speed_.rate);
    if (next == kNotches.end()) {
        speed_.unlimited = true;
    } else {
        setRate(*next);
    }
}

void Playback::slower() {
    if (speed_.unlimited) {
        setRate(kFastest);
        return;
    }
    const auto at = std::lower_bound(kNotches.begin(), kNotches.end(), speed_.rate);
    setRate(at == kNotches.begin() ? kSlowest : *std::prev(at));
}

int Playback::due(double seconds) {
    if (!playing_) return 0;
    if (speed_.unlimited) return 1;
    owed_ += seconds * speed_.rate;
    const int steps = std::min(static_cast<int>(std::floor(owed_)), kMaxAtOnce);
    owed_ = std::min(owed_ - steps, 1.0);
    return steps;
}

}  // namespace se::view
