// STL, text and binary: triangles with corners of their own. Corners at the same place are one
// point.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/merged_points.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

constexpr std::size_t kHeader = 84;  ///< 80 bytes of any text, and the number of triangles.
constexpr std::size_t kTriangle = 50;

/// Points and triangles, gathered triangle by triangle.
class Soup {
  public:
    /// `normal` may be zero, as many programs write it: then it is that of the winding.
    void add(const std::array<Vec3, 3>& corners, Vec3 normal) {
        if (!hasDirection(normal))
            normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        std::array<Index, 3> numbers{};
        for (std::size_t i = 0; i < 3; ++i) numbers[i] = points_.add(corners[i], normal);
        const auto [a, b, c] = numbers;
        if (a != b && b != c && c != a) file_.faces.push_back({a, b, c});
    }

    PointFile take(ScalarType type) {
        file_.positionType = file_.normalType = type;
        const std::span<const std::vector<Vec3>> directions = points_.directions();
        const bool all = std::none_of(directions.begin(), directions.end(),
                                      [](const auto& each) { return each.empty(); });
        for (std::size_t p = 0; all && p < directions.size(); ++p)
            file_.normal.push_back(meanOfDirections(directions[p]));
        file_.position = points_.takePositions();
        file_.notes.emplace_back(
            all ? "corners at one place are one point, with the mean of their normals"
                : "corners at one place are one point; some have no normal, so all are left out");
        return std::move(file_);
    }
    bool empty() const { return points_.size() == 0; }

  private:
    PointFile file_;
    MergedPoints points_;
};

std::size_t announced(std::string_view bytes) {
    return loadScalar<std::uint32_t>(bytes.data() + 80, kLittleIsSwapped);
}

/// The shift that this library writes into the header (stlBytes()).
std::optional<Vec3> shiftIn(std::string_view header) {
    constexpr std::string_view kAdd = "; add ";
    const std::size_t at = header.find(kAdd);
    if (!header.starts_with("written by spiraling-edge") || at == std::string_view::npos) return {};
    header = header.substr(at + kAdd.size());
    Fields fields(header.substr(0, header.find('\0')));
    Vec3 shift{};
    if (!parseVector(fields, shift) || !isFinite(shift)) return {};
    return shift;
}

Result<PointFile> readBinary(std::string_view bytes, const std::string& name) {
    if (bytes.size() < kHeader) {
        return errorAt(name, byteText(bytes.size()),
                       "the file ends within its header of 84 bytes; it is cut short");
    }
    const std::size_t room = (bytes.size() - kHeader) / kTriangle;
    const std::size_t count = announced(bytes);
    if (count != room || kHeader + room * kTriangle != bytes.size()) {
        return errorAt(name, byteText(bytes.size()),
                       "the header announces " + std::to_string(count) +
                           " triangles, and there is room for " + std::to_string(room) +
                           "; the file is cut short or damaged");
    }
    const std::optional<Vec3> shift = shiftIn(bytes.substr(0, 80));
    Soup soup;
    bool hasAttributes = false;  // Of two bytes, in which some programs write a color.
    for (std::size_t t = 0; t < count; ++t) {
        const char* at = bytes.data() + kHeader + t * kTriangle;
        std::array<Vec3, 4> vectors{};
        for (Vec3& vector : vectors) {
            for (int axis = 0; axis < 3; ++axis, at += 4)
                vector[axis] = loadScalar<float>(at, kLittleIsSwapped);
        }
        if (shift) {
            for (std::size_t corner = 1; corner < 4; ++corner) vectors[corner] += *shift;
        }
        soup.add({vectors[1], vectors[2], vectors[3]}, vectors[0]);
        hasAttributes = hasAttributes || at[0] != 0 || at[1] != 0;
    }
    if (soup.empty()) return Error{name + ": holds no triangles"};
    PointFile file = soup.take(shift ? ScalarType::Double : ScalarType::Float);
    if (shift) file.notes.emplace_back("the shift that the header names is added");
    if (hasAttributes) file.notes.emplace_back("left out: colors or other attributes of triangles");
    return file;
}

class TextReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        while (lines_.nextContent()) {
            if (!readLine()) return problem_;
        }
        if (!ended_ && !fail("the file ends without endsolid; it is cut short")) return problem_;
        if (soup_.empty()) return Error{name_ + ": holds no triangles"};
        return soup_.take(ScalarType::Double);
    }

  private:
    /// Several keywords may stand in a line, but after other words, such as a name, they are none.
    bool readLine() {
        constexpr std::array<std::string_view, 6> kKeywords{"facet",   "outer",    "vertex",
                                                            "endloop", "endfacet", "endsolid"};
        Fields fields(lines_.line());
        std::string word = lowerCase(fields.next());
        ended_ = false;
        if (!isAmong(word, kKeywords)) return true;
        for (; !word.empty() && !ended_; word = lowerCase(fields.next())) {
            if (!readWord(word, fields)) return false;
        }
        return true;
    }

    bool readWord(std::string_view word, Fields& fields) {
        ended_ = word == "endsolid";
        if ((word == "facet" || ended_) && !corners_.empty())
            return fail("the triangle before this line has no endfacet; correct it");
        if (word == "facet") {
            fields.next();  // "normal"
            return readVector(fields, normal_);
        }
        if (word == "vertex") return readVector(fields, corners_.emplace_back());
        if (word != "endfacet") return true;
        if (corners_.size() != 3) {
            return fail("expected a triangle of three corners, found " +
                        std::to_string(corners_.size()) + "; correct the lines before");
        }
        soup_.add({corners_[0], corners_[1], corners_[2]}, normal_);
        corners_.clear();
        return true;
    }

    Soup soup_;
    Vec3 normal_{0.0};
    std::vector<Vec3> corners_;
    bool ended_ = false;
};

/// Binary files may begin with "solid" as well.
bool isBinary(std::string_view bytes) {
    return bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * announced(bytes);
}

/// True for text, whose keywords may be in capitals.
bool isText(std::string_view bytes) {
    constexpr std::size_t kLooked = 2000;
    LineReader lines(bytes);
    if (isBinary(bytes) || !lines.nextContent('#')) return false;
    const std::string_view line = lines.line();
    const auto at = static_cast<std::size_t>(line.data() - bytes.data());
    return lowerCase(Fields(line).next()) == "solid" &&
           lowerCase(bytes.substr(at, line.size() + kLooked)).find("facet") != std::string::npos;
}

}  // namespace

bool isStl(const FileStart& start) {
    if (isBinary(start.bytes) || isText(start.bytes)) return true;
    return start.extension == ".stl" && start.bytes.size() >= kHeader;
}

Result<PointFile> readStl(std::string_view bytes, const std::string& name) {
    return isText(bytes) ? TextReader(bytes, name).read() : readBinary(bytes, name);
}

}  // namespace se::io
