#include "export_form.h"

#include <utility>

#include "spiraling_edge/base/text_scan.h"

namespace se::view {

void ExportForm::open() { complaint.clear(); }

bool ExportForm::hasCaptions() const {
    return frames != ExportFrames::Picture || chosen().captioned ||
           chosen().content != FrameContent::Pixels;
}

bool ExportForm::hasSpeed() const { return chosen().animated(); }

/// Adds the range or the steps to an order.
Status ExportForm::addFrames(ExportOrder& order, const std::string& address,
                             const std::shared_ptr<const LessonFile>& lesson) const {
    if (frames == ExportFrames::Pivot) {
        Result<FrameRange> range = rangeAround(address);
        if (!range) return Error{"There is no pivot at the start of the run."};
        order.range = range.value();
    }
    if (frames == ExportFrames::Range) {
        if (from.empty() || to.empty()) return Error{"Enter both positions of the range."};
        order.range = FrameRange{from, to, unit};
    }
    if (frames != ExportFrames::Lesson) return success();
    if (lesson == nullptr) return Error{"No lesson is open."};
    order.lesson = lesson;
    if (steps.empty()) return success();
    Result<std::vector<std::size_t>> chosen = stepsFromText(steps, lesson->lesson.steps.size());
    if (!chosen) return chosen.error();
    order.steps = std::move(chosen.value());
    return success();
}

Result<ExportOrder> ExportForm::order(const std::string& address,
                                      const std::shared_ptr<const LessonFile>& lesson) const {
    ExportOrder order;
    order.path = path;
    order.captions = captions || !hasCaptions();
    if (!pictureSize(size))
        return Error{size + ": expected a size such as 1280x800, from 320x240 on"};
    const std::optional<double> speed = numberIn<double>(perSecond);
    if (hasSpeed() && (!speed || *speed < kLeastPerSecond || *speed > kMostPerSecond))
        return Error{perSecond + ": expected frames per second, from 0.1 to 60"};
    order.perSecond = speed.value_or(order.perSecond);
    if (const Status added = addFrames(order, address, lesson); !added) return added.error();
    if (const Status possible = checkExport(order, false); !possible) return possible.error();
    return order;
}

}  // namespace se::view
