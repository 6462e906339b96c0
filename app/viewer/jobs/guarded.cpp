#include "guarded.h"

#include <new>
#include <stdexcept>
#include <string>

namespace se::view {

namespace {

Error outOfMemory() {
    return Error{"Out of memory. Close other programs, or use fewer points or shorter lists."};
}

}  // namespace

Error errorOf(const std::exception_ptr& exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    } catch (const std::length_error&) {
        // More than any memory holds: containers refuse it before they allocate.
        return outOfMemory();
    } catch (const std::exception& problem) {
        return Error{std::string("Internal error: ") + problem.what() + "."};
    } catch (...) {
        return Error{"Internal error: unknown exception."};
    }
}

}  // namespace se::view
