/// The meaning of the columns of XYZ: from a comment that names them, or from the numbers of the
/// whole file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/io/read_points.h"

namespace se::io {

/// The columns that follow the position, over all rows.
struct ExtraColumns {
    std::vector<double> values;    ///< Row by row.
    std::vector<bool> digitsOnly;  ///< Per column: every number is written with digits alone.

    std::size_t width() const { return digitsOnly.size(); }
};

/// Names of columns, and the evidence for them in words.
struct NamedColumns {
    std::vector<std::string> names;
    std::string reason;
};

/// The names in a comment that names x, y and z once each, without comment signs: "x y z red nx".
/// Known names in the form that PLY uses ("R" is "red"), others unchanged. Empty if it is another
/// comment, or if it names a column twice.
std::vector<std::string> columnNamesIn(std::string_view comment);

/// True if files with `columns` numbers per row, the position included, can be read without names.
bool isRecognizable(std::size_t columns);

/// Names the columns after x, y and z. Fails with the reason, without a place, if the numbers allow
/// no reading or several. Requires isRecognizable() and a row.
Result<NamedColumns> recognizeColumns(const ExtraColumns& extra);

/// True if the column holds whole numbers from 0 to 255, written as such or as 255.0.
bool holdsBytes(const ExtraColumns& extra, std::size_t column);

}  // namespace se::io
