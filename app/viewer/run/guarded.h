/// Work of a thread that no exception leaves: one that did would end the program.
#pragma once

#include <functional>

#include "spiraling_edge/result.h"

namespace se::view {

/// Calls `work`. If it throws, an error with a sentence for the user: of too little memory, or with
/// the text of the exception.
Status guarded(const std::function<void()>& work);

}  // namespace se::view
