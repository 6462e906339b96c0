#include "io_formats.h"
#include "text_scan.h"

namespace se::io {
namespace {

constexpr std::size_t kMostNumbers = 6;

/// The numbers of the line; more than kMostNumbers are counted but not kept.
struct Row {
    double numbers[kMostNumbers] = {};
    std::size_t count = 0;
};

Result<Row> readRow(const LineReader& lines, const std::string& name) {
    Row row;
    Fields fields(lines.line(), ',');
    for (auto field = fields.next(); !field.empty(); field = fields.next(), ++row.count) {
        double ignored = 0.0;
        if (!parseDouble(field, row.count < kMostNumbers ? row.numbers[row.count] : ignored)) {
            return errorAt(name, lineText(lines.number()),
                           "expected a number, found " + inQuotes(field) + "; correct the line");
        }
    }
    if (row.count == 3 || row.count == 6) return row;
    return errorAt(name, lineText(lines.number()),
                   "expected 3 numbers (x y z) or 6 (x y z nx ny nz), found " +
                       std::to_string(row.count) + "; remove the other columns or save as PLY");
}

}  // namespace

Result<PointFile> readXyz(std::string_view text, const std::string& name) {
    PointFile file;
    file.positionType = ScalarType::Double;
    file.normalType = ScalarType::Double;
    std::size_t columns = 0;
    for (LineReader lines(text); lines.nextContent('#');) {
        const Result<Row> row = readRow(lines, name);
        if (!row) return row.error();
        const auto& [n, count] = row.value();
        if (columns == 0) columns = count;
        if (count != columns) {
            return errorAt(name, lineText(lines.number()),
                           "expected " + std::to_string(columns) + " numbers as in the lines " +
                               "before, found " + std::to_string(count) + "; correct the line");
        }
        file.position.emplace_back(n[0], n[1], n[2]);
        if (count == 6) file.normal.emplace_back(n[3], n[4], n[5]);
    }
    if (file.position.empty()) return Error{name + ": holds no points"};
    return file;
}

}  // namespace se::io
