/// Scalars in files, shared by the formats with typed numbers (PLY, PCD, NRRD): their types, their
/// bytes, and the columns that they are read to.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/points/point_file.h"

namespace se::io {

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
        case ScalarType::Int64:
            return use(std::int64_t{});
        case ScalarType::UInt64:
            return use(std::uint64_t{});
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
/// The names of the types in headers of PLY, by ScalarType.
inline constexpr std::array<std::string_view, 10> kTypeNames{
    "char", "uchar", "short", "ushort", "int", "uint", "float", "double", "int64", "uint64"};
inline std::string_view nameOf(ScalarType type) {
    return kTypeNames[static_cast<std::size_t>(type)];
}

/// True if numbers in little endian files are in the other byte order than those of this machine.
inline constexpr bool kLittleIsSwapped = std::endian::native == std::endian::big;

/// Whole numbers up to 2^53 are exact as double.
inline constexpr double kGreatestWhole = 9007199254740992.0;

/// The scalar at `bytes`, in the other byte order if `swapped`.
template <typename Scalar>
Scalar loadScalar(const char* bytes, bool swapped) {
    std::array<char, sizeof(Scalar)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Scalar));
    if (swapped) std::reverse(raw.begin(), raw.end());
    return bitsAs<Scalar>(raw);
}

/// Stores `scalar` at `bytes` in little endian order and returns the address after it.
template <typename Scalar>
char* storeScalar(char* bytes, Scalar scalar) {
    std::memcpy(bytes, &scalar, sizeof(Scalar));
    if (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof(Scalar));
    return bytes + sizeof(Scalar);
}

/// The target of the numbers of a column: that of row r is first[r * stride]; none if null.
struct Column {
    double* first = nullptr;
    std::size_t stride = 1;

    void set(std::size_t row, double value) const {
        if (first != nullptr) first[row * stride] = value;
    }
    /// Loads the scalars of `rows` rows, each `rowSize` bytes after the one before.
    void load(ScalarType type, const char* bytes, std::size_t rowSize, std::size_t rows,
              bool swapped) const {
        if (first == nullptr) return;
        withScalar(type, [&](auto zero) {
            for (std::size_t row = 0; row < rows; ++row) {
                first[row * stride] =
                    static_cast<double>(loadScalar<decltype(zero)>(bytes + row * rowSize, swapped));
            }
        });
    }
};

/// Rounds `value` to what `type` can hold; beyond the range of float it becomes infinite. False if
/// it is out of the range of an integer type, or no whole number.
inline bool roundTo(ScalarType type, double& value) {
    if (type == ScalarType::Double) return true;
    if (type == ScalarType::Float) {
        value = static_cast<double>(static_cast<float>(value));
        return true;
    }
    return withScalar(type, [&](auto scalar) {
        using Limits = std::numeric_limits<decltype(scalar)>;
        return value >= static_cast<double>(Limits::lowest()) &&
               value <= static_cast<double>(Limits::max()) && value == std::floor(value);
    });
}

/// Adds a note for a column of whole numbers of which one is beyond those that are exact.
inline void noteLostDigits(const Attribute& column, std::vector<std::string>& notes) {
    const bool exact = std::all_of(column.values.begin(), column.values.end(),
                                   [](double value) { return std::abs(value) < kGreatestWhole; });
    if (exact) return;
    notes.push_back("column " + column.name + ": numbers above 2^53 have lost their last digits");
}

/// Numbers of a text that were rounded to its types: those beyond the range of float are counted by
/// column.
class RoundedNumbers {
  public:
    /// As io::roundTo().
    bool round(ScalarType type, double& value, const std::string& column) {
        const double before = value;
        if (!roundTo(type, value)) return false;
        if (std::isinf(value) && !std::isinf(before)) ++beyond_[column];
        return true;
    }
    /// A note for each column with such numbers.
    void addNotes(std::vector<std::string>& notes) const {
        for (const auto& [column, count] : beyond_) {
            notes.push_back("column " + column + ": " + counted(count, "number") +
                            " beyond the range of float became infinite");
        }
    }

  private:
    std::map<std::string, std::size_t> beyond_;
};

}  // namespace se::io
