// OBJ: `v` with colors, `vn`, `f`, and the colors that ZBrush writes in comments; other statements
// are left out, and named.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/polygons.h"
#include "spiraling_edge/points/usable_points.h"

namespace se::io {
namespace {

/// Reads OBJ statement by statement; a backslash at the end of a line continues one.
class ObjReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        file_.positionType = file_.normalType = ScalarType::Double;
        while (lines_.next()) {
            if (lines_.line().starts_with(kPainted))
                readPainted(lines_.line().substr(kPainted.size()));
            Fields fields(statement());
            const std::string_view keyword = fields.next();
            if (!keyword.empty() && !readStatement(keyword, fields)) return problem_;
        }
        if (file_.position.empty())
            return Error{name_ + ": holds no points (lines that begin with v)"};
        if (!checkReferences()) return problem_;
        polygons_.cutConcave(file_.position, file_.faces);
        takeNormals();
        (colors_.empty() ? painted_ : colors_).take(file_);
        noteLeftOut();
        return std::move(file_);
    }

  private:
    /// The highest reference to a kind of element, to be checked against the whole file, with its
    /// line.
    struct Highest {
        std::int64_t index = -1;
        std::size_t line = 0;
    };

    /// The line, with those that continue it.
    std::string_view statement() {
        const auto isContinued = [](std::string_view line) {
            while (!line.empty() && isSpace(line.back())) line.remove_suffix(1);
            return line.ends_with('\\');
        };
        // A path of Windows in another statement may end so as well.
        const std::string_view keyword = Fields(lines_.line()).next();
        const bool isRead = keyword == "v" || keyword == "vn" || keyword == "f";
        if (!isRead || !isContinued(lines_.line())) return beforeComment(lines_.line(), '#');
        joined_.clear();
        bool more = true;
        while (more) {
            more = isContinued(lines_.line());
            const std::string_view line = beforeComment(lines_.line(), '#');
            joined_ += line.substr(0, more ? line.rfind('\\') : line.size());
            joined_ += ' ';
            more = more && lines_.next();
        }
        return joined_;
    }

    bool readStatement(std::string_view keyword, Fields& fields) {
        if (keyword == "v") return readPoint(fields);
        if (keyword == "vn") return readVector(fields, normals_.emplace_back());
        if (keyword == "f") return readFace(fields);
        leftOut_.insert(keyword);
        return true;
    }

    /// Names the statements that were not read: in words, or else themselves, as far as they are
    /// words.
    void noteLeftOut() {
        for (const auto& [keyword, text] : kLeftOut) {
            if (leftOut_.erase(keyword) > 0)
                file_.notes.push_back(std::string("left out: ") + text);
        }
        constexpr std::size_t kLongest = 12;
        const auto isWord = [](std::string_view keyword) {
            return keyword.size() <= kLongest &&
                   std::all_of(keyword.begin(), keyword.end(), [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
                   });
        };
        std::vector<std::string> words;
        for (const std::string_view keyword : leftOut_) {
            if (isWord(keyword)) words.emplace_back(keyword);
        }
        if (words.size() < leftOut_.size()) words.emplace_back("others");
        if (!words.empty()) file_.notes.push_back("left out: statements " + wordList(words, "and"));
    }

    /// Colors of points in order, of ZBrush: eight hexadecimal digits each, a mask and the color.
    void readPainted(std::string_view digits) {
        constexpr std::size_t kDigits = 8;
        for (; digits.size() >= kDigits; digits.remove_prefix(kDigits)) {
            std::uint32_t number = 0;
            const char* const end = digits.data() + kDigits;
            if (std::from_chars(digits.data(), end, number, 16).ptr != end) return;
            painted_.add(Vec3(number >> 16U & 255U, number >> 8U & 255U, number & 255U) / 255.0);
        }
    }

    /// A color may follow the position; a weight is read over, unless it is 1.
    bool readPoint(Fields& fields) {
        if (!readVector(fields, file_.position.emplace_back())) return false;
        Vec3 color{0.0};
        int more = 0;
        for (auto field = fields.next(); !field.empty(); field = fields.next(), ++more) {
            double number = 0.0;
            if (!parseDouble(field, number)) {
                return fail("expected a color of three numbers after the position, found " +
                            inQuotes(field) + "; correct the line");
            }
            if (more < 3) color[more] = number;
        }
        if (more >= 3) colors_.add(color);
        if (more == 4) colors_.leaveOutAlpha();
        if (more == 1 && color[0] != 1.0) leftOut_.insert("w");
        return true;
    }

