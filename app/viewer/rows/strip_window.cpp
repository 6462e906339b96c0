#include "strip_window.h"

#include <algorithm>
#include <cmath>

namespace se::view {

namespace {

constexpr double kPerNotch = 1.25;

}  // namespace

void StripWindow::put(double from, double length) {
    if (length >= last_) {
        whole_ = true;
        return;
    }
    whole_ = false;
    from_ = std::clamp(from, 0.0, last_ - length);
    to_ = from_ + length;
}

void StripWindow::setLast(std::uint32_t last) {
    last_ = std::max(1.0, static_cast<double>(last));
    if (!whole_) put(from_, to_ - from_);
}

void StripWindow::zoomAt(double share, double notches) {
    const double fixed = pivotAt(share);
    const double length = std::max(kLeast, (to() - from()) * std::pow(kPerNotch, -notches));
    if (length < to() - from() || notches < 0.0) put(fixed - share * length, length);
}

void StripWindow::pan(double shares) {
    if (whole_) return;
    put(from_ + shares * (to_ - from_), to_ - from_);
}

void StripWindow::reveal(std::uint32_t pivot) {
    const double at = pivot;
    if (whole_ || (at >= from_ && at <= to_)) return;
    const double length = to_ - from_;
    put(at < from_ ? at - 0.1 * length : at - 0.9 * length, length);
}

}  // namespace se::view
