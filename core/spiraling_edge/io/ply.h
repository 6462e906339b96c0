/// Common parts of the PLY reader and writer: scalar types, the header, and scalars in bytes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/io/read_points.h"

namespace se::io {

enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::Float;
    bool isList = false;
    ScalarType countType = ScalarType::UInt8;  ///< Of lists only.
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;  ///< As announced; must be checked against the size of the file.
    std::size_t line = 0;     ///< Line of the header that announces it.
    std::vector<PlyProperty> properties;

    bool hasList() const {
        return std::any_of(properties.begin(), properties.end(),
                           [](const PlyProperty& p) { return p.isList; });
    }
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< Bytes up to the first row.
    std::size_t lines = 0;  ///< Lines up to the first row.
};

/// Reads the header and makes the checks that need no rows.
Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name);

/// Calls `use` with a value of the C++ type of `type`.
template <typename Use>
decltype(auto) withScalar(ScalarType type, Use&& use) {
    switch (type) {
        case ScalarType::Int8:
            return use(std::int8_t{});
        case ScalarType::UInt8:
            return use(std::uint8_t{});
        case ScalarType::Int16:
            return use(std::int16_t{});
        case ScalarType::UInt16:
            return use(std::uint16_t{});
        case ScalarType::Int32:
            return use(std::int32_t{});
        case ScalarType::UInt32:
            return use(std::uint32_t{});
        case ScalarType::Float:
            return use(float{});
        case ScalarType::Double:
            break;
    }
    return use(double{});
}

inline bool isInteger(ScalarType type) {
    return type != ScalarType::Float && type != ScalarType::Double;
}
inline std::size_t sizeOf(ScalarType type) {
    return withScalar(type, [](auto scalar) { return sizeof(scalar); });
}
/// The name of `type` in headers: "uchar".
inline std::string_view nameOf(ScalarType type) {
    constexpr std::array<std::string_view, 8> kNames{"char", "uchar", "short", "ushort",
                                                     "int",  "uint",  "float", "double"};
    return kNames[static_cast<std::size_t>(type)];
}

/// The scalar at `bytes`, in the other byte order if `swapped`.
template <typename Scalar>
Scalar loadScalar(const char* bytes, bool swapped) {
    std::array<char, sizeof(Scalar)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Scalar));
    if (swapped) std::reverse(raw.begin(), raw.end());
    Scalar scalar;
    std::memcpy(&scalar, raw.data(), sizeof(Scalar));
    return scalar;
}

/// Stores `scalar` at `bytes` in little endian order and returns the address after it.
template <typename Scalar>
char* storeScalar(char* bytes, Scalar scalar) {
    std::memcpy(bytes, &scalar, sizeof(Scalar));
    if (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(Scalar));
    return bytes + sizeof(Scalar);
}

}  // namespace se::io
