// OFF: keyword, counts, one line per point, one line per face.
#include "spiraling_edge/io/formats.h"

namespace se::io {
namespace {

/// OFF with any of the prefixes C, N, ST.
bool isOffKeyword(std::string_view word) {
    if (!word.ends_with("OFF")) return false;
    word.remove_suffix(3);
    if (word.starts_with("ST")) word.remove_prefix(2);
    if (word.starts_with("C")) word.remove_prefix(1);
    if (word.starts_with("N")) word.remove_prefix(1);
    return word.empty();
}

/// Reads OFF line by line: keyword, counts, one line per point, one line per face.
class OffReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        file_.positionType = file_.normalType = ScalarType::Double;
        if (!readHeader() || !readPoints() || !readFaces()) return problem_;
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
            field.remove_suffix(3);
            hasNormals_ = field.find('N') != std::string_view::npos;
            mayHaveMore_ = field.find_first_of("CS") != std::string_view::npos;
            field = fields.next();
            if (field.empty()) {
                if (!lines_.nextContent('#')) return failCut("counts", 0, 3);
                fields = Fields(lines_.line());
                field = fields.next();
            }
        }
        if (field == "BINARY") return fail("binary OFF cannot be read; save it as text or as PLY");
        return readCount(field, points_) && readCount(fields.next(), faces_);
    }

    bool readCount(std::string_view field, std::uint64_t& count) {
        return parseCount(field, count, kNone - 1) ||
               fail("expected the numbers of points, faces and edges, found " + inQuotes(field));
    }

    bool readNumber(Fields& fields, double& value) {
        const std::string_view field = fields.next();
        if (parseDouble(field, value)) return true;
        return fail(std::string("expected ") + (hasNormals_ ? "six" : "three") +
                    " numbers per point, found " + inQuotes(field));
    }

    bool readPoints() {
        for (std::uint64_t i = 0; i < points_; ++i) {
            if (!lines_.nextContent('#')) return failCut("points", i, points_);
            Fields fields(lines_.line());
            double n[6] = {};
            for (int column = 0; column < (hasNormals_ ? 6 : 3); ++column) {
                if (!readNumber(fields, n[column])) return false;
            }
            if (!mayHaveMore_ && !fields.next().empty()) {
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
        std::vector<Index> polygon;
        for (std::uint64_t i = 0; i < faces_; ++i) {
            if (!lines_.nextContent('#')) return failCut("faces", i, faces_);
            Fields fields(lines_.line());
            std::uint64_t corners = 0;
            const std::string_view field = fields.next();
            if (!parseCount(field, corners)) {
                return fail("expected the number of corners of a face, found " + inQuotes(field));
            }
            polygon.clear();
            for (std::uint64_t corner = 0; corner < corners; ++corner) {
                if (!readCorner(fields.next(), polygon)) return false;
            }
            appendFan(polygon, file_.faces);
        }
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
    bool mayHaveMore_ = false;  // colors (C) or texture coordinates (ST), which are ignored
};

}  // namespace

Result<PointFile> readOff(std::string_view text, const std::string& name) {
    return OffReader(text, name).read();
}

// OFF may begin with its counts, which only the extension distinguishes from a point.
bool isOff(const FileStart& start) {
    double number = 0.0;
    return isOffKeyword(start.word) ||
           (start.extension == ".off" && parseDouble(start.word, number));
}

}  // namespace se::io
