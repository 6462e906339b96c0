/// A small file as one line of text, which stands for the path of a file anywhere: the file inside
/// a link.
///
///     pack:cube.xyz:M1QwVDBUMOIyRCYB
///
/// The name keeps its extension, by which the format is recognized. After it come the bytes, packed
/// by deflate and written in the letters of base64url.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "spiraling_edge/base/result.h"

namespace se::view {

inline constexpr std::string_view kPackPrefix = "pack:";
inline bool isPacked(std::string_view source) { return source.starts_with(kPackPrefix); }

/// Most bytes that a packed file unpacks to.
inline constexpr std::size_t kMostUnpacked = std::size_t{4} << 20U;

/// Bytes packed by deflate, without a header.
std::string deflated(std::string_view bytes);

struct PackedFile {
    std::string name;  ///< Without folders.
    std::string bytes;
};

/// The line of a file.
std::string packedSource(const PackedFile& file);
/// Reads the line back. Fails with a sentence if it is damaged, or unpacks to more than
/// kMostUnpacked bytes.
Result<PackedFile> unpackedFile(std::string_view source);
/// The name of the file in the line.
std::string packedName(std::string_view source);

// Bytes as letters, four for three: RFC 4648, for data in pages and for files in links.

/// Bytes as base64, filled up with `=`.
std::string base64Of(std::string_view bytes);

/// Bytes as base64url, which addresses may hold: `-` and `_` in place of `+` and `/`, not filled
/// up.
std::string base64UrlOf(std::string_view bytes);
/// Reads base64url; empty if there is another letter, or a rest that is no byte.
std::optional<std::string> bytesOfBase64Url(std::string_view letters);

}  // namespace se::view
