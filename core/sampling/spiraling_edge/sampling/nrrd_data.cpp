#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/sampling/inflate.h"
#include "spiraling_edge/sampling/nrrd.h"

namespace se::io {
namespace {

template <typename T>
void convert(const char* bytes, bool swap, std::vector<float>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::array<char, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes + i * sizeof(T), sizeof(T));
        if (swap) std::reverse(raw.begin(), raw.end());
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        values[i] = static_cast<float>(value);
    }
}

void convertAll(NrrdType type, const char* bytes, bool swap, std::vector<float>& values) {
    switch (type) {
        case NrrdType::Int8:
            return convert<std::int8_t>(bytes, swap, values);
        case NrrdType::UInt8:
            return convert<std::uint8_t>(bytes, swap, values);
        case NrrdType::Int16:
            return convert<std::int16_t>(bytes, swap, values);
        case NrrdType::UInt16:
            return convert<std::uint16_t>(bytes, swap, values);
        case NrrdType::Int32:
            return convert<std::int32_t>(bytes, swap, values);
        case NrrdType::UInt32:
            return convert<std::uint32_t>(bytes, swap, values);
        case NrrdType::Float:
            return convert<float>(bytes, swap, values);
        case NrrdType::Double:
            return convert<double>(bytes, swap, values);
    }
}

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

}  // namespace

Result<Volume> decodeNrrd(const NrrdHeader& header, std::string_view data,
                          const std::string& name) {
    const std::size_t expected = header.samples() * bytesOf(header.type);
    const Result<std::string_view> body = skipLines(data, header.lineSkip, name);
    if (!body) return body.error();
    std::string unpacked;
    Result<std::string_view> bytes = std::string_view{};
    if (header.gzip) {
        // The skipped bytes are part of the stream.
        const auto skip = static_cast<std::size_t>(header.byteSkip);
        if (skip > std::numeric_limits<std::size_t>::max() - expected)
            return Error{name + ": `byte skip` passes over more than any file holds"};
        Result<std::string> inflated = inflateExactly(body.value(), skip + expected);
        if (!inflated) return Error{name + ": " + inflated.error().message};
        unpacked = std::move(inflated.value());
        bytes = std::string_view(unpacked).substr(skip);
    } else {
        bytes = rawBytes(header, body.value(), expected, name);
    }
    if (!bytes) return bytes.error();
    Volume volume = header.volume;
    volume.value.resize(header.samples());
    const bool swap = header.bigEndian == (std::endian::native == std::endian::little);
    convertAll(header.type, bytes.value().data(), swap, volume.value);
    const auto odd = std::find_if_not(volume.value.begin(), volume.value.end(),
                                      [](float v) { return std::isfinite(v); });
    if (odd != volume.value.end()) {
        return Error{name + ": sample " + std::to_string(odd - volume.value.begin()) +
                     " is not a finite number; replace such samples by a value outside of the "
                     "surface"};
    }
    return volume;
}

}  // namespace se::io
