/// Decompression of gzip.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "spiraling_edge/base/result.h"

namespace se {

/// The `expected` bytes that a gzip (or zlib) stream holds. Fails, with a reason to append to the
/// name of a file, if it is damaged or holds fewer or more. Allocates nothing that the stream could
/// not fill.
Result<std::string> inflateExactly(std::string_view packed, std::size_t expected);

}  // namespace se
