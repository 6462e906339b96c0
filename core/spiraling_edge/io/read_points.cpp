#include "spiraling_edge/io/read_points.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"

namespace se {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> kPlyExtensions{".ply"};
constexpr std::array<std::string_view, 2> kXyzExtensions{".xyz", ".txt"};
constexpr std::array<std::string_view, 1> kObjExtensions{".obj"};
constexpr std::array<std::string_view, 2> kOffExtensions{".off", ".noff"};
constexpr std::array<std::string_view, 1> kPcdExtensions{".pcd"};

constexpr std::array kPointFormats{
    PointFormat{"PLY", "ascii or binary", kPlyExtensions, true, io::isPly, io::readPly},
    PointFormat{"XYZ", "x y z per line, then normals or colors", kXyzExtensions, false, io::isXyz,
                io::readXyz},
    PointFormat{"OBJ", "", kObjExtensions, true, io::isObj, io::readObj},
    PointFormat{"OFF", "", kOffExtensions, true, io::isOff, io::readOff},
    PointFormat{"PCD", "", kPcdExtensions, false, io::isPcd, io::readPcd},
};

/// "PLY (ascii or binary), ... and PCD can be read; ...".
std::string readableText() {
    std::vector<std::string> formats;
    for (const PointFormat& each : kPointFormats) {
        std::string& text = formats.emplace_back(each.name);
        if (!each.details.empty()) text.append(" (").append(each.details).append(")");
    }
    return wordList(formats, "and") +
           " can be read; convert it to one of these, e.g. with MeshLab or CloudCompare";
}

/// A line of XYZ that begins with two slashes, as CloudCompare writes it.
bool isSlashComment(std::string_view line) { return io::Fields(line).next().starts_with("//"); }

io::FileStart startOf(std::string_view bytes, const std::string& name) {
    io::LineReader lines(bytes);
    while (lines.nextContent('#') && isSlashComment(lines.line())) {
    }
    return {bytes, io::Fields(lines.line(), ',', ';').next(), lowerExtension(name)};
}

}  // namespace

std::span<const PointFormat> pointFormats() { return kPointFormats; }

const PointFormat* pointFormatOf(const fs::path& path) {
    const std::string extension = lowerExtension(path);
    const auto found =
        std::find_if(kPointFormats.begin(), kPointFormats.end(), [&](const PointFormat& format) {
            const auto& all = format.extensions;
            return std::find(all.begin(), all.end(), extension) != all.end();
        });
    return found == kPointFormats.end() ? nullptr : &*found;
}

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
    const io::FileStart start = startOf(bytes, name);
    for (const PointFormat& format : kPointFormats) {
        if (format.recognizes(start)) return format.read(bytes, name);
    }
    return Error{name + ": is of no known kind. " + readableText()};
}

Result<PointFile> readStandardInput() {
    const std::string name = "standard input";
    std::string bytes;
    std::array<char, 1U << 16U> block{};
    std::size_t count = 0;
    while ((count = std::fread(block.data(), 1, block.size(), stdin)) > 0)
        bytes.append(block.data(), count);
    if (std::ferror(stdin) != 0) return Error{name + ": cannot be read"};
    return readPoints(bytes, name);
}

}  // namespace se
