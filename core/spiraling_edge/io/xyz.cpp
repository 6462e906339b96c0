/// The XYZ reader: commas, column count and header comment are determined from the first rows, the
/// meaning of the columns at the end.
#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::io {
namespace {

// ---- the meaning of columns ---------------------------------------------------------------------

// Without a header the meaning of columns is inferred from the numbers of the whole file
// (range, whole numbers, length), and only where one reading is possible. O(numbers).

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

    bool zeroOrOne() const { return whole && low >= 0.0 && high <= 1.0; }
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
    // Normals along the axes, such as 0 0 1.
    if (facts.directed > 0 && facts.zeroOrOne())
        return facts.unit == facts.directed ? Look::Normals : Look::Unclear;
    if (facts.digitsOnly && facts.high <= kHighestColor) {
        if (facts.directed == 0) return Look::Black;
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

/// True if normals of zeros and ones alone suit the points, and are not pure colors: those along x
/// or y lie on few levels of it, as walls and steps do, or within half the extent of the set, as a
/// terrain does. Those along z may be anywhere: programs write 0 0 1 where they know no normal.
bool suitPoints(const ExtraColumns& normals, std::span<const Vec3> position) {
    const WallBox box = boxAround(position);
    const Vec3 sides = box.high - box.low;
    const double extent = std::max({sides.x, sides.y, sides.z});
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::vector<double> levels;
        for (std::size_t p = 0; p < position.size(); ++p) {
            if (normals.values[3 * p + axis] == 1.0 && isFinite(position[p]))
                levels.push_back(position[p][static_cast<int>(axis)]);
        }
        const std::size_t points = levels.size();
        sortUnique(levels);
        const bool few = 2 * levels.size() <= points;
        if (!few && levels.back() - levels.front() > 0.5 * extent) return false;
    }
    return true;
}

Result<NamedColumns> recognizeSix(const ExtraColumns& extra, std::span<const Vec3> position) {
    const Look look = lookOf(extra, 0);
    const bool pure = look == Look::Normals && factsOf(extra, 0).zeroOrOne();
    if (look == Look::Unclear || (pure && !suitPoints(extra, position)))
        return cannotTell(6, tripleText(0));
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

/// The letters and digits of a name, in lower case, without a unit: "X [m]", "Normals:0".
std::string plainName(std::string_view word) {
    std::string plain = lowerCase(word.substr(0, word.find_first_of("[(")));
    std::erase_if(plain, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return plain;
}

/// The first name of the row of a table that has `name`; `otherwise` if none has.
template <typename Table>
std::string firstOfRow(const Table& table, std::string_view name, std::string_view otherwise) {
    const auto row = name.empty()
                         ? nullptr
                         : rowWhere(table, [&](const auto& names) { return isAmong(name, names); });
    return std::string(row == nullptr ? otherwise : row->front());
}

std::string usualName(std::string_view word) {
    constexpr std::array<std::array<std::string_view, 6>, 10> kNames{{
        // With the names of tables of ParaView.
        {"x", "posx", "positionx", "xcoord", "xcoordinate", "points0"},
        {"y", "posy", "positiony", "ycoord", "ycoordinate", "points1"},
        {"z", "posz", "positionz", "zcoord", "zcoordinate", "points2"},
        {"nx", "normalx", "normals0"},
        {"ny", "normaly", "normals1"},
        {"nz", "normalz", "normals2"},
        {"red", "r"},
        {"green", "g"},
        {"blue", "b"},
        {"intensity", "i"},
    }};
    return firstOfRow(kNames, plainName(word), word);
}

/// The axis that a word of maps stands for; else `name`.
std::string axisOnMap(std::string_view word, std::string_view name) {
    constexpr std::array<std::array<std::string_view, 6>, 3> kNames{{
        {"x", "lon", "longitude", "east", "easting", "e"},
        {"y", "lat", "latitude", "north", "northing", "n"},
        {"z", "height", "elevation", "alt", "altitude", "up"},
    }};
    return firstOfRow(kNames, word, name);
}

/// The axis of a name that surveyors write, such as "Elev (m)"; else the name.
std::string axisOfSurvey(const std::string& name) {
    const std::string plain = plainName(name);
    return axisOnMap(plain == "elev" || plain == "h" ? "height" : plain, name);
}

/// A name without blanks and quotation marks around it; those within become "_".
std::string tidyName(std::string_view name) {
    const auto isAround = [](char c) { return isSpace(c) || c == '"' || c == '\''; };
    while (!name.empty() && isAround(name.front())) name.remove_prefix(1);
    while (!name.empty() && isAround(name.back())) name.remove_suffix(1);
    std::string text(name);
    std::replace_if(text.begin(), text.end(), isSpace, '_');
    return text;
}

/// The words of a row of names: those between semicolons, tabs or commas, whichever of these comes
/// first in this list; else those between blanks.
std::vector<std::string> namesInRow(std::string_view row) {
    std::vector<std::string> names;
    constexpr std::string_view kSeparators = ";\t,";
    const auto separator =
        rowWhere(kSeparators, [&](char each) { return row.find(each) != std::string_view::npos; });
    if (separator == nullptr) {
        for (const std::string& word : wordsIn(row)) names.push_back(tidyName(word));
        return names;
    }
    while (true) {
        const std::size_t end = std::min(row.find(*separator), row.size());
        names.push_back(tidyName(row.substr(0, end)));
        if (end == row.size()) break;
        row.remove_prefix(end + 1);
    }
    if (names.back().empty()) names.pop_back();
    return names;
}

bool isPrintable(std::string_view word) {
    return std::none_of(word.begin(), word.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x20 || code == 0x7f;
    });
}

/// Words as names of columns, if they name x, y and z once each. Known names in the form that PLY
/// uses ("R" is "red"), others unchanged. Empty if they are other words, or name a column twice.
std::vector<std::string> columnNames(std::vector<std::string> words) {
    for (std::string& word : words) {
        if (!isPrintable(word)) return {};
        word = usualName(word);
    }
    // Beside x, y and z a height is a column of its own, and so are "n (hits)" and "h" beside
    // others.
    if (!isAmong("x", words)) {
        for (std::string& word : words) word = axisOnMap(lowerCase(word), word);
        if (!isAmong("x", words) || !isAmong("y", words) || !isAmong("z", words))
            std::transform(words.begin(), words.end(), words.begin(), axisOfSurvey);
    }
    for (const char* axis : {"x", "y", "z"}) {
        if (std::count(words.begin(), words.end(), axis) != 1) return {};
    }
    std::vector<std::string> different = words;
    sortUnique(different);
    if (different.size() < words.size()) return {};
    return words;
}

/// Position of a name; the number of names if it is not there.
std::size_t columnOf(const std::vector<std::string>& names, std::string_view name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Names of columns, and their line.
struct Header {
    std::vector<std::string> names;
    std::size_t line = 0;

    /// True for "y x z" and other orders of these side by side; words of a sentence are apart.
    bool turnsAxes() const {
        const std::size_t x = columnOf(names, "x");
        const std::size_t y = columnOf(names, "y");
        const std::size_t z = columnOf(names, "z");
        return std::max({x, y, z}) - std::min({x, y, z}) == 2 && !(x < y && y < z);
    }
};

/// The ways to read a comment as names of columns: its words, those that are no units in brackets,
/// or what its separators part ("x, y, z, point id"); after a label ("columns: x y z", "format =").
std::vector<Header> headersIn(std::string_view comment, std::size_t line) {
    std::vector<Header> headers;
    const std::size_t label = std::max(comment.rfind(": ") + 1, comment.rfind('=') + 1);
    for (const std::string_view text : {comment.substr(label), comment}) {
        const std::vector<std::string> words = wordsIn(text, ',', ';');
        std::vector<std::string> bare = words;
        std::erase_if(bare, [](const auto& word) { return word[0] == '[' || word[0] == '('; });
        for (const auto& each : {words, bare, namesInRow(text)}) {
            Header header{columnNames(each), line};
            if (!header.names.empty()) headers.push_back(std::move(header));
        }
        if (!headers.empty()) break;
    }
    return headers;
}

/// True if files with `columns` numbers per row, the position included, can be read without names.
bool isRecognizable(std::size_t columns) {
    constexpr std::array<std::size_t, 5> kCounts{3, 4, 6, 7, 9};
    return isAmong(columns, kCounts);
}

/// Names the columns after x, y and z. Fails with the reason, without a place, if the numbers allow
/// no reading or several. Requires isRecognizable() and a row.
Result<NamedColumns> recognizeColumns(const ExtraColumns& extra, std::span<const Vec3> position) {
    assert(isRecognizable(3 + extra.width()) && (extra.width() == 0 || !extra.values.empty()));
    switch (extra.width()) {
        case 1:
            return NamedColumns{{"intensity"}, "column 4 is read as intensity"};
        case 3:
            return recognizeSix(extra, position);
        case 4:
            return recognizeSeven(extra);
        case 6:
            return recognizeNine(extra);
        default:
            return NamedColumns{};
    }
}

/// True if the column holds whole numbers from 0 to 255, written as such or as 255.0.
bool holdsBytes(const ExtraColumns& extra, std::size_t column) {
    bool fits = true;
    for (std::size_t at = column; fits && at < extra.values.size(); at += extra.width()) {
        const double value = extra.values[at];
        fits = value >= 0.0 && value <= kHighestColor && value == std::floor(value);
    }
    return fits;
}

// ---- lines --------------------------------------------------------------------------------------

/// Meanings of the commas of a line.
enum class Commas : std::uint8_t { None, Separating, Decimal, Mixed };

bool isBlank(std::string_view text) { return std::all_of(text.begin(), text.end(), isSpace); }

/// True if there are 1 to `limit` fields before each `separator`, and at most `limit` after the
/// last.
bool hasFieldsBetween(std::string_view line, char separator, std::size_t limit) {
    std::size_t count = 0;
    bool inField = false;
    for (const char c : line) {
        if (c == separator) {
            if (count == 0) return false;
            count = 0;
            inField = false;
        } else if (isSpace(c)) {
            inField = false;
        } else if (!inField) {
            inField = true;
            if (++count > limit) return false;
        }
    }
    return true;
}

/// True for "0,5" and "-12,25e3": one comma, between two digits, and no decimal point.
bool hasDecimalComma(std::string_view field) {
    const auto isDigit = [&](std::size_t i) {
        return i < field.size() && std::isdigit(static_cast<unsigned char>(field[i])) != 0;
    };
    const std::size_t comma = field.find(',');
    return comma != std::string_view::npos && comma > 0 && isDigit(comma - 1) &&
           isDigit(comma + 1) && field.find(',', comma + 1) == std::string_view::npos &&
           field.find('.') == std::string_view::npos;
}

Commas commasOf(std::string_view line) {
    if (line.find(',') == std::string_view::npos) return Commas::None;
    const bool semicolons = line.find(';') != std::string_view::npos;
    if (!semicolons && hasFieldsBetween(line, ',', 1)) return Commas::Separating;
    Fields fields(line, ';');
    for (auto field = fields.next(); !field.empty(); field = fields.next()) {
        if (!hasDecimalComma(field)) return Commas::Mixed;
    }
    return Commas::Decimal;
}

std::string withDecimalPoint(std::string_view field) {
    std::string text(field);
    std::replace(text.begin(), text.end(), ',', '.');
    return text;
}

/// A row with blanks for its quotation marks. Where there are commas both within them and between
/// them, the latter become semicolons: "3,1","2,5","4,0" is three numbers.
std::string unquoted(std::string_view row) {
    std::string text(row);
    bool within = false;
    for (char& c : text) {
        if (c == '"') within = !within;
        if (c == ',' && !within) c = ';';
    }
    if (text.find(',') == std::string::npos) text = row;
    std::replace(text.begin(), text.end(), '"', ' ');
    return text;
}

/// Reads XYZ line by line. The columns that follow the position are named at the end.
class XyzReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PointFile> read() {
        file_.positionType = file_.normalType = ScalarType::Double;
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            const std::size_t comment = std::min(beforeComment(line, '#').size(), line.find("//"));
            const std::string_view content = line.substr(0, comment);
            if (!isBlank(content)) {
                if (isNames(content) ? !takeNames(content) : !readRow(content)) return problem_;
            } else if (comment < line.size()) {
                takeHeader(line.substr(comment));
            }
        }
        if (!endCount()) return problem_;
        if (file_.position.empty()) return Error{name_ + ": holds no points"};
        takeCountAsPoint();
        if (!nameColumns()) return problem_;
        if (decimalComma_) file_.notes.emplace_back("commas are read as decimal points");
        takeNormals();
        takeAttributes();
        return std::move(file_);
    }

  private:
    // ---- rows -------------------------------------------------------------------------------

    /// Takes the column names of a comment before the points.
    void takeHeader(std::string_view comment) {
        if (!file_.position.empty() || namedInRow_) return;
        comment.remove_prefix(std::min(comment.find_first_not_of("#/"), comment.size()));
        for (Header& each : headersIn(comment, lines_.number())) named_.push_back(std::move(each));
    }

    /// True for a first row of words.
    bool isNames(std::string_view content) const {
        double number = 0.0;
        const std::string first = tidyName(Fields(content, ',', ';').next());
        return file_.position.empty() && count_.line == 0 && !namedInRow_ &&
               !parseDouble(withDecimalPoint(first), number);
    }

    bool takeNames(std::string_view content) {
        named_ = {{columnNames(namesInRow(content)), lines_.number()}};
        namedInRow_ = true;
        return !named_[0].names.empty() ||
               fail("expected numbers, or names of columns with x, y and z once each, found " +
                    inQuotes(content.substr(0, 60)) + "; name them so, or delete the line");
    }

    // ---- counts -----------------------------------------------------------------------------

    /// A row of one whole number announces the rows after it.
    struct Count {
        std::size_t line = 0;  ///< 0: there is none.
        double rows = 0.0;
        std::size_t from = 0;  ///< Number of rows before it.
    };

    /// Not after rows that no count announces: there a line that is cut short may look so.
    bool isCount() const {
        return row_.size() == 1 && rowDigits_[0] != 0 && row_[0] > 0.0 &&
               (file_.position.empty() || counts_ > 0);
    }

    bool takeCount() {
        if (!endCount()) return false;
        count_ = {lines_.number(), row_[0], file_.position.size()};
        if (counts_++ == 0)
            file_.notes.push_back(lineText(count_.line) + " is the number of points");
        return true;
    }

    /// A first row "600 0 0" before rows of another length: points, faces and edges of OFF.
    bool firstIsCount() const { return file_.position.size() == 1 && startsWithCount_; }
    bool takeFirstAsCount() {
        count_ = {firstLine_, file_.position.front().x, 0};
        file_.notes.push_back(lineText(firstLine_) + " begins with the number of points");
        file_.position.clear();
        extra_.values.clear();
        others_.clear();
        return beginRows();
    }

    bool endCount() {
        if (count_.line == 0) return true;
        const std::size_t rows = file_.position.size() - count_.from;
        return static_cast<double>(rows) == count_.rows ||
               failIn(count_.line,
                      "announces " +
                          std::to_string(static_cast<std::uint64_t>(std::min(count_.rows, 1e15))) +
                          " points, but " + std::to_string(rows) +
                          " follow; the file is cut short, or the line is wrong: "
                          "correct or delete it");
    }

    /// A first row such as "600 0 0" is no point if as many rows follow: OFF without its keyword.
    /// Rows of whole numbers are a grid, which may begin so. Nor is "10 60 1" before 600 rows, or
    /// "600 3 1", if no other row is whole.
    void takeCountAsPoint() {
        constexpr double kLeast = 10.0;
        const bool grid = digitsOnly_ == std::vector<char>{1, 1, 1};
        const bool onlyWhole = startsWhole_ && wholeRows_ == 1;
        if (columns_ != 3 || grid || !(startsWithCount_ || onlyWhole)) return;
        const auto rows = static_cast<double>(file_.position.size() - 1);
        const Vec3 first = file_.position.front();
        const bool counts = first.x == rows && (startsWithCount_ || rows >= kLeast);
        const bool sizes = onlyWhole && rows >= kLeast && first.x * first.y * first.z == rows;
        if (!counts && !sizes) return;
        file_.position.erase(file_.position.begin());
        file_.notes.push_back(lineText(firstLine_) + (counts ? " begins with the number of points"
                                                             : " is the size of a grid of points"));
    }

    bool readRow(std::string_view content) {
        std::string plain;
        if (content.find('"') != std::string_view::npos) {
            plain = unquoted(content);
            content = plain;
        }
        while (!content.empty() && isSpace(content.back())) content.remove_suffix(1);
        if (content.find('\r') != std::string_view::npos) {
            return fail("the file has line ends of two kinds, CR and LF; save it with LF alone");
        }
        if (!checkSeparators(content)) return false;
        row_.clear();
        rowDigits_.clear();
        Fields fields(content, ';', decimalComma_ ? ';' : ',');
        for (auto field = fields.next(); !field.empty(); field = fields.next()) {
            double value = 0.0;
            const bool good = decimalComma_ ? parseDouble(withDecimalPoint(field), value)
                                            : parseDouble(field, value);
            if (!good) {
                return fail("expected a number, found " + inQuotes(field) +
                            "; correct the line, or write nan where a value is missing");
            }
            noteDigits(field);
            row_.push_back(value);
        }
        if (isCount()) return takeCount();
        if (file_.position.empty() && !beginRows()) return false;
        if (row_.size() != columns_ && firstIsCount()) {
            if (!takeFirstAsCount()) return false;
        }
        if (row_.size() != columns_) {
            return fail("expected " + std::to_string(columns_) + " numbers as in the lines " +
                        "before, found " + std::to_string(row_.size()) + "; correct the line");
        }
        keepRow();
        return true;
    }

    void noteDigits(std::string_view field) {
        const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
        rowDigits_.push_back(std::all_of(field.begin(), field.end(), isDigit) ? 1 : 0);
    }

    /// Determines the meaning of commas from the first row, and refuses other rows.
    bool checkSeparators(std::string_view content) {
        if (content.find(';') != std::string_view::npos &&
            !hasFieldsBetween(content, ';', content.size())) {
            return fail("expected a number between two semicolons; correct the line");
        }
        const Commas commas = commasOf(content);
        if (commas == Commas::Mixed && !hasFieldsBetween(content, ',', content.size())) {
            return fail("expected a number between two commas; write nan, or remove the column");
        }
        const bool decimal = commas == Commas::Decimal;
        if (file_.position.empty()) decimalComma_ = decimal;
        if (commas == Commas::Mixed) {
            return fail(
                "expected commas between all numbers (0.1,0.2,0.3) or one decimal comma in every "
                "number and blanks between them (0,1 0,2 0,3), found a mixture; write decimal "
                "points");
        }
        if (decimal == decimalComma_) return true;
        return fail(decimalComma_ ? "expected one decimal comma in every number, as in the lines "
                                    "before; write decimal points in the whole file"
                                  : "found decimal commas, but the lines before use none; write "
                                    "decimal points in the whole file");
    }

    /// Determines the number of columns and those of the position from the first row.
    bool beginRows() {
        columns_ = row_.size();
        firstLine_ = lines_.number();
        digitsOnly_.assign(columns_, 1);
        startsWhole_ = rowDigits_ == std::vector<char>{1, 1, 1};
        startsWithCount_ = startsWhole_ && row_[0] >= 3.0 && row_[1] == 0.0 && row_[2] == 0.0;
        header_ = {};
        for (const Header& each : named_) {
            if (each.names.size() == columns_ && each.line > header_.line) header_ = each;
        }
        if (namedInRow_ && header_.names.empty() && !startsWithCount_) {
            return fail("found " + std::to_string(columns_) + " numbers, but " +
                        lineText(named_[0].line) + " names " +
                        std::to_string(named_[0].names.size()) +
                        " columns; correct one of the two lines");
        }
        if (header_.names.empty() && !isRecognizable(columns_)) {
            return fail(
                "expected 3 numbers (x y z), or 4, 6, 7 or 9 (with intensity, normals or "
                "colors), found " +
                std::to_string(columns_) +
                "; remove the other columns, or name them in a line before the points, "
                "such as \"# x y z intensity label\", with one name per column");
        }
        axes_ = {0, 1, 2};
        const std::vector<std::string>& names = header_.names;
        if (!names.empty())
            axes_ = {columnOf(names, "x"), columnOf(names, "y"), columnOf(names, "z")};
        for (std::size_t column = 0; column < columns_; ++column) {
            if (!isAmong(column, axes_)) others_.push_back(column);
        }
        return true;
    }

    void keepRow() {
        wholeRows_ += isAmong(0, rowDigits_) ? 0U : 1U;
        for (std::size_t column = 0; column < columns_; ++column)
            digitsOnly_[column] = digitsOnly_[column] != 0 && rowDigits_[column] != 0 ? 1 : 0;
        countsRows_ = countsRows_ && digitsOnly_[0] != 0 &&
                      (file_.position.empty() || row_[0] == lastFirst_ + 1.0);
        lastFirst_ = row_[0];
        file_.position.emplace_back(row_[axes_[0]], row_[axes_[1]], row_[axes_[2]]);
        for (const std::size_t column : others_) extra_.values.push_back(row_[column]);
    }

    // ---- columns ----------------------------------------------------------------------------

    bool nameColumns() {
        for (const std::size_t column : others_)
            extra_.digitsOnly.push_back(digitsOnly_[column] != 0);
        std::vector<std::string> all = header_.names;
        if (all.empty()) {
            const auto* const turned = rowWhere(named_, std::mem_fn(&Header::turnsAxes));
            if (turned != nullptr) {
                return failIn(turned->line,
                              "this comment names x, y and z in another order, but "
                              "not one word for each of the " +
                                  std::to_string(columns_) +
                                  " columns; name all of them, or remove it");
            }
            if (others_.size() % 3 == 1 && numbersPoints()) {
                return failIn(firstLine_,
                              std::string("column 1 ") +
                                  (countsRows_ ? "counts the rows"
                                               : "holds another whole number in each row") +
                                  ", as numbers of points do; name the columns "
                                  "in a line before the points, such as \"# id x y z\"");
            }
            Result<NamedColumns> named = recognizeColumns(extra_, file_.position);
            if (!named && isPts()) {
                named = NamedColumns{{"intensity", "red", "green", "blue"},
                                     "in the order of PTS files, which begin with a count"};
            }
            if (!named) return failIn(firstLine_, named.error().message);
            names_ = std::move(named.value().names);
            file_.columns.reason = std::move(named.value().reason);
            all = {"x", "y", "z"};
            all.insert(all.end(), names_.begin(), names_.end());
        } else {
            for (const std::size_t column : others_) names_.push_back(all[column]);
            if (has("")) file_.notes.emplace_back("left out: a column without a name");
            if (!headerFits()) return false;
            file_.columns.reason = "named in " + lineText(header_.line);
        }
        file_.columns.names = joined(all, " ");
        return true;
    }

    /// True if the first column counts the rows; or holds another whole number in each of many
    /// rows, while the three after it, which are the position then, have fractions.
    bool numbersPoints() const {
        constexpr std::size_t kMany = 10;
        const std::size_t rows = file_.position.size();
        if (rows < kMany || countsRows_) return rows > 1 && countsRows_;
        std::vector<double> numbers;
        std::array<bool, 4> whole{true, true, true, true};
        for (std::size_t p = 0; p < rows; ++p) {
            const Vec3& row = file_.position[p];
            const std::array<double, 4> values{row.x, row.y, row.z,
                                               extra_.values[p * others_.size()]};
            for (std::size_t i = 0; i < 4; ++i)
                whole[i] = whole[i] && values[i] == std::floor(values[i]);
            numbers.push_back(row.x);
        }
        if (whole != std::array<bool, 4>{true, false, false, false}) return false;
        sortUnique(numbers);
        return numbers.size() == rows;
    }

    /// Seven columns after a count, of which the last three can be colors.
    bool isPts() const {
        return counts_ > 0 && others_.size() == 4 && isColorful(lookOf(extra_, 1));
    }

    /// A sentence such as "x y z in mm, up" may have as many words as there are columns. It does
    /// not count as names where the numbers are those of normals or colors and it names none.
    bool headerFits() {
        if (columns_ < 6 || !isRecognizable(columns_) || has("nx") || has("red")) return true;
        const Result<NamedColumns> named = recognizeColumns(extra_, file_.position);
        if (!named) return true;
        return failIn(header_.line,
                      "this comment has one word per column and names neither normals nor colors, "
                      "but " +
                          named.value().reason +
                          "; name the columns in it, such as \"# x y z nx ny nz\", or remove it");
    }

    bool has(std::string_view name) const { return isAmong(name, names_); }

    /// Moves nx, ny and nz out of the names, if all three are there.
    void takeNormals() {
        if (!has("nx") || !has("ny") || !has("nz")) return;
        const std::size_t x = columnOf(names_, "nx");
        const std::size_t y = columnOf(names_, "ny");
        const std::size_t z = columnOf(names_, "nz");
        file_.normal.reserve(file_.position.size());
        for (std::size_t at = 0; at < extra_.values.size(); at += extra_.width()) {
            file_.normal.emplace_back(extra_.values[at + x], extra_.values[at + y],
                                      extra_.values[at + z]);
        }
        for (const std::size_t taken : {x, y, z}) names_[taken].clear();
    }

    void takeAttributes() {
        bool bytes = true;
        const auto isColor = [](std::string_view name) {
            return name == "red" || name == "green" || name == "blue";
        };
        for (std::size_t i = 0; i < names_.size(); ++i)
            bytes = bytes && (!isColor(names_[i]) || holdsBytes(extra_, i));
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (names_[i].empty()) continue;
            Attribute attribute{names_[i], ScalarType::Double, {}};
            if (bytes && isColor(names_[i])) attribute.type = ScalarType::UInt8;
            attribute.values.reserve(file_.position.size());
            for (std::size_t at = i; at < extra_.values.size(); at += extra_.width())
                attribute.values.push_back(extra_.values[at]);
            if (extra_.digitsOnly[i]) noteLostDigits(attribute, file_.notes);
            file_.attributes.push_back(std::move(attribute));
        }
    }

