#include "spiraling_edge/io/read_points.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"

namespace se {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 1> kPlyExtensions{".ply"};
constexpr std::array<std::string_view, 5> kXyzExtensions{".xyz", ".txt", ".csv", ".asc", ".pts"};
constexpr std::array<std::string_view, 1> kObjExtensions{".obj"};
constexpr std::array<std::string_view, 2> kOffExtensions{".off", ".noff"};
constexpr std::array<std::string_view, 1> kPcdExtensions{".pcd"};
constexpr std::array<std::string_view, 1> kStlExtensions{".stl"};
constexpr std::array<std::string_view, 1> kGlbExtensions{".glb"};
constexpr std::array<std::string_view, 1> kLasExtensions{".las"};
constexpr std::array<std::string_view, 1> kPtxExtensions{".ptx"};

constexpr std::array kPointFormats{
    PointFormat{"PLY", "ascii or binary", kPlyExtensions, true, io::isPly, io::readPly},
    // Binary STL may begin with any text.
    PointFormat{"STL", "ascii or binary", kStlExtensions, true, io::isStl, io::readStl},
    PointFormat{"GLB", "glTF 2.0", kGlbExtensions, true, io::isGlb, io::readGlb},
    PointFormat{"LAS", "", kLasExtensions, false, io::isLas, io::readLas},
    PointFormat{"PTX", "", kPtxExtensions, false, io::isPtx, io::readPtx},
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

/// The extension of a path, that of the packed file for one packed by gzip.
std::string extensionOf(const fs::path& path) {
    const std::string extension = lowerExtension(path);
    return extension == ".gz" ? lowerExtension(path.stem()) : extension;
}

/// A line of XYZ that begins with two slashes, as CloudCompare writes it.
bool isSlashComment(std::string_view line) { return io::Fields(line).next().starts_with("//"); }

io::FileStart startOf(std::string_view bytes, const std::string& name) {
    io::LineReader lines(bytes);
    while (lines.nextContent('#') && isSlashComment(lines.line())) {
    }
    const std::string_view line = lines.line();
    return {bytes, line, io::Fields(line, ',', ';').next(), extensionOf(name)};
}

// ---- encodings ----------------------------------------------------------------------------------

constexpr std::string_view kGzipMark = "\x1f\x8b";

void appendUtf8(std::string& text, std::uint32_t code) {
    const auto add = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
    if (code < 0x80) return add(code);
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    constexpr std::array<std::uint32_t, 4> kFirst{0, 0xc0, 0xe0, 0xf0};
    add(kFirst[static_cast<std::size_t>(more)] | code >> (6U * static_cast<unsigned>(more)));
    for (int i = more - 1; i >= 0; --i)
        add(0x80U | (code >> (6U * static_cast<unsigned>(i)) & 0x3fU));
}

enum class ByteOrder : std::uint8_t { Little, Big };

/// A text in UTF-16, after its byte order mark, as UTF-8. Halves of pairs alone become "?".
std::string fromUtf16(std::string_view bytes, ByteOrder order) {
    std::string text;
    text.reserve(bytes.size() / 2);
    const auto unit = [&](std::size_t at) {
        const auto first = static_cast<unsigned char>(bytes[at]);
        const auto second = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<std::uint32_t>(order == ByteOrder::Big ? first << 8U | second
                                                                  : second << 8U | first);
    };
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        if (code >= 0xd800 && code < 0xe000) {
            const bool pair = code < 0xdc00 && at + 3 < bytes.size() && unit(at + 2) >> 10U == 0x37;
            code = pair ? 0x10000U + ((code & 0x3ffU) << 10U) + (unit(at + 2) & 0x3ffU) : '?';
            if (pair) at += 2;
        }
        appendUtf8(text, code);
    }
    return text;
}

/// The text in another encoding, or with line ends of CR alone, as the readers expect it; empty if
/// it is so already.
std::string recoded(std::string_view bytes) {
    std::string decoded;
    if (bytes.starts_with("\xff\xfe")) decoded = fromUtf16(bytes.substr(2), ByteOrder::Little);
    if (bytes.starts_with("\xfe\xff")) decoded = fromUtf16(bytes.substr(2), ByteOrder::Big);
    if (!decoded.empty()) bytes = decoded;
    const auto holds = [&](char c) { return bytes.find(c) != std::string_view::npos; };
    if (holds('\n') || holds('\0') || !holds('\r')) return decoded;
    std::string lines(bytes);
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    return lines;
}

/// Columns of 64-bit integers become double, which formats know; beyond 2^53 they lose digits.
void narrowColumns(PointFile& file) {
    for (Attribute& column : file.attributes) {
        if (column.type != ScalarType::Int64 && column.type != ScalarType::UInt64) continue;
        column.type = ScalarType::Double;
        io::noteLostDigits(column, file.notes);
    }
}

// ---- files that other programs have to convert --------------------------------------------------

/// A kind of file that is recognized, but not read.
struct UnreadKind {
    std::string_view magic;  ///< The first bytes.
    const char* remedy;      ///< After "NAME: ".
};
constexpr std::array kUnreadKinds{
    UnreadKind{"ASTM-E57",
               "is an E57 file, which cannot be read; convert it, e.g. with "
               "\"pdal translate IN.e57 OUT.ply\" or with CloudCompare"},
    UnreadKind{"\x93NUMPY",
               "is an array of NumPy, which cannot be read; save it as text, e.g. with "
               "python3 -c \"import numpy; numpy.savetxt('OUT.xyz', numpy.load('IN.npy'))\""},
    UnreadKind{"ncols",
               "is a grid of ESRI, which cannot be read; convert it, e.g. with "
               "\"gdal_translate -of XYZ IN.asc OUT.xyz\""},
    UnreadKind{"# vtk",
               "is a VTK file, which cannot be read; convert it, e.g. with "
               "\"meshio convert IN.vtk OUT.ply\" or with ParaView"},
    UnreadKind{"{",
               "is a text in JSON, which cannot be read; export glTF as one binary file (.glb)"},
    UnreadKind{"<",
               "is XML, which cannot be read; convert it, e.g. with "
               "\"meshio convert IN.vtu OUT.ply\" or \"assimp export IN.dae OUT.ply\""},
    UnreadKind{kGzipMark, "is packed by gzip; unpack it with \"gunzip -k IN.gz\""},
    UnreadKind{"BZh", "is packed by bzip2; unpack it with \"bunzip2 -k IN.bz2\""},
    UnreadKind{"\xfd"
               "7zXZ",
               "is packed by xz; unpack it with \"unxz -k IN.xz\""},
    UnreadKind{"\x28\xb5\x2f\xfd", "is packed by Zstandard; unpack it with \"unzstd IN.zst\""},
    UnreadKind{"PK\x03\x04", "is a ZIP archive; unpack it, e.g. with \"unzip IN.zip\""},
};

}  // namespace

