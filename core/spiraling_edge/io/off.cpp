// OFF: keyword, counts, one line per point, one line per face.
#include <array>
#include <string>

#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/polygons.h"

namespace se::io {
namespace {

/// A word without the digits at its end: some programs glue the first count to the keyword.
std::string_view withoutCount(std::string_view word) {
    while (!word.empty() && word.back() >= '0' && word.back() <= '9') word.remove_suffix(1);
    return word;
}

/// OFF with any of the prefixes C, N, ST, in any order; also in lower case, alone.
bool isOffKeyword(std::string_view word) {
    word = withoutCount(word);
    if (word == "off") return true;
    if (!word.ends_with("OFF")) return false;
    std::string prefix(word.substr(0, word.size() - 3));
    for (const std::string_view part : {"ST", "C", "N"}) {
        const std::size_t at = prefix.find(part);
        if (at != std::string::npos) prefix.erase(at, part.size());
    }
    return prefix.empty();
}

/// OFF of another kind: 4OFF and nOFF have points in more dimensions; noff may be NOFF or nOFF.
bool isOtherOff(std::string_view word) {
    const std::string lower = lowerCase(withoutCount(word));
    return lower.ends_with("off") && !isOffKeyword(word) &&
           lower.find_first_not_of("stcn4") == lower.size() - 3;
}

/// Reads OFF line by line: keyword, counts, one line per point, one line per face.
class OffReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        file_.positionType = file_.normalType = ScalarType::Double;
        if (!readHeader() || !readPoints() || !readFaces()) return problem_;
        colors_.take(file_);
        if (hasTexture_) file_.notes.push_back("left out: texture coordinates");
        if (hasFaceColors_) file_.notes.push_back("left out: colors of faces");
        if (lines_.nextContent('#')) {
            fail("the file goes on after the " + std::to_string(points_) + " points and " +
                 std::to_string(faces_) + " faces that it announces; correct the counts");
            return problem_;
        }
        return std::move(file_);
    }

  private:
    bool failCut(const char* things, std::uint64_t found, std::uint64_t announced) {
        return fail("the file ends after " + std::to_string(found) + " of " +
                    std::to_string(announced) + " " + things +
                    "; it is cut short, or the counts in its header are wrong");
    }

    /// `OFF`, then `points faces edges` on the same or the next line with content.
    bool readHeader() {
        if (!lines_.nextContent('#')) return fail("the file holds no header");
        Fields fields(lines_.line());
        std::string_view field = fields.next();
        if (isOffKeyword(field)) {
            const std::string_view keyword = withoutCount(field);
            const std::string_view prefix = keyword.substr(0, keyword.size() - 3);
            hasNormals_ = prefix.find('N') != std::string_view::npos;
            hasColors_ = prefix.find('C') != std::string_view::npos;
            hasTexture_ = prefix.find('S') != std::string_view::npos;
            colorFirst_ = hasColors_ && prefix.find('N') < prefix.find('C');
            const std::string_view glued = field.substr(keyword.size());
            field = glued.empty() ? fields.next() : glued;
            if (field.empty()) {
                if (!lines_.nextContent('#')) return failCut("counts", 0, 3);
                fields = Fields(lines_.line());
                field = fields.next();
            }
        }
        if (isOtherOff(field)) {
            return fail("OFF of the kind " + inQuotes(field) +
                        " cannot be read, only with C, N and ST; save it so, or as PLY");
        }
        if (field == "BINARY") return fail("binary OFF cannot be read; save it as text or as PLY");
        return readCount(field, points_) && readCount(fields.next(), faces_);
    }

    bool readCount(std::string_view field, std::uint64_t& count) {
        return parseCount(field, count, kNone - 1) ||
               fail("expected the numbers of points, faces and edges, found " + inQuotes(field));
    }

    /// The next field of a row, which may go on in the lines after it: then it ends with the last
    /// of them, and no color follows.
    std::string_view nextOf(Fields& fields) {
        const std::string_view field = fields.next();
        if (!field.empty() || hasColors_ || hasTexture_ || !lines_.nextContent('#')) return field;
        fields = Fields(lines_.line());
        goesOn_ = true;
        return fields.next();
    }
    /// Begins a row in the next line.
    bool beginRow(Fields& fields) {
        goesOn_ = false;
        if (!lines_.nextContent('#')) return false;
        firstLine_ = lines_.number();
        fields = Fields(lines_.line());
        return true;
    }
    bool endRow(Fields& fields, const char* things) {
        return !goesOn_ || fields.next().empty() ||
               failIn(firstLine_, std::string("expected more numbers for ") + things +
                                      ", found the end of the line");
    }

