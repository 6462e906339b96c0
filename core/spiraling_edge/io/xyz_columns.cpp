/// XYZ has no header: the meaning of its columns is inferred from the numbers of the whole file
/// (range, whole numbers, length), and only where one reading is possible. O(numbers).
#include "spiraling_edge/io/xyz_columns.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "spiraling_edge/io/formats.h"

namespace se::io {
namespace {

constexpr double kHighestColor = 255.0;
/// More than the error of normals written with two decimals.
constexpr double kLengthTolerance = 0.02;

/// Kinds of three columns.
enum class Look {
    Colors,
    Black,    ///< 0 in every row, as whole numbers.
    Normals,  ///< Mostly of length 1.
    Scaled,   ///< Directions of other lengths.
    Unclear,
};

/// The numbers of three columns.
struct TripleFacts {
    bool digitsOnly = true;
    bool whole = true;  ///< Every finite number is a whole one.
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t directed = 0;  ///< Rows that are finite and not zero.
    std::size_t unit = 0;      ///< Those among them of length 1.
};

TripleFacts factsOf(const ExtraColumns& extra, std::size_t first) {
    TripleFacts facts;
    for (std::size_t i = first; i < first + 3; ++i) facts.digitsOnly &= extra.digitsOnly[i];
    for (std::size_t at = first; at < extra.values.size(); at += extra.width()) {
        double square = 0.0;
        for (std::size_t i = at; i < at + 3; ++i) {
            const double value = extra.values[i];
            square += value * value;
            facts.whole = facts.whole && (!std::isfinite(value) || value == std::floor(value));
            facts.low = std::min(facts.low, value);
            facts.high = std::max(facts.high, value);
        }
        if (!(square > 0.0) || !std::isfinite(square)) continue;
        ++facts.directed;
        facts.unit += std::abs(std::sqrt(square) - 1.0) <= kLengthTolerance ? 1U : 0U;
    }
    return facts;
}

Look lookOf(const ExtraColumns& extra, std::size_t first) {
    const TripleFacts facts = factsOf(extra, first);
    const bool mostlyUnit = facts.directed > 0 && 2 * facts.unit >= facts.directed;
    if (facts.digitsOnly && facts.high <= kHighestColor) {
        if (facts.directed == 0) return Look::Black;
        // Normals along the axes, such as 0 0 1.
        if (facts.high <= 1.0) return facts.unit == facts.directed ? Look::Normals : Look::Unclear;
        return mostlyUnit ? Look::Unclear : Look::Colors;
    }
    if (facts.digitsOnly) return Look::Unclear;  // Colors of 16 bits, perhaps.
    if (mostlyUnit) return Look::Normals;
    // A color with one wrong number is no normal.
    if (facts.whole && facts.directed > 0) return Look::Unclear;
    // All zero or not finite: reading it as normals reports that they are missing.
    if (facts.low < 0.0 || facts.directed == 0) return Look::Scaled;
    return Look::Unclear;  // Colors from 0 to 1, perhaps.
}

bool isColorful(Look look) { return look == Look::Colors || look == Look::Black; }
bool isNormal(Look look) { return look == Look::Normals || look == Look::Scaled; }

/// "columns 4 to 6", for the three extra columns from `first`.
std::string tripleText(std::size_t first) {
    return "columns " + std::to_string(first + 4) + " to " + std::to_string(first + 6);
}

std::string reasonOf(Look look, std::size_t first) {
    assert(look != Look::Unclear);
    constexpr std::array<const char*, 4> kReasons{
        " are whole numbers from 0 to 255: colors", " are 0 in every row: colors",
        " have length 1: normals", " are read as normals, but their length is not 1"};
    return tripleText(first) + kReasons[static_cast<std::size_t>(look)];
}

Error cannotTell(std::size_t columns, const std::string& which) {
    return Error{"found " + std::to_string(columns) + " columns and cannot tell what " + which +
                 " hold: colors are whole numbers from 0 to 255, normals have length 1; name the "
                 "columns in a line before the points, such as \"# x y z red green blue\" or "
                 "\"# x y z nx ny nz\", with one name per column"};
}

std::vector<std::string> namesOf(Look look) {
    if (isColorful(look)) return {"red", "green", "blue"};
    return {"nx", "ny", "nz"};
}

Result<NamedColumns> recognizeSix(const ExtraColumns& extra) {
    const Look look = lookOf(extra, 0);
    if (look == Look::Unclear) return cannotTell(6, tripleText(0));
    return NamedColumns{namesOf(look), reasonOf(look, 0)};
}

/// Colors with an intensity before or after them, if only one of the two is possible.
Result<NamedColumns> recognizeSeven(const ExtraColumns& extra) {
    const Look early = lookOf(extra, 0);
    const Look late = lookOf(extra, 1);
    const auto isStrong = [](Look look) { return isColorful(look) || look == Look::Normals; };
    if (isColorful(early) && !isStrong(late)) {
        return NamedColumns{{"red", "green", "blue", "intensity"},
                            reasonOf(early, 0) + ", column 7 is read as intensity"};
    }
    if (isColorful(late) && !isStrong(early)) {
        return NamedColumns{{"intensity", "red", "green", "blue"},
                            reasonOf(late, 1) + ", column 4 is read as intensity"};
    }
    return cannotTell(7, "columns 4 to 7");
}

/// Colors and normals, in the one order or the other.
Result<NamedColumns> recognizeNine(const ExtraColumns& extra) {
    const Look early = lookOf(extra, 0);
    const Look late = lookOf(extra, 3);
    const bool plain =
        (isColorful(early) && isNormal(late)) || (isNormal(early) && isColorful(late));
    if (!plain) return cannotTell(9, tripleText(0) + " and " + tripleText(3));
    std::vector<std::string> names = namesOf(early);
    for (std::string& name : namesOf(late)) names.push_back(std::move(name));
    return NamedColumns{std::move(names), reasonOf(early, 0) + ", " + reasonOf(late, 3)};
}

std::string usualName(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 20> kNames{{
        {"x", "x"},         {"y", "y"},        {"z", "z"},         {"nx", "nx"},
        {"ny", "ny"},       {"nz", "nz"},      {"normal_x", "nx"}, {"normal_y", "ny"},
        {"normal_z", "nz"}, {"normalx", "nx"}, {"normaly", "ny"},  {"normalz", "nz"},
        {"r", "red"},       {"g", "green"},    {"b", "blue"},      {"red", "red"},
        {"green", "green"}, {"blue", "blue"},  {"i", "intensity"}, {"intensity", "intensity"},
    }};
    const std::string lower = lowerCase(word);
    for (const auto& [known, usual] : kNames) {
        if (known == lower) return std::string(usual);
    }
    return std::string(word);
}

bool isPrintable(std::string_view word) {
    return std::none_of(word.begin(), word.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x20 || code == 0x7f;
    });
}

}  // namespace