std::span<const PointFormat> pointFormats() { return kPointFormats; }

const PointFormat* pointFormatOf(const fs::path& path) {
    const std::string extension = extensionOf(path);
    return rowWhere(kPointFormats, [&](const PointFormat& format) {
        return isAmong(extension, format.extensions);
    });
}

Result<PointFile> readPoints(const fs::path& path, const ByteLimit& limit, Unpack unpack) {
    const Result<std::string> bytes = readBytes(path, limit);
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), path.string(), limit, unpack);
}

Result<PointFile> readPoints(std::string_view bytes, const std::string& name,
                             const ByteLimit& limit, Unpack unpack) {
    if (unpack != nullptr && bytes.starts_with(kGzipMark)) {
        const Result<std::string> unpacked = unpack(bytes, name, limit);
        if (!unpacked) return unpacked.error();
        return readPoints(unpacked.value(), name);
    }
    if (bytes.empty()) return Error{name + ": is empty"};
    const std::string text = recoded(bytes);
    if (!text.empty()) bytes = text;
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    const io::FileStart start = startOf(bytes, name);
    for (const PointFormat& format : kPointFormats) {
        if (!format.recognizes(start)) continue;
        Result<PointFile> file = format.read(bytes, name);
        if (file) narrowColumns(file.value());
        return file;
    }
    for (const UnreadKind& kind : kUnreadKinds) {
        if (bytes.starts_with(kind.magic)) return Error{name + ": " + kind.remedy};
    }
    // The one has an error that says how rows and names of columns have to be, the other may begin
    // with any statement.
    const PointFormat* named = pointFormatOf(name);
    if (named != nullptr && (named->read == io::readXyz || named->read == io::readObj))
        return named->read(bytes, name);
    return Error{name + ": is of no known kind. " + readableText()};
}

Result<PointFile> readStandardInput(const ByteLimit& limit, Unpack unpack) {
    const Result<std::string> bytes = readBytes("/dev/stdin", limit);
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), "standard input", limit, unpack);
}

}  // namespace se
