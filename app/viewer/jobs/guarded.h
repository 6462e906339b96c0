/// Work of a thread that no exception leaves: an uncaught one would end the program.
#pragma once

#include <exception>
#include <utility>

#include "spiraling_edge/base/result.h"

namespace se::view {

/// A sentence for the user: too little memory, or the text of the exception.
Error errorOf(const std::exception_ptr& exception);

/// Calls `work` and returns the error of an exception it throws. A template, because constructing a
/// std::function might throw outside of the guard.
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
