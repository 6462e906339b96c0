/// Error texts of the operating system.
#pragma once

#include <cerrno>
#include <string>
#include <system_error>

namespace se {

/// The text of errno: "No space left on device".
inline std::string systemReason() { return std::generic_category().message(errno); }

}  // namespace se
