/// The readers that readPoints() dispatches to, one per format. Each takes the whole file (without
/// a byte order mark) and its name for errors.
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/io/read_points.h"

namespace se::io {

Result<PointFile> readPly(std::string_view bytes, const std::string& name);
Result<PointFile> readXyz(std::string_view text, const std::string& name);
Result<PointFile> readObj(std::string_view text, const std::string& name);
/// The keyword of the first line may be missing, as the format allows.
Result<PointFile> readOff(std::string_view text, const std::string& name);

/// Version 0.7 and earlier, ascii and binary; packed colors become red, green and blue.
Result<PointFile> readPcd(std::string_view bytes, const std::string& name);

/// True if `word` is a keyword that opens an OFF file: OFF with any of the prefixes C, N, ST.
bool isOffKeyword(std::string_view word);

/// Appends the fan of a polygon around its first corner; none for fewer than three corners.
void appendFan(std::span<const Index> polygon, std::vector<Triangle>& triangles);

}  // namespace se::io
