// PTX, the format of Leica Cyclone: scans one after the other, each with its numbers of columns and
// rows, the place and axes of the scanner, a 4 by 4 matrix, and one line per point.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

/// The most numbers of a line of the format: x y z, intensity and a color.
constexpr std::size_t kMostNumbers = 7;
/// More than the error of numbers that are whole but for rounding.
constexpr double kRounded = 1e-6;

/// The numbers of a line; none if a field is no number, or there are too many.
class LineNumbers {
  public:
    explicit LineNumbers(std::string_view line) {
        Fields fields(line);
        for (auto field = fields.next(); !field.empty(); field = fields.next()) {
            if (count_ < kMostNumbers && parseDouble(field, numbers_[count_++])) continue;
            count_ = 0;
            return;
        }
    }
    std::size_t size() const { return count_; }
    double operator[](std::size_t i) const { return numbers_[i]; }
    std::span<const double> after(std::size_t first) const {
        return {numbers_.data() + first, count_ - first};
    }

  private:
    std::array<double, kMostNumbers> numbers_{};
    std::size_t count_ = 0;
};

class PtxReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        file_.positionType = ScalarType::Double;
        while (lines_.nextContent()) {
            if (!readHeader() || !readRows()) return problem_;
            ++scans_;
        }
        if (scans_ == 1 && isFinite(scanner_)) file_.viewpoint = scanner_;
        file_.notes.push_back(std::to_string(scans_) + (scans_ == 1 ? " scan" : " scans") +
                              "; places without a return (0 0 0) are not numbers here");
        if (scans_ > 1) file_.notes.emplace_back("left out: the places of the scanners");
        if (!file_.position.empty()) addColumns();
        return std::move(file_);
    }

  private:
    bool readCount(std::uint64_t& count) {
        Fields fields(lines_.line());
        const std::string_view field = fields.next();
        return (parseCount(field, count, kNone - 1) && fields.next().empty()) ||
               fail("expected a number of columns or rows of a scan, found " +
                    inQuotes(lines_.line()) +
                    (scans_ > 0 ? "; the scan before has more points than its numbers say" : ""));
    }

    /// Reads a line of `count` numbers.
    bool readNumbers(std::size_t count, LineNumbers& numbers) {
        if (!lines_.nextContent()) return fail("the file ends within the header of a scan");
        numbers = LineNumbers(lines_.line());
        return numbers.size() == count ||
               fail("expected " + std::to_string(count) +
                    " numbers in the header of a scan, found " + inQuotes(lines_.line()));
    }

    /// After the line of columns: rows, place and three axes of the scanner, the matrix.
    bool readHeader() {
        std::uint64_t columns = 0;
        std::uint64_t rows = 0;
        if (!readCount(columns)) return false;
        if (!lines_.nextContent()) return fail("the file ends within the header of a scan");
        if (!readCount(rows)) return false;
        LineNumbers numbers({});
        for (int line = 0; line < 4; ++line) {
            if (!readNumbers(3, numbers)) return false;
            if (line == 0) scanner_ = Vec3(numbers[0], numbers[1], numbers[2]);
        }
        for (int row = 0; row < 4; ++row) {
            if (!readNumbers(4, numbers)) return false;
            for (int i = 0; i < 3; ++i)
                matrix_[static_cast<std::size_t>(row)][i] = numbers[static_cast<std::size_t>(i)];
            if (std::abs(numbers[3] - (row < 3 ? 0.0 : 1.0)) <= kRounded) continue;
            return fail(
                "expected 0 0 0 1 in the last column of the matrix, and what is added to each "
                "place in its last row; transpose the matrix, or export the scan again");
        }
        // At least "0 0 0 0" and a line end each, checked before the product is used.
        const std::uint64_t room = (lines_.rest().size() + 1) / 8;
        if (rows != 0 && columns > room / rows) {
            return fail("the file is too short for a scan of " + std::to_string(columns) + " by " +
                        std::to_string(rows) + " points; it is cut short");
        }
        points_ = columns * rows;
        return true;
    }

    bool readRows() {
        for (std::uint64_t i = 0; i < points_; ++i) {
            if (!lines_.nextContent()) {
                return fail("the file ends after " + std::to_string(i) + " of " +
                            std::to_string(points_) + " points of a scan; it is cut short");
            }
            const LineNumbers n(lines_.line());
            if (columns_ == 0 && (n.size() == 4 || n.size() == 7)) columns_ = n.size();
            if (columns_ == 0 || n.size() != columns_) {
                return fail(
                    "expected x y z and intensity, then a color in all lines or in none; "
                    "found " +
                    inQuotes(lines_.line()));
            }
            keep(n);
        }
        return true;
    }

    /// Row vectors: the place times the matrix.
    void keep(const LineNumbers& n) {
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        Vec3 place = n[0] * matrix_[0] + n[1] * matrix_[1] + n[2] * matrix_[2] + matrix_[3];
        if (n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0) place = Vec3(kNaN);
        file_.position.push_back(place);
        const std::span<const double> others = n.after(3);
        others_.insert(others_.end(), others.begin(), others.end());
    }

    void addColumns() {
        constexpr std::array<const char*, 4> kNames{"intensity", "red", "green", "blue"};
        const std::size_t width = columns_ - 3;
        for (std::size_t i = 0; i < width; ++i) {
            Attribute column{kNames[i], i == 0 ? ScalarType::Double : ScalarType::UInt8, {}};
            column.values.reserve(file_.position.size());
            for (std::size_t at = i; at < others_.size(); at += width) {
                double value = others_[at];
                if (!roundTo(column.type, value)) column.type = ScalarType::Double;
                column.values.push_back(value);
            }
            file_.attributes.push_back(std::move(column));
        }
    }

    PointFile file_;
    Vec3 scanner_{0.0};
    std::array<Vec3, 4> matrix_{};
    std::uint64_t points_ = 0;  // Of the scan.
    std::size_t columns_ = 0;   // Of all scans.
    std::vector<double> others_;
    std::size_t scans_ = 0;
};

}  // namespace

bool isPtx(const FileStart& start) {
    LineReader lines(start.bytes);
    std::array<std::size_t, 6> widths{};
    for (std::size_t& width : widths) {
        if (!lines.nextContent()) return false;
        width = LineNumbers(lines.line().substr(0, 400)).size();
    }
    return widths == std::array<std::size_t, 6>{1, 1, 3, 3, 3, 3};
}

Result<PointFile> readPtx(std::string_view text, const std::string& name) {
    return PtxReader(text, name).read();
}

}  // namespace se::io
