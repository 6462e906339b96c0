#include "spiraling_edge/run/status_list.h"

namespace se {

namespace {

std::size_t& countOf(StatusCounts& counts, PointStatus status) {
    return status == kUnused ? counts.unused : status > 0 ? counts.used : counts.done;
}

}  // namespace

void StatusList::set(Index point, PointStatus status) {
    --countOf(counts_, list_[point]);
    ++countOf(counts_, status);
    list_.set(point, status);
}

void StatusList::assign(std::span<const PointStatus> all) {
    if (list_.size() != all.size()) {
        list_.resize(all.size());
        counts_ = {all.size(), 0, 0};
    }
    constexpr std::size_t kBlock = BlockList<PointStatus>::kBlock;
    for (std::size_t b = 0; b < list_.blockCount(); ++b) {
        const auto fresh = all.subspan(b * kBlock, std::min(kBlock, all.size() - b * kBlock));
        const auto now = list_.block(b);
        if (std::equal(fresh.begin(), fresh.end(), now.begin())) continue;
        for (const PointStatus status : now) --countOf(counts_, status);
        for (const PointStatus status : fresh) ++countOf(counts_, status);
        list_.setBlock(b, fresh);
    }
}

}  // namespace se
