#include "guarded.h"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace se::view {

namespace {

Error outOfMemory() {
    return Error{"Out of memory. Close other programs, or take fewer points or shorter lists."};
}

}  // namespace

Status guarded(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    } catch (const std::length_error&) {
        // More than any memory has: containers refuse it before they ask for it.
        return outOfMemory();
    } catch (const std::exception& problem) {
        return Error{std::string("Internal error: ") + problem.what() + "."};
    } catch (...) {
        return Error{"Internal error: an exception without a text."};
    }
    return success();
}

}  // namespace se::view
