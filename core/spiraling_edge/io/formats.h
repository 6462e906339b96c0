/// The formats in the tables of read_points.cpp and write_mesh.cpp, one function each. A reader
/// takes the whole file (without a byte order mark) and its name for errors; a writer expects input
/// that passes checkWritable().
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/read_points.h"

namespace se::io {

// ---- names of columns ---------------------------------------------------------------------------

/// The row that `fits` of this name, which is in lower case; if there is none, one whose name
/// differs only in case. Null if there is none of these.
template <typename Rows, typename Fits>
auto findInAnyCase(const Rows& rows, std::string_view name, const Fits& fits)
    -> decltype(&*std::begin(rows)) {
    const auto* exact =
        rowWhere(rows, [&](const auto& row) { return row.name == name && fits(row); });
    if (exact != nullptr) return exact;
    return rowWhere(rows,
                    [&](const auto& row) { return lowerCase(row.name) == name && fits(row); });
}

using VectorNames = std::array<const char*, 3>;

/// Of two triples of names the first one that is there: as they are written, else in any case.
/// `find` returns the row of a name, or null. The second one if neither is there.
template <typename Find>
const VectorNames& namesThere(const VectorNames& first, const VectorNames& second,
                              const Find& find) {
    const auto exactly = [&](const char* name) {
        const auto* row = find(name);
        return row != nullptr && row->name == name;
    };
    const auto anyCase = [&](const char* name) { return find(name) != nullptr; };
    if (std::all_of(first.begin(), first.end(), exactly)) return first;
    if (std::all_of(second.begin(), second.end(), exactly)) return second;
    return std::all_of(first.begin(), first.end(), anyCase) ? first : second;
}

// ---- readers ------------------------------------------------------------------------------------

/// The clues to the format of a file.
struct FileStart {
    std::string_view bytes;  ///< All bytes, without a byte order mark.
    std::string_view line;   ///< The first line outside of comments.
    std::string_view word;   ///< The first word of it.
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

bool isStl(const FileStart& start);
/// Corners at the same place are one point, with the mean of the normals of its triangles.
Result<PointFile> readStl(std::string_view bytes, const std::string& name);

bool isLas(const FileStart& start);
/// Versions 1.0 to 1.4, not packed: positions, intensity, classification and colors.
Result<PointFile> readLas(std::string_view bytes, const std::string& name);

bool isPtx(const FileStart& start);
/// All scans of the file, each by its matrix; places without a return are not numbers.
Result<PointFile> readPtx(std::string_view text, const std::string& name);

bool isGlb(const FileStart& start);
/// Triangles and points of the scene, each mesh where its nodes place it. Vertices of triangles at
/// the same place are one point, with the mean of their normals.
Result<PointFile> readGlb(std::string_view bytes, const std::string& name);

bool isPcd(const FileStart& start);
/// Version 0.7 and earlier; packed colors become red, green and blue.
Result<PointFile> readPcd(std::string_view bytes, const std::string& name);

/// Adds the columns red, green and blue: value(p, channel), from 0 to 255.
template <typename Value>
void addColorColumns(PointFile& file, Value&& value) {
    const char* const names[] = {"red", "green", "blue"};
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> values(file.position.size());
        for (std::size_t p = 0; p < values.size(); ++p) values[p] = value(p, channel);
        file.attributes.push_back({names[channel], ScalarType::UInt8, std::move(values)});
    }
}

/// Colors of points in formats that do not say their scale: fractions of 1, or whole numbers up to
/// 255.
class PointColors {
  public:
    /// The color of the next point.
    void add(const Vec3& color) { colors_.push_back(color); }
    /// Takes the color of the next point from three fields; of a missing one nothing is kept.
    void add(Fields& fields);
    /// Notes that colors have a fourth number.
    void leaveOutAlpha() { hasAlpha_ = true; }
    bool empty() const { return colors_.empty(); }
    /// Adds the columns red, green and blue to `file`, from 0 to 255, if every point has a color;
    /// otherwise a note if some have one.
    void take(PointFile& file) const;

  private:
    std::vector<Vec3> colors_;
    bool hasAlpha_ = false;
};

/// Reads all of `field` as a whole number from 0 to `most`.
inline bool parseCount(std::string_view field, std::uint64_t& count,
                       std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
    std::int64_t number = 0;
    if (!parseInteger(field, number) || number < 0 || number > most) return false;
    count = static_cast<std::uint64_t>(number);
    return true;
}

/// Reads the next three fields as numbers.
inline bool parseVector(Fields& fields, Vec3& vector) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!parseDouble(fields.next(), vector[axis])) return false;
    }
    return true;
}

/// Sets `value` to the enumerator whose name is `word`, of all names in order.
template <typename Names, typename Enum>
bool parseName(const Names& names, std::string_view word, Enum& value) {
    const auto found = idNamed<Enum>(names, word);
    if (found) value = *found;
    return found.has_value();
}

/// The problem of a file. A member of a reader that returns false has set it.
class FirstProblem {
  public:
    explicit FirstProblem(const std::string& name) : name_(name) {}

  protected:
    bool failAt(const std::string& place, const std::string& what) {
        problem_ = errorAt(name_, place, what);
        return false;
    }
    bool fail(std::size_t byte, const std::string& what) { return failAt(byteText(byte), what); }
    bool failCut(const std::string& place, std::uint64_t found, std::uint64_t announced,
                 const std::string& things) {
        return failAt(place, "the file ends after " + std::to_string(found) + " of " +
                                 std::to_string(announced) + " " + things +
                                 "; it is cut short, or its header announces too many");
    }

    const std::string& name_;
    Error problem_;
};

/// The common part of readers that go through a file line by line.
class LineByLine : protected FirstProblem {
  public:
    LineByLine(std::string_view text, const std::string& name) : FirstProblem(name), lines_(text) {}

  protected:
    bool failIn(std::size_t line, const std::string& what) { return failAt(lineText(line), what); }
    bool fail(const std::string& what) { return failIn(lines_.number(), what); }
    bool readVector(Fields& fields, Vec3& vector) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view field = fields.next();
            if (parseDouble(field, vector[axis])) continue;
            return fail("expected three numbers, found " + inQuotes(field) + "; correct the line");
        }
        return true;
    }

    LineReader lines_;
};

// ---- writers ------------------------------------------------------------------------------------

/// Points, normals where there are any, triangles; numbers that read back exactly.
std::string objBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Plain OFF, which every program reads: no normals.
std::string offBytes(const PointFile& points, std::span<const Triangle> triangles);
/// NOFF, with the normals; plain OFF where the points have none.
std::string noffBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary: three corners per triangle, as float, relative to floatShift(), which the header names.
std::string stlBytes(const PointFile& points, std::span<const Triangle> triangles);
/// Binary glTF 2.0. Positions are floats relative to the center of the box, which is the
/// translation of the node, so that a set far from the origin keeps its shape.
std::string glbBytes(const PointFile& points, std::span<const Triangle> triangles);

/// An origin with few digits near the center of the triangles, for positions written as float
/// relative to it. Empty where no corner moves by more than a thousandth of the mean edge without
/// it, or where it would not help.
std::optional<Vec3> floatShift(const PointFile& points, std::span<const Triangle> triangles);

/// Fails for input whose file could not be read back: columns of different length, a triangle that
/// names a nonexistent point.
Status checkWritable(const PointFile& points, std::span<const Triangle> triangles);

}  // namespace se::io