    /// A reference counts from 1, or back from the last element read so far if it is negative.
    bool readReference(std::string_view field, std::size_t soFar, Highest& highest,
                       std::int64_t& index) {
        std::int64_t number = 0;
        if (!parseInteger(field, number) || number == 0 || number > std::int64_t{kNone} ||
            number < -static_cast<std::int64_t>(soFar)) {
            return fail(
                "expected a reference such as 7, 7//7 or -1 to something in the file, found " +
                inQuotes(field) + "; correct the line");
        }
        index = number > 0 ? number - 1 : static_cast<std::int64_t>(soFar) + number;
        if (index > highest.index) highest = {index, lines_.number()};
        return true;
    }

    /// One corner: v, v/vt, v//vn or v/vt/vn; some programs leave the last slashes.
    bool readCorner(std::string_view field) {
        const std::size_t slash = field.find('/');
        std::int64_t vertex = 0;
        if (!readReference(field.substr(0, slash), file_.position.size(), highestVertex_, vertex)) {
            return false;
        }
        polygon_.push_back(static_cast<Index>(vertex));
        const std::size_t second =
            slash == std::string_view::npos ? slash : field.find('/', slash + 1);
        if (second == std::string_view::npos || second + 1 == field.size()) return true;
        std::int64_t normal = 0;
        if (!readReference(field.substr(second + 1), normals_.size(), highestNormal_, normal)) {
            return false;
        }
        normalReferences_.push_back({polygon_.back(), static_cast<Index>(normal)});
        return true;
    }

    bool readFace(Fields& fields) {
        polygon_.clear();
        for (auto field = fields.next(); !field.empty(); field = fields.next()) {
            if (!readCorner(field)) return false;
        }
        if (polygon_.size() < 3) {
            return fail("expected a face with three corners or more, found " +
                        std::to_string(polygon_.size()) + "; correct or remove the line");
        }
        polygons_.append(polygon_, file_.faces);
        return true;
    }

    /// Faces may precede the elements that they refer to, so the check is made at the end.
    bool checkReferences() {
        const auto check = [this](const Highest& highest, std::size_t count, const char* things) {
            if (highest.index < static_cast<std::int64_t>(count)) return true;
            return failIn(highest.line, "refers to number " + std::to_string(highest.index + 1) +
                                            " of " + std::to_string(count) + " " + things +
                                            "; the file is cut short or damaged");
        };
        return check(highestVertex_, file_.position.size(), "vertices") &&
               check(highestNormal_, normals_.size(), "normals");
    }

    /// Takes for each point the mean direction of the different normals that faces assign to it, at
    /// a hard edge one for each of its sides, or the only one as it is; if some point has none, the
    /// normals in their order, provided there are as many as points and faces do not assign them in
    /// another; else no normals.
    void takeNormals() {
        std::vector<std::vector<Vec3>> directions(file_.position.size());
        std::vector<Index> only(file_.position.size(), kNone);
        for (const auto& [vertex, normal] : normalReferences_) {
            if (only[vertex] == kNone) only[vertex] = normal;
            addDirection(directions[vertex], normals_[normal]);
        }
        if (!isAmong(kNone, only)) {
            std::size_t averaged = 0;
            for (Index p = 0; p < only.size(); ++p) {
                const bool several = directions[p].size() > 1;
                file_.normal.push_back(several ? meanOfDirections(directions[p], averaged)
                                               : normals_[only[p]]);
            }
            if (averaged > 0) file_.notes.push_back(averagedText(averaged));
        } else if (normals_.size() == file_.position.size() &&
                   std::all_of(normalReferences_.begin(), normalReferences_.end(),
                               [](const auto& each) { return each.vertex == each.normal; })) {
            file_.normal = std::move(normals_);
        } else if (!normals_.empty()) {
            file_.notes.emplace_back("left out: normals, which not every point has");
        }
    }

    struct NormalReference {
        Index vertex;
        Index normal;
    };

    /// Statements that points and triangles do without, and their words.
    static constexpr std::array<std::pair<std::string_view, const char*>, 6> kLeftOut{{
        {"vt", "texture coordinates"},
        {"mtllib", "materials"},
        {"l", "lines"},
        {"p", "lists of points"},
        {"cstype", "free-form surfaces"},
        {"w", "weights of points"},
    }};
    static constexpr std::string_view kPainted = "#MRGB ";

    PointFile file_;
    PointColors colors_;
    PointColors painted_;
    std::set<std::string_view> leftOut_;
    std::string joined_;
    std::vector<Vec3> normals_;
    std::vector<NormalReference> normalReferences_;
    Polygons polygons_;
    std::vector<Index> polygon_;
    Highest highestVertex_;
    Highest highestNormal_;
};

}  // namespace

bool isObj(const FileStart& start) {
    constexpr std::array<std::string_view, 14> kKeywords{
        "v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl", "mg", "cstype"};
    return isAmong(start.word, kKeywords);
}

Result<PointFile> readObj(std::string_view text, const std::string& name) {
    return ObjReader(text, name).read();
}

}  // namespace se::io
