/// Unpacking of files by gzip, for the readers of the core library, which needs no zlib.
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/result.h"

namespace se {

/// The `expected` bytes that a gzip (or zlib) stream holds. Fails, with a reason to append to the
/// name of a file, if it is damaged or holds fewer or more. Allocates nothing that the stream could
/// not fill.
Result<std::string> inflateExactly(std::string_view packed, std::size_t expected);
/// The bytes of a gzip file of one or several streams; an Unpack of readPoints(). Errors begin with
/// `name`: damaged, cut short, or more than `limit`, of which at most 1 MiB more is unpacked.
Result<std::string> unpackGzip(std::string_view packed, const std::string& name,
                               const ByteLimit& limit);

}  // namespace se
