/// The formats in the table of read_points.cpp: how each is recognized, and its reader, which takes
/// the whole file (without a byte order mark) and its name for errors.
#pragma once

#include <string>
#include <string_view>

#include "spiraling_edge/io/read_points.h"

namespace se::io {

/// The clues to the format of a file.
struct FileStart {
    std::string_view bytes;  ///< All bytes, without a byte order mark.
    std::string_view word;   ///< The first word outside of comments.
    std::string extension;   ///< ".off", in lower case.
};

bool isPly(const FileStart& start);
Result<PointFile> readPly(std::string_view bytes, const std::string& name);

bool isXyz(const FileStart& start);
Result<PointFile> readXyz(std::string_view text, const std::string& name);

bool isObj(const FileStart& start);
Result<PointFile> readObj(std::string_view text, const std::string& name);

bool isOff(const FileStart& start);
/// The keyword of the first line may be missing, as the format allows.
Result<PointFile> readOff(std::string_view text, const std::string& name);

bool isPcd(const FileStart& start);
/// Version 0.7 and earlier, ascii and binary; packed colors become red, green and blue.
Result<PointFile> readPcd(std::string_view bytes, const std::string& name);

/// Appends the fan of a polygon around its first corner; none for fewer than three corners.
void appendFan(std::span<const Index> polygon, std::vector<Triangle>& triangles);

}  // namespace se::io
