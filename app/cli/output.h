/// Where results go: a file or `-`, standard output.
#pragma once

#include <string>
#include <string_view>

namespace se::cli {

/// Fails early, before long work, if nothing could be written to `path`. `option` is what messages
/// call it. An empty path and `-` are good.
void requireWritable(const std::string& path, std::string_view option);

/// Writes all of it, to a file by way of a temporary one. Throws Failure(Internal).
void writeOutput(const std::string& path, std::string_view bytes);

}  // namespace se::cli
