/// NRRD: the fields of the header line by line, each with its own checks, then the fields together,
/// then the samples. Sizes are checked against the machine before any sample is read.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"
#include "spiraling_edge/sampling/gzip.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::io {
namespace {

struct NrrdHeader {
    ScalarType type = ScalarType::UInt8;
    bool bigEndian = false;
    bool gzip = false;
    std::string dataFile;  ///< As in the header; empty if the data follow the header.
    std::size_t dataFileLine = 0;
    std::uint64_t lineSkip = 0;
    std::int64_t byteSkip = 0;   ///< -1: the data are the last bytes of the file.
    std::size_t dataOffset = 0;  ///< End of the header.
    Volume volume;               ///< Without its values.

    std::size_t samples() const { return volume.size[0] * volume.size[1] * volume.size[2]; }
};

/// The names of a scalar type in `type`.
struct TypeNames {
    ScalarType type;
    std::array<std::string_view, 6> names;  ///< The rest is empty.
};
constexpr TypeNames kTypes[] = {
    {ScalarType::Int8, {"signed char", "int8", "int8_t"}},
    {ScalarType::UInt8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
    {ScalarType::Int16,
     {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
    {ScalarType::UInt16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
    {ScalarType::Int32, {"int", "signed int", "int32", "int32_t"}},
    {ScalarType::UInt32, {"uint", "unsigned int", "uint32", "uint32_t"}},
    {ScalarType::Float, {"float", "float32", "float32_t"}},
    {ScalarType::Double, {"double", "float64", "float64_t"}},
};

/// Fields of the format that affect neither the place nor the value of a sample.
constexpr std::string_view kIgnored[] = {"content",
                                         "number",
                                         "min",
                                         "max",
                                         "old min",
                                         "oldmin",
                                         "old max",
                                         "oldmax",
                                         "block size",
                                         "blocksize",
                                         "sample units",
                                         "sampleunits",
                                         "labels",
                                         "units",
                                         "kinds",
                                         "thicknesses",
                                         "axis maxs",
                                         "axismaxs",
                                         "space",
                                         "space units",
                                         "space dimension",
                                         "measurement frame",
                                         "comment"};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
    return text;
}

class HeaderParser : LineByLine {
  public:
    HeaderParser(std::string_view bytes, const std::string& name)
        : LineByLine(bytes, name), size_(bytes.size()) {}

    /// In the result, samples() times sizeOf(type) fits a size_t.
    Result<NrrdHeader> parse() {
        if (!takeMagic()) return problem_;
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            if (trimmed(line).empty()) break;
            if (line.front() == '#') continue;
            if (!takeLine(line)) return problem_;
        }
        header_.dataOffset = size_ - lines_.rest().size();
        if (!complete()) return problem_;
        return std::move(header_);
    }

  private:
    bool takeMagic() {
        lines_.next();
        constexpr std::string_view kMagic = "NRRD000";
        const std::string_view magic = trimmed(lines_.line());
        const bool known = magic.size() == kMagic.size() + 1 && magic.starts_with(kMagic) &&
                           magic.back() >= '1' && magic.back() <= '5';
        return known || fail("expected NRRD0001 to NRRD0005, found " + inQuotes(magic));
    }
    bool takeLine(std::string_view line) {
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || colon + 1 >= line.size())
            return fail("expected a field such as `sizes: 64 64 64`, found " + inQuotes(line));
        const std::string key = lowerCase(trimmed(line.substr(0, colon)));
        if (line[colon + 1] == '=') return takeKey(key, trimmed(line.substr(colon + 2)));
        if (isAmong(key, seen_)) return fail("the field " + inQuotes(key) + " stands there twice");
        seen_.push_back(key);
        return takeField(key, trimmed(line.substr(colon + 1)));
    }

    bool takeKey(const std::string& key, std::string_view text) {
        if (key != "isovalue") return true;
        double value = 0.0;
        if (!parseDouble(text, value) || !std::isfinite(value))
            return fail("isovalue: expected a number, found " + inQuotes(text));
        header_.volume.isovalue = value;
        return true;
    }

    bool takeField(const std::string& key, std::string_view text) {
        if (key == "type") return takeType(text);
        if (key == "dimension") return takeDimension(text);
        if (key == "sizes") return takeSizes(text);
        if (key == "spacings") return takeSpacings(text);
        if (key == "axis mins" || key == "axismins") return takePlace(text, key);
        if (key == "centers" || key == "centerings") return takeCenters(text);
        if (key == "space directions") return takeDirections(text);
        if (key == "space origin") return takePlace(text, key);
        if (key == "endian") return takeEndian(text);
        if (key == "encoding") return takeEncoding(text);
        if (key == "data file" || key == "datafile") return takeDataFile(text);
        if (key == "line skip" || key == "lineskip") return takeLineSkip(text);
        if (key == "byte skip" || key == "byteskip") return takeByteSkip(text);
        if (isAmong(key, kIgnored)) return true;
        return fail("NRRD has no field " + inQuotes(key) +
                    "; own fields are written with := after the name");
    }

    bool takeType(std::string_view text) {
        const std::string word = lowerCase(text);
        for (const TypeNames& row : kTypes) {
            if (word.empty() || !isAmong(word, row.names)) continue;
            header_.type = row.type;
            return true;
        }
        return fail(
            "type: expected int8, uint8, int16, uint16, int32, uint32, float or double, "
            "found " +
            inQuotes(text));
    }
    bool takeDimension(std::string_view text) {
        return text == "3" || fail("dimension: only 3 can be read, found " + inQuotes(text));
    }
    bool takeSizes(std::string_view text) {
        if (!isAmong("dimension", seen_)) return fail("sizes: must come after dimension");
        Fields fields(text);
        for (std::size_t& size : header_.volume.size) {
            const std::string_view field = fields.next();
            std::int64_t count = 0;
            constexpr std::int64_t kMax = 1 << 20;
            if (!parseInteger(field, count) || count < 2 || count > kMax)
                return fail("sizes: expected three numbers from 2 to 1048576, found " +
                            inQuotes(text));
            size = static_cast<std::size_t>(count);
        }
        if (!fields.next().empty())
            return fail("sizes: expected three numbers, found " + inQuotes(text));
        const double bytes = 8.0 * static_cast<double>(header_.volume.size[0]) *
                             static_cast<double>(header_.volume.size[1]) *
                             static_cast<double>(header_.volume.size[2]);
        if (bytes > static_cast<double>(std::numeric_limits<std::size_t>::max()) / 4.0)
            return fail("sizes: more samples than this machine can count, " + inQuotes(text));
        return true;
    }

    /// Reads `count` finite numbers; brackets and commas count as blanks.
    bool takeNumbers(std::string_view text, double* numbers, std::size_t count) const {
        std::string plain(text);
        for (char& c : plain) {
            if (c == '(' || c == ')' || c == ',') c = ' ';
        }
        Fields fields(plain);
        for (std::size_t i = 0; i < count; ++i) {
            if (!parseDouble(fields.next(), numbers[i]) || !std::isfinite(numbers[i])) return false;
        }
        return fields.next().empty();
    }
    bool takeSpacings(std::string_view text) {
        std::array<double, 3> s{};
        if (!takeNumbers(text, s.data(), 3) || !(s[0] > 0.0) || !(s[1] > 0.0) || !(s[2] > 0.0))
            return fail("spacings: expected three numbers above 0, found " + inQuotes(text));
        return setSpacing({s[0], s[1], s[2]});
    }
    bool takeDirections(std::string_view text) {
        std::array<double, 9> d{};
        const bool numbers = takeNumbers(text, d.data(), 9);
        const bool diagonal =
            d[1] == 0.0 && d[2] == 0.0 && d[3] == 0.0 && d[5] == 0.0 && d[6] == 0.0 && d[7] == 0.0;
        if (!numbers || !diagonal || !(d[0] > 0.0) || !(d[4] > 0.0) || !(d[8] > 0.0))
            return fail(
                "space directions: only axes along x, y and z, with lengths above 0, can "
                "be read, such as (1,0,0) (0,1,0) (0,0,2); found " +
                inQuotes(text));
        return setSpacing({d[0], d[4], d[8]});
    }
    bool setSpacing(const Vec3& spacing) {
        if (hasSpacing_) return fail("spacings and space directions must not stand together");
        hasSpacing_ = true;
        header_.volume.spacing = spacing;
        return true;
    }
    bool takePlace(std::string_view text, const std::string& key) {
        std::array<double, 3> at{};
        if (!takeNumbers(text, at.data(), 3))
            return fail(key + ": expected three numbers, found " + inQuotes(text));
        if (hasOrigin_) return fail("axis mins and space origin must not stand together");
        hasOrigin_ = true;
        originIsOfAxis_ = key != "space origin";
        header_.volume.origin = {at[0], at[1], at[2]};
        return true;
    }
    bool takeCenters(std::string_view text) {
        Fields fields(text);
        for (bool& cell : cellCentered_) {
            const std::string word = lowerCase(fields.next());
            if (word != "cell" && word != "node" && word != "none" && word != "???")
                return fail("centers: expected cell or node three times, found " + inQuotes(text));
            cell = word == "cell";
        }
        return true;
    }

    bool takeEndian(std::string_view text) {
        const std::string word = lowerCase(text);
        if (word != "little" && word != "big")
            return fail("endian: expected little or big, found " + inQuotes(text));
        header_.bigEndian = word == "big";
        return true;
    }
    bool takeEncoding(std::string_view text) {
        const std::string word = lowerCase(text);
        header_.gzip = word == "gzip" || word == "gz";
        if (!header_.gzip && word != "raw")
            return fail("encoding: only raw and gzip can be read, found " + inQuotes(text) +
                        "; `unu save -e gzip` converts");
        return true;
    }
    bool takeDataFile(std::string_view text) {
        if (text == "LIST" || text.starts_with("LIST ") || text.find('%') != std::string_view::npos)
            return fail("data file: only a single file can be read, found " + inQuotes(text));
        header_.dataFile = std::string(text);
        header_.dataFileLine = lines_.number();
        if (text.empty()) return fail("data file: expected the name of a file");
        return true;
    }
    bool takeLineSkip(std::string_view text) {
        return parseCount(text, header_.lineSkip) ||
               fail("line skip: expected a number from 0 on, found " + inQuotes(text));
    }
    bool takeByteSkip(std::string_view text) {
        return (parseInteger(text, header_.byteSkip) && header_.byteSkip >= -1) ||
               fail("byte skip: expected a number from -1 on, found " + inQuotes(text));
    }

    bool complete() {
        for (const char* field : {"type", "dimension", "sizes", "encoding", "endian"}) {
            const bool needed = field != std::string_view("endian") || sizeOf(header_.type) > 1;
            if (needed && !isAmong(field, seen_))
                return fail(std::string("the header ends without the field ") + field);
        }
        if (header_.gzip && header_.byteSkip < 0) return fail("byte skip -1 does not go with gzip");
        if (originIsOfAxis_) {
            for (int axis = 0; axis < 3; ++axis) {
                if (cellCentered_[static_cast<std::size_t>(axis)])
                    header_.volume.origin[axis] += 0.5 * header_.volume.spacing[axis];
            }
        }
        return true;
    }

    std::size_t size_;
    NrrdHeader header_;
    std::vector<std::string> seen_;
    std::array<bool, 3> cellCentered_{};
    bool hasSpacing_ = false, hasOrigin_ = false, originIsOfAxis_ = false;
};

// ---- data ---------------------------------------------------------------------------------------

/// `data` without its first lines.
Result<std::string_view> skipLines(std::string_view data, std::size_t count,
                                   const std::string& name) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t end = data.find('\n');
        if (end == std::string_view::npos)
            return Error{name + ": has fewer than the " + std::to_string(count) +
                         " lines that `line skip` passes over"};
        data.remove_prefix(end + 1);
    }
    return data;
}

