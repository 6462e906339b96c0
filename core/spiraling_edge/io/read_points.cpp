#include "spiraling_edge/io/read_points.h"

#include <algorithm>
#include <array>

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

Result<PointFile> readPoints(const fs::path& path, const ByteLimit& limit) {
    const Result<std::string> bytes = readBytes(path, limit);
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

Result<PointFile> readStandardInput(const ByteLimit& limit) {
    const Result<std::string> bytes = readBytes("/dev/stdin", limit);
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), "standard input");
}

}  // namespace se