    PointFile file_;
    std::vector<Header> named_;  // Before the first row.
    Header header_;              // The last of those with as many names as columns; else empty.
    std::size_t firstLine_ = 0;
    std::size_t columns_ = 0;
    std::array<std::size_t, 3> axes_{};
    std::vector<std::size_t> others_;  // The columns that hold no position.
    std::vector<std::string> names_;   // Of others_; empty where taken.
    ExtraColumns extra_;
    std::vector<double> row_;
    std::vector<char> rowDigits_;   // Per number of the row: 1 if it is digits alone.
    std::vector<char> digitsOnly_;  // Per column: 1 while all numbers are digits alone.
    bool namedInRow_ = false;       // named_ is from a row, not from a comment.
    bool startsWhole_ = false;      // The first row is three numbers of digits alone.
    bool startsWithCount_ = false;  // The first row is "N 0 0", of 3 or more.
    std::size_t wholeRows_ = 0;     // Rows of digits alone.
    Count count_;                   // The last one.
    std::size_t counts_ = 0;
    bool decimalComma_ = false;
    bool countsRows_ = true;  // So far the first column goes up by one from row to row.
    double lastFirst_ = 0.0;
};

}  // namespace

bool isXyz(const FileStart& start) {
    double number = 0.0;
    const bool names = !isPcd(start) && !columnNames(namesInRow(start.line)).empty();
    return (names || parseDouble(start.word, number)) && !isOff(start);
}

Result<PointFile> readXyz(std::string_view text, const std::string& name) {
    return XyzReader(text, name).read();
}

}  // namespace se::io