    bool readNumber(Fields& fields, double& value) {
        const std::string_view field = nextOf(fields);
        if (parseDouble(field, value)) return true;
        return fail(std::string("expected ") + (hasNormals_ ? "six" : "three") +
                    " numbers per point, found " + inQuotes(field));
    }

    /// The color before the normal, as MeshLab writes it after the keyword NCOFF.
    bool readBytes(Fields& fields) {
        std::array<std::uint64_t, 4> bytes{};
        for (std::uint64_t& byte : bytes) {
            if (parseCount(fields.next(), byte, 255)) continue;
            return fail(
                "expected a color of four whole numbers up to 255 before the normal, as MeshLab "
                "writes NCOFF; the keyword for normals before colors is CNOFF");
        }
        colors_.add(Vec3(bytes[0], bytes[1], bytes[2]));
        colors_.leaveOutAlpha();
        return true;
    }

    bool readPoints() {
        for (std::uint64_t i = 0; i < points_; ++i) {
            Fields fields({});
            if (!beginRow(fields)) return failCut("points", i, points_);
            double n[6] = {};
            for (int column = 0; column < (hasNormals_ ? 6 : 3); ++column) {
                if (colorFirst_ && column == 3 && !readBytes(fields)) return false;
                if (!readNumber(fields, n[column])) return false;
            }
            if (!endRow(fields, "the point")) return false;
            if (hasColors_ && !colorFirst_) {
                colors_.add(fields);
            } else if (!hasTexture_ && !fields.next().empty()) {
                return fail(
                    "the line holds more numbers than its kind of OFF has; colors need the "
                    "keyword COFF, normals NOFF");
            }
            file_.position.emplace_back(n[0], n[1], n[2]);
            if (hasNormals_) file_.normal.emplace_back(n[3], n[4], n[5]);
        }
        return true;
    }

    /// `n`, then n point numbers from 0; a color may follow.
    bool readFaces() {
        Polygons polygons;
        std::vector<Index> polygon;
        for (std::uint64_t i = 0; i < faces_; ++i) {
            Fields fields({});
            if (!beginRow(fields)) return failCut("faces", i, faces_);
            std::uint64_t corners = 0;
            const std::string_view field = fields.next();
            if (!parseCount(field, corners)) {
                return fail("expected the number of corners of a face, found " + inQuotes(field));
            }
            polygon.clear();
            for (std::uint64_t corner = 0; corner < corners; ++corner) {
                if (!readCorner(nextOf(fields), polygon)) return false;
            }
            if (!endRow(fields, "the face")) return false;
            hasFaceColors_ = hasFaceColors_ || (!goesOn_ && !fields.next().empty());
            polygons.append(polygon, file_.faces);
        }
        polygons.cutConcave(file_.position, file_.faces);
        return true;
    }

    bool readCorner(std::string_view field, std::vector<Index>& polygon) {
        std::uint64_t number = 0;
        if (!parseCount(field, number, static_cast<std::int64_t>(points_) - 1)) {
            return fail("expected a point number from 0 to below " + std::to_string(points_) +
                        ", found " + inQuotes(field));
        }
        polygon.push_back(static_cast<Index>(number));
        return true;
    }

    PointFile file_;
    std::uint64_t points_ = 0;
    std::uint64_t faces_ = 0;
    bool hasNormals_ = false;
    bool hasColors_ = false;
    bool hasTexture_ = false;
    bool colorFirst_ = false;  // Before the normal.
    bool hasFaceColors_ = false;
    bool goesOn_ = false;        // The row goes on in a line after its first.
    std::size_t firstLine_ = 0;  // Of the row.
    PointColors colors_;
};

}  // namespace

Result<PointFile> readOff(std::string_view text, const std::string& name) {
    return OffReader(text, name).read();
}

// OFF may begin with its counts, which only the extension distinguishes from a point.
bool isOff(const FileStart& start) {
    double number = 0.0;
    return isOffKeyword(start.word) || isOtherOff(start.word) ||
           (start.extension == ".off" && parseDouble(start.word, number));
}

}  // namespace se::io