/// The bytes of the samples as they lie in a raw file.
Result<std::string_view> rawBytes(const NrrdHeader& header, std::string_view data,
                                  std::size_t expected, const std::string& name) {
    const auto skip = header.byteSkip < 0 ? data.size() - std::min(expected, data.size())
                                          : static_cast<std::size_t>(header.byteSkip);
    data.remove_prefix(std::min(skip, data.size()));
    if (data.size() == expected) return data;
    return Error{name + ": expected " + std::to_string(expected) + " bytes of data, found " +
                 std::to_string(data.size()) + "; check sizes, type and encoding"};
}

/// The values, from the bytes that follow the header or those of the data file. `name` is the file
/// that holds them. Fails before it allocates more than `limit`.
Result<Volume> decodeNrrd(const NrrdHeader& header, std::string_view data, const std::string& name,
                          const ByteLimit& limit) {
    const std::size_t expected = header.samples() * sizeOf(header.type);
    const Result<std::string_view> body = skipLines(data, header.lineSkip, name);
    if (!body) return body.error();
    std::string unpacked;
    Result<std::string_view> bytes = std::string_view{};
    if (header.gzip) {
        // The skipped bytes are part of the stream.
        const auto skip = static_cast<std::size_t>(header.byteSkip);
        if (skip > std::numeric_limits<std::size_t>::max() - expected)
            return Error{name + ": `byte skip` passes over more than any file holds"};
        if (skip + expected > limit.bytes) return limit.exceededBy(name);
        Result<std::string> inflated = inflateExactly(body.value(), skip + expected);
        if (!inflated) return Error{name + ": " + inflated.error().message};
        unpacked = std::move(inflated.value());
        bytes = std::string_view(unpacked).substr(skip);
    } else {
        bytes = rawBytes(header, body.value(), expected, name);
    }
    if (!bytes) return bytes.error();
    if (sizeof(float) * header.samples() > limit.bytes) return limit.exceededBy(name);
    Volume volume = header.volume;
    volume.value.resize(header.samples());
    const bool swapped = header.bigEndian == (std::endian::native == std::endian::little);
    withScalar(header.type, [&](auto zero) {
        const char* at = bytes.value().data();
        for (float& value : volume.value) {
            value = static_cast<float>(loadScalar<decltype(zero)>(at, swapped));
            at += sizeof(zero);
        }
    });
    const auto odd = std::find_if_not(volume.value.begin(), volume.value.end(),
                                      [](float v) { return std::isfinite(v); });
    if (odd != volume.value.end()) {
        return Error{name + ": sample " + std::to_string(odd - volume.value.begin()) +
                     " is not a finite number; replace such samples by a value outside of the "
                     "surface"};
    }
    return volume;
}

}  // namespace
}  // namespace se::io

