/// What panels remember between frames, by its type.
#pragma once

#include <memory>
#include <typeindex>
#include <unordered_map>

namespace se::view {

/// One value of each type that was asked for; it stays where it is.
class PanelStates {
  public:
    PanelStates() = default;
    PanelStates(const PanelStates&) = delete;
    PanelStates& operator=(const PanelStates&) = delete;

    template <class State>
    State& of() {
        std::shared_ptr<void>& place = states_[std::type_index(typeid(State))];
        if (!place) place = std::make_shared<State>();
        return *static_cast<State*>(place.get());
    }

  private:
    std::unordered_map<std::type_index, std::shared_ptr<void>> states_;
};

}  // namespace se::view