std::vector<std::string> columnNamesIn(std::string_view comment) {
    std::vector<std::string> names;
    Fields words(comment, ',', ';');
    for (auto word = words.next(); !word.empty(); word = words.next()) {
        if (!isPrintable(word)) return {};
        names.push_back(usualName(word));
    }
    for (const char* axis : {"x", "y", "z"}) {
        if (std::count(names.begin(), names.end(), axis) != 1) return {};
    }
    std::vector<std::string> sorted = names;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return {};
    return names;
}

bool isRecognizable(std::size_t columns) {
    constexpr std::array<std::size_t, 5> kCounts{3, 4, 6, 7, 9};
    return std::find(kCounts.begin(), kCounts.end(), columns) != kCounts.end();
}

Result<NamedColumns> recognizeColumns(const ExtraColumns& extra) {
    assert(isRecognizable(3 + extra.width()) && (extra.width() == 0 || !extra.values.empty()));
    switch (extra.width()) {
        case 1:
            return NamedColumns{{"intensity"}, "column 4 is read as intensity"};
        case 3:
            return recognizeSix(extra);
        case 4:
            return recognizeSeven(extra);
        case 6:
            return recognizeNine(extra);
        default:
            return NamedColumns{};
    }
}

bool holdsBytes(const ExtraColumns& extra, std::size_t column) {
    bool fits = true;
    for (std::size_t at = column; fits && at < extra.values.size(); at += extra.width()) {
        const double value = extra.values[at];
        fits = value >= 0.0 && value <= kHighestColor && value == std::floor(value);
    }
    return fits;
}

}  // namespace se::io
