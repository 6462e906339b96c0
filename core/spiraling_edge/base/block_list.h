/// A long list as a value that is cheap to copy: it is cut into blocks that copies share until one
/// of them changes. Two lists for a million points thus differ by a few kilobytes, and the
/// differences are found without a look at every point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace se {

template <typename T>
class BlockList {
  public:
    static constexpr std::size_t kBlock = 1024;
    using Block = std::array<T, kBlock>;

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const T& operator[](std::size_t i) const { return (*blocks_[i / kBlock])[i % kBlock]; }

    std::size_t blockCount() const { return blocks_.size(); }
    /// Elements of block `b`; the last block may be shorter than kBlock.
    std::span<const T> block(std::size_t b) const {
        return {blocks_[b]->data(), std::min(kBlock, size_ - b * kBlock)};
    }
    /// True if block `b` is the same memory in both lists, and so has the same contents.
    bool shares(std::size_t b, const BlockList& other) const {
        return b < other.blocks_.size() && size_ == other.size_ && blocks_[b] == other.blocks_[b];
    }

    /// Makes room for `size` elements with unspecified values.
    void resize(std::size_t size) {
        if (size == size_) return;
        size_ = size;
        blocks_.assign((size + kBlock - 1) / kBlock, nullptr);
        for (auto& each : blocks_) each = std::make_shared<const Block>();
    }
    void set(std::size_t i, const T& value) {
        if ((*this)[i] == value) return;
        auto changed = std::make_shared<Block>(*blocks_[i / kBlock]);
        (*changed)[i % kBlock] = value;
        blocks_[i / kBlock] = std::move(changed);
    }
    /// Replaces block `b`, unless its contents are equal already. True if it was replaced.
    bool setBlock(std::size_t b, std::span<const T> values) {
        const std::span<const T> now = block(b);
        if (std::equal(values.begin(), values.end(), now.begin(), now.end())) return false;
        auto changed = std::make_shared<Block>();
        std::copy(values.begin(), values.end(), changed->begin());
        blocks_[b] = std::move(changed);
        return true;
    }

    friend bool operator==(const BlockList& a, const BlockList& b) {
        if (a.size_ != b.size_) return false;
        for (std::size_t i = 0; i < a.blocks_.size(); ++i) {
            const auto x = a.block(i);
            const auto y = b.block(i);
            if (!a.shares(i, b) && !std::equal(x.begin(), x.end(), y.begin())) return false;
        }
        return true;
    }

  private:
    // Blocks never change, so threads may share them.
    std::vector<std::shared_ptr<const Block>> blocks_;
    std::size_t size_ = 0;
};

}  // namespace se
