/// Work of a thread that no exception leaves: one that did would end the program.
#pragma once

#include <exception>
#include <utility>

#include "spiraling_edge/base/result.h"

namespace se::view {

/// A sentence for the user: too little memory, or the text of the exception.
Error errorOf(const std::exception_ptr& exception);

/// Calls `work`; the error of what it throws. A template: a std::function might throw while it is
/// made, outside of the guard.
template <typename Work>
Status guarded(Work&& work) {
    try {
        std::forward<Work>(work)();
    } catch (...) {
        return errorOf(std::current_exception());
    }
    return success();
}

}  // namespace se::view
