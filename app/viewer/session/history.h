/// The places one jumped away from, as in a browser. Plain values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace se::view {

class History {
  public:
    /// A jump is about to leave `place`. What lay ahead is forgotten.
    void leave(std::string place);
    /// Goes back from `here`; nothing if there is no place before it.
    std::optional<std::string> back(std::string here);
    std::optional<std::string> forward(std::string here);
    bool canGoBack() const { return !before_.empty(); }
    bool canGoForward() const { return !after_.empty(); }

  private:
    static constexpr std::size_t kMost = 200;
    std::vector<std::string> before_;  // the last one is the nearest
    std::vector<std::string> after_;
};

}  // namespace se::view