namespace se {

Result<Volume> readVolume(const std::filesystem::path& path, const ByteLimit& limit) {
    const std::string name = path.string();
    const Result<std::string> bytes = readBytes(path, limit);
    if (!bytes) return bytes.error();
    const Result<io::NrrdHeader> parsed = io::HeaderParser(bytes.value(), name).parse();
    if (!parsed) return parsed.error();
    const io::NrrdHeader& header = parsed.value();
    if (header.dataFile.empty()) return readVolume(bytes.value(), name, limit);
    const std::filesystem::path dataPath = path.parent_path() / header.dataFile;
    if (isUnfit(dataPath)) {
        return io::errorAt(name, io::lineText(header.dataFileLine),
                           dataPath.string() + ": expected a regular file");
    }
    const Result<std::string> data = readBytes(dataPath, limit);
    if (!data) return io::errorAt(name, io::lineText(header.dataFileLine), data.error().message);
    return io::decodeNrrd(header, data.value(), dataPath.string(), limit);
}

std::filesystem::path dataFileOf(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) return {};
    constexpr std::size_t kHeader = 1U << 16U;  // Without the values that may follow it.
    std::string bytes(kHeader, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    const std::string name = path.string();
    const Result<io::NrrdHeader> header = io::HeaderParser(bytes, name).parse();
    if (!header || header.value().dataFile.empty()) return {};
    return path.parent_path() / header.value().dataFile;
}

Result<Volume> readVolume(std::string_view bytes, const std::string& name, const ByteLimit& limit) {
    const Result<io::NrrdHeader> header = io::HeaderParser(bytes, name).parse();
    if (!header) return header.error();
    if (!header.value().dataFile.empty()) {
        return io::errorAt(name, io::lineText(header.value().dataFileLine),
                           "the data are in another file, which cannot be reached from here");
    }
    return io::decodeNrrd(header.value(), bytes.substr(header.value().dataOffset), name, limit);
}

}  // namespace se
