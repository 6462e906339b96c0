#include "export_form.h"

#include "spiraling_edge/base/files.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

/// The row of a name's extension; null if it has none of them.
const ExportFormat* formatOfName(const std::string& name) {
    return lowerExtension(name).empty() ? nullptr : exportFormatOf(name);
}

}  // namespace

void ExportForm::open() {
    ask = ExportAsk::None;
    complaint.clear();
}

void ExportForm::followName(const std::string& name) {
    if (const ExportFormat* found = formatOfName(name))
        format = static_cast<std::size_t>(found - exportFormats().data());
}

void ExportForm::choose(std::size_t place, std::string& name) {
    format = place;
    if (formatOfName(name) != nullptr)
        name = fs::path(name).replace_extension(exportFormats()[format].extension).string();
}

std::string ExportForm::withFormat(const std::string& typed) const {
    if (typed.empty() || formatOfName(typed) != nullptr) return typed;
    return typed + std::string(exportFormats()[format].extension);
}

Result<ExportOrder> ExportForm::order(const std::string& address) const {
    ExportOrder order;
    order.path = path;
    if (!pictureSize(size))
        return Error{size + ": expected a size such as 1280x800, from 320x240 on"};
    if (frames == ExportFrames::Pivot) {
        Result<FrameRange> range = rangeAround(address);
        if (!range) return Error{"There is no pivot at the start of the run."};
        order.range = range.value();
    }
    if (frames == ExportFrames::Range) {
        if (from.empty() || to.empty()) return Error{"Enter both positions of the range."};
        order.range = FrameRange{from, to, unit};
    }
    if (const Status possible = checkExport(order, false); !possible) return possible.error();
    return order;
}

}  // namespace se::view
