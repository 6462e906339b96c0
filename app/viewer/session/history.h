/// History of positions that were left by jumps, as in a browser. Plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace se::view {

class History {
  public:
    /// Records a jump from `place`. The forward history is cleared.
    void leave(std::string place);
    /// Goes back from `here`; empty if there is no position before it.
    std::optional<std::string> back(std::string here);
    std::optional<std::string> forward(std::string here);
    bool canGoBack() const { return !before_.empty(); }
    bool canGoForward() const { return !after_.empty(); }

  private:
    static constexpr std::size_t kMax = 200;
    std::vector<std::string> before_;  // the last element is the nearest
    std::vector<std::string> after_;
};

}  // namespace se::view
