/// Bytes as letters, four for three: RFC 4648, for data in pages and for files in links.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace se::view {

/// Bytes as base64, filled up with `=`.
std::string base64Of(std::string_view bytes);

/// Bytes as base64url, which addresses may hold: `-` and `_` in place of `+` and `/`, not filled
/// up.
std::string base64UrlOf(std::string_view bytes);
/// Reads base64url; empty if there is another letter, or a rest that is no byte.
std::optional<std::string> bytesOfBase64Url(std::string_view letters);

}  // namespace se::view
