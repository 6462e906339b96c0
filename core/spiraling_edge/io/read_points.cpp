#include "spiraling_edge/io/read_points.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "spiraling_edge/base/file_extension.h"
#include "spiraling_edge/base/read_file.h"
#include "spiraling_edge/base/system_reason.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/point_formats.h"

namespace se {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReadable =
    "PLY (ascii or binary), XYZ (x y z per line, then normals or colors), OBJ, OFF and PCD can be "
    "read; "
    "convert it to one of these, e.g. with MeshLab or CloudCompare";

using ReadFunction = Result<PointFile> (*)(std::string_view, const std::string&);

bool isObjKeyword(std::string_view word) {
    constexpr std::array<std::string_view, 14> kKeywords{
        "v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl", "mg", "cstype"};
    return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

/// A line of XYZ that begins with two slashes, as CloudCompare writes it.
bool isSlashComment(std::string_view line) { return io::Fields(line).next().starts_with("//"); }

/// The reader for the apparent format of `bytes`; null if it is none that can be read.
ReadFunction findReader(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || bytes.starts_with("ply "))
        return io::readPly;
    io::LineReader lines(bytes);
    while (lines.nextContent('#') && isSlashComment(lines.line())) {
    }
    const std::string_view word = io::Fields(lines.line(), ',', ';').next();
    if (word == "VERSION" || word == "FIELDS") return io::readPcd;
    if (io::isOffKeyword(word)) return io::readOff;
    if (isObjKeyword(word)) return io::readObj;
    double number = 0.0;
    if (!io::parseDouble(word, number)) return nullptr;
    // OFF may begin with its counts, which only the extension distinguishes from a point.
    return lowerExtension(name) == ".off" ? io::readOff : io::readXyz;
}

}  // namespace

Result<std::string> readBytes(const fs::path& path) {
    const std::string name = path.string();
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return Error{name + ": there is no such file"};
    if (fs::is_directory(status)) return Error{name + ": is a folder; name a file in it"};
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{name + ": cannot be opened: " + systemReason()};
    std::string bytes;
    if (fs::is_regular_file(status)) {
        const std::uintmax_t size = fs::file_size(path, ignored);
        // One byte more than expected, to detect the end without another round.
        if (!ignored) bytes.resize(static_cast<std::size_t>(size) + 1);
    }
    std::size_t filled = 0;
    while (stream) {
        constexpr std::size_t kLeastRoom = 1U << 16U;
        if (filled == bytes.size()) bytes.resize(std::max(kLeastRoom, 2 * bytes.size()));
        stream.read(bytes.data() + filled, static_cast<std::streamsize>(bytes.size() - filled));
        filled += static_cast<std::size_t>(stream.gcount());
    }
    if (stream.bad()) return Error{name + ": cannot be read: " + systemReason()};
    bytes.resize(filled);
    return bytes;
}

Result<PointFile> readPoints(const fs::path& path) {
    const Result<std::string> bytes = readBytes(path);
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), path.string());
}

Result<PointFile> readPoints(std::string_view bytes, const std::string& name) {
    if (bytes.empty()) return Error{name + ": is empty"};
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    const ReadFunction reader = findReader(bytes, name);
    if (reader == nullptr) return Error{name + ": is of no known kind. " + kReadable};
    return reader(bytes, name);
}

}  // namespace se
