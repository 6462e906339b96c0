/// The PLY reader: the header, then the rows by templates over the two encodings, so that text and
/// binary are checked alike. Elements without lists are read column by column.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/polygons.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

// ---- header -------------------------------------------------------------------------------------

enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyProperty {
    std::string name;
    ScalarType type = ScalarType::Float;
    bool isList = false;
    ScalarType countType = ScalarType::UInt8;  ///< Of lists only.
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;  ///< As announced; must be checked against the size of the file.
    std::size_t line = 0;     ///< Line of the header that announces it.
    std::vector<PlyProperty> properties;

    bool hasList() const {
        return std::any_of(properties.begin(), properties.end(),
                           [](const PlyProperty& p) { return p.isList; });
    }
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< Bytes up to the first row.
    std::size_t lines = 0;  ///< Lines up to the first row.
};

const PlyElement* findElement(const PlyHeader& header, std::string_view name) {
    return findNamed(header.elements, name);
}

/// The other names of types than kTypeNames, by ScalarType.
constexpr std::array<std::string_view, 10> kSizedTypeNames{
    "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64", "long", "ulong"};
/// By PlyFormat.
constexpr std::array<std::string_view, 3> kFormatNames{"ascii", "binary_little_endian",
                                                       "binary_big_endian"};

class HeaderReader : LineByLine {
  public:
    using LineByLine::LineByLine;

    Result<PlyHeader> read() {
        const std::size_t size = lines_.rest().size();
        lines_.next();  // "ply", checked by the caller
        if (!readStatements()) return problem_;
        header_.size = size - lines_.rest().size();
        header_.lines = lines_.number();
        return std::move(header_);
    }

  private:
    bool readStatements() {
        while (lines_.next()) {
            Fields fields(lines_.line());
            const std::string_view keyword = fields.next();
            if (keyword == "end_header") {
                return hasFormat_ ||
                       fail("the header has no line \"format\", so the rows cannot be read");
            }
            if (!readStatement(keyword, fields)) return false;
        }
        return fail(
            "the file ends within its header, before the line \"end_header\"; it is cut short");
    }

    bool readStatement(std::string_view keyword, Fields& fields) {
        if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
        if (keyword == "format") return readFormat(fields.next());
        if (keyword == "element") return readElement(fields);
        if (keyword == "property") return readProperty(fields);
        return fail("expected format, comment, element, property or end_header, found " +
                    inQuotes(keyword));
    }

    bool readFormat(std::string_view format) {
        hasFormat_ = true;
        return parseName(kFormatNames, format, header_.format) ||
               fail("expected ascii, binary_little_endian or binary_big_endian, found " +
                    inQuotes(format));
    }

    bool readElement(Fields& fields) {
        PlyElement element;
        element.name = fields.next();
        element.line = lines_.number();
        const std::string_view field = fields.next();
        if (!parseCount(field, element.count)) {
            return fail("expected \"element NAME COUNT\", found " + inQuotes(field) +
                        " for the count");
        }
        properties_.clear();
        if (!elements_.insert(element.name).second)
            return fail("element " + inQuotes(element.name) + " is announced twice");
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool readType(std::string_view field, ScalarType& type) {
        return parseName(kTypeNames, field, type) || parseName(kSizedTypeNames, field, type) ||
               fail(
                   "expected a type: char, uchar, short, ushort, int, uint, int64, uint64, float "
                   "or double; found " +
                   inQuotes(field));
    }

    bool readProperty(Fields& fields) {
        if (header_.elements.empty()) return fail("a property stands before the first element");
        PlyProperty property;
        std::string_view type = fields.next();
        if (type == "list") {
            property.isList = true;
            if (!readType(fields.next(), property.countType)) return false;
            if (!isInteger(property.countType)) {
                return fail("the count of a list must be of an integer type");
            }
            type = fields.next();
        }
        if (!readType(type, property.type)) return false;
        property.name = fields.next();
        if (property.name.empty()) return fail("the property has no name");
        if (!properties_.insert(property.name).second)
            return fail("property " + inQuotes(property.name) + " is announced twice");
        header_.elements.back().properties.push_back(std::move(property));
        return true;
    }

    PlyHeader header_;
    std::set<std::string> elements_;
    std::set<std::string> properties_;  // Of the last element.
    bool hasFormat_ = false;
};

// ---- rows of both encodings ---------------------------------------------------------------------

// One class per encoding with the same members. A member that returns false has set problem().

/// The common state of both encodings: the current element and row, the problem.
class RowsBase : protected FirstProblem {
  public:
    using FirstProblem::FirstProblem;
    const Error& problem() const { return problem_; }

  protected:
    void enter(const PlyElement& element, std::uint64_t row) {
        element_ = &element;
        row_ = row;
    }
    bool failCut(const std::string& place) {
        return FirstProblem::failCut(place, row_, element_->count,
                                     "rows of element " + inQuotes(element_->name));
    }

  private:
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
};

/// One row per line, or on several lines of which the last ends with the row.
class AsciiRows : public RowsBase {
  public:
    AsciiRows(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : RowsBase(name), lines_(bytes.substr(header.size), header.lines), fields_({}) {}

    /// Where a row goes on in lines that do not complete it, the line that is too short is wrong.
    bool fail(const std::string& what) {
        return broken_.property != nullptr ? failBroken() : failAt(lineText(lines_.number()), what);
    }

    /// Checks that the file has room for the rows of `element`, before memory is allocated. A value
    /// takes at least two characters: a digit and a separator.
    bool checkRoom(const PlyElement& element) {
        const std::uint64_t room = (lines_.rest().size() + 1) / (2 * element.properties.size());
        if (element.count <= room) return true;
        return failAt(lineText(element.line),
                      "announces " + std::to_string(element.count) + " rows of element " +
                          inQuotes(element.name) + ", but the rest of the file has room for " +
                          std::to_string(room) + " at most; the header is wrong or the file cut");
    }
    bool beginRow(const PlyElement& element, std::uint64_t row) {
        enter(element, row);
        if (!lines_.nextContent()) return failCut(lineText(lines_.number()));
        fields_ = Fields(lines_.line());
        broken_ = {};
        return true;
    }
    bool endRow() {
        const std::string_view field = fields_.next();
        if (field.empty()) return true;
        return fail("expected the end of the row, found " + inQuotes(field) +
                    "; the line holds more values than the header announces");
    }
    /// The next value of `property`, which is of `type` (its own, or that of its count).
    bool scalar(const PlyProperty& property, ScalarType type, double& value) {
        std::string_view field = fields_.next();
        if (field.empty()) {
            if (broken_.property == nullptr) broken_ = {&property, type, lines_.number()};
            if (!lines_.nextContent()) return failBroken();
            fields_ = Fields(lines_.line());
            field = fields_.next();
        }
        if (parseDouble(field, value) && rounded_.round(type, value, property.name)) return true;
        return fail(expected(property, type) + inQuotes(field));
    }
    void addNotes(std::vector<std::string>& notes) const { rounded_.addNotes(notes); }
    bool skipList(const PlyProperty& property, std::uint64_t count) {
        double ignored = 0.0;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!scalar(property, property.type, ignored)) return false;
        }
        return true;
    }
    /// After the last element nothing may be left.
    bool finish() {
        broken_ = {};
        if (!lines_.nextContent()) return true;
        return fail(
            "the file goes on after the last row that its header announces; correct the "
            "counts in the header");
    }

  private:
    static std::string expected(const PlyProperty& property, ScalarType type) {
        return "expected a value of type " + std::string(nameOf(type)) + " for property " +
               inQuotes(property.name) + ", found ";
    }
    /// The lines after a short one do not complete its row: it is the line that is wrong.
    bool failBroken() {
        return failAt(lineText(broken_.line),
                      expected(*broken_.property, broken_.type) + "the end of the line");
    }

    /// The place where the row goes on in the next line.
    struct Break {
        const PlyProperty* property = nullptr;
        ScalarType type = ScalarType::Float;
        std::size_t line = 0;
    };

    LineReader lines_;
    Fields fields_;
    Break broken_;
    RoundedNumbers rounded_;
};

/// Rows without anything between them.
class BinaryRows : public RowsBase {
  public:
    BinaryRows(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : RowsBase(name),
          bytes_(bytes),
          at_(header.size),
          swapped_((header.format == PlyFormat::LittleEndian) !=
                   (std::endian::native == std::endian::little)) {}

    bool fail(const std::string& what) { return failAt(byteText(at_), what); }

    bool checkRoom(const PlyElement& element) {
        const std::uint64_t room = left() / leastRowSize(element);
        if (element.count <= room) return true;
        enter(element, room);
        if (!element.hasList()) return failCut(byteText(bytes_.size()));
        return failAt(byteText(bytes_.size()),
                      "the file ends too early to hold the " + std::to_string(element.count) +
                          " rows of element " + inQuotes(element.name) +
                          "; it is cut short, or its header announces too many");
    }
    bool beginRow(const PlyElement& element, std::uint64_t row) {
        enter(element, row);
        return true;
    }
    bool endRow() { return true; }
    bool scalar(const PlyProperty&, ScalarType type, double& value) {
        return withScalar(type, [&](auto zero) {
            if (left() < sizeof(zero)) return failCut(byteText(bytes_.size()));
            value = static_cast<double>(loadScalar<decltype(zero)>(bytes_.data() + at_, swapped_));
            at_ += sizeof(zero);
            return true;
        });
    }
    bool skipList(const PlyProperty& property, std::uint64_t count) {
        const std::size_t size = sizeOf(property.type);
        if (count > left() / size) return failCut(byteText(bytes_.size()));
        at_ += static_cast<std::size_t>(count) * size;
        return true;
    }
    static void addNotes(std::vector<std::string>&) {}
    /// Reads all rows of an element without lists, for which checkRoom() was true: column by
    /// column, about five times as fast as row by row.
    void readColumns(const PlyElement& element, const std::vector<Column>& columns) {
        const std::size_t rowSize = leastRowSize(element);
        const auto count = static_cast<std::size_t>(element.count);
        const char* first = bytes_.data() + at_;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const ScalarType type = element.properties[i].type;
            columns[i].load(type, first, rowSize, count, swapped_);
            first += sizeOf(type);
        }
        at_ += rowSize * count;
    }
    /// After the last element nothing may be left, but for a line end that some programs append.
    bool finish() {
        const std::string_view rest = bytes_.substr(at_);
        if (rest.empty() || rest == "\n" || rest == "\r\n") return true;
        return fail("the file goes on for " + std::to_string(rest.size()) + " bytes after the " +
                    "last row that its header announces; correct the counts in the header");
    }

  private:
    std::size_t left() const { return bytes_.size() - at_; }
    /// The size of a row whose lists are all empty.
    static std::size_t leastRowSize(const PlyElement& element) {
        std::size_t size = 0;
        for (const PlyProperty& p : element.properties)
            size += sizeOf(p.isList ? p.countType : p.type);
        return size;
    }

    std::string_view bytes_;
    std::size_t at_;
    bool swapped_;
};

// ---- elements -----------------------------------------------------------------------------------

constexpr std::size_t kNoProperty = std::numeric_limits<std::size_t>::max();
static_assert(sizeof(Vec3) == 3 * sizeof(double), "columns reach into vectors by a stride of 3");

std::size_t findProperty(const PlyElement& element, std::string_view name, bool list) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const PlyProperty& property = element.properties[i];
        if (property.name == name && property.isList == list) return i;
    }
    return kNoProperty;
}

const PlyProperty* scalarNamed(const PlyElement& element, std::string_view name) {
    return findInAnyCase(element.properties, name,
                         [](const PlyProperty& property) { return !property.isList; });
}

/// The scalar of this name; if there is none, one whose name differs only in case.
std::size_t findScalar(const PlyElement& element, std::string_view name) {
    const PlyProperty* found = scalarNamed(element, name);
    if (found == nullptr) return kNoProperty;
    return static_cast<std::size_t>(found - element.properties.data());
}

constexpr VectorNames kPositionNames{"x", "y", "z"};

/// The names under which `vertex` holds normals: the usual ones, unless it has only those of the
/// Point Cloud Library.
VectorNames normalNames(const PlyElement& vertex) {
    constexpr VectorNames kUsual{"nx", "ny", "nz"};
    constexpr VectorNames kLong{"normal_x", "normal_y", "normal_z"};
    return namesThere(kUsual, kLong, [&](const char* name) { return scalarNamed(vertex, name); });
}

/// The list of an element that names points.
std::size_t findIndexList(const PlyElement& element) {
    if (element.name == "se_neighbors") return findProperty(element, "id", true);
    const std::size_t indices = findProperty(element, "vertex_indices", true);
    return indices != kNoProperty ? indices : findProperty(element, "vertex_index", true);
}

/// The checks of the elements to read that need only the header.
Status checkHeader(const PlyHeader& header, const std::string& name) {
    const PlyElement* vertex = findElement(header, "vertex");
    if (vertex == nullptr) return Error{name + ": the header announces no element \"vertex\""};
    const auto fail = [&](const PlyElement& element, const std::string& what) {
        return errorAt(name, lineText(element.line), what);
    };
    for (const char* axis : kPositionNames) {
        if (findScalar(*vertex, axis) == kNoProperty) {
            return fail(*vertex, std::string("element \"vertex\" has no property ") + axis);
        }
    }
    if (vertex->count >= kNone) {
        return fail(*vertex, "announces " + std::to_string(vertex->count) +
                                 " points; at most 4294967294 can be read");
    }
    const PlyElement* neighbors = findElement(header, "se_neighbors");
    if (neighbors != nullptr &&
        (neighbors->count != vertex->count || findIndexList(*neighbors) == kNoProperty)) {
        return fail(*neighbors, "expected \"element se_neighbors " + std::to_string(vertex->count) +
                                    "\", one row per point, with \"property list ushort uint id\"");
    }
    for (const PlyElement* element :
         {findElement(header, "face"), findElement(header, "tristrips"), neighbors}) {
        if (element == nullptr || findIndexList(*element) == kNoProperty) continue;
        const PlyProperty& list = element->properties[findIndexList(*element)];
        if (!isInteger(list.type)) {
            return fail(*element,
                        "property " + inQuotes(list.name) + " must be of an integer type");
        }
    }
    return success();
}

std::string wholeText(double value) {
    if (std::abs(value) > kGreatestWhole) return value < 0.0 ? "less than -2^53" : "more than 2^53";
    return std::to_string(static_cast<std::int64_t>(value));
}

/// Appends the triangles of strips, which kNone separates: each corner makes one with the two
/// before it, every second one turned; none where two are the same.
void appendStrips(std::span<const Index> corners, std::vector<Triangle>& triangles) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] == kNone) begin = i + 1;
        if (i < begin + 2) continue;
        Triangle t{corners[i - 2], corners[i - 1], corners[i]};
        if ((i - begin) % 2 == 1) std::swap(t.a, t.b);
        if (t.a != t.b && t.b != t.c && t.c != t.a) triangles.push_back(t);
    }
}

/// Reads the rows after the header; the templates below are the same for text and binary.
template <typename Rows>
class BodyReader {
  public:
    BodyReader(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : header_(header),
          rows_(bytes, header, name),
          points_(findElement(header, "vertex")->count),
          name_(name) {}

    Result<PointFile> read() {
        for (const PlyElement& element : header_.elements) {
            if (element.properties.empty()) continue;  // rows of nothing
            if (!rows_.checkRoom(element) || !readElement(element)) return rows_.problem();
        }
        if (!rows_.finish()) return rows_.problem();
        polygons_.cutConcave(file_.position, file_.faces);
        rows_.addNotes(file_.notes);
        if (viewpoint_ != Vec3(0.0) && isFinite(viewpoint_)) file_.viewpoint = viewpoint_;
        if (const Status status = takeTypes(); !status) return status.error();
        return std::move(file_);
    }

  private:
    bool readElement(const PlyElement& element) {
        const std::vector<Column> nowhere(element.properties.size());
        const auto ignore = [] { return true; };
        if (element.name == "vertex" || element.name == "camera") {
            const std::vector<Column> columns =
                element.name == "vertex" ? makeColumns(element) : cameraColumns(element);
            noteOthers(element, columns, kNoProperty);
            return readRows(element, columns, kNoProperty, ignore);
        }
        if (element.name == "face" || element.name == "tristrips") {
            const bool isPolygons = element.name == "face";
            noteOthers(element, nowhere, findIndexList(element));
            return readRows(element, nowhere, findIndexList(element), [&] {
                if (isPolygons) {
                    polygons_.append(list_, file_.faces);
                } else {
                    appendStrips(list_, file_.faces);
                }
                return true;
            });
        }
        if (element.name == "se_neighbors") {
            return readRows(element, nowhere, findIndexList(element),
                            [this] { return appendNeighbors(); });
        }
        if (element.count > 0) file_.notes.push_back("left out: element " + element.name);
        return readRows(element, nowhere, kNoProperty, ignore);
    }

    /// Notes properties that are read over.
    void noteOthers(const PlyElement& element, const std::vector<Column>& columns,
                    std::size_t taken) {
        std::string names;
        std::size_t others = 0;
        for (std::size_t i = 0; i < element.properties.size() && element.count > 0; ++i) {
            if (i == taken || columns[i].first != nullptr) continue;
            constexpr std::size_t kNamed = 8;
            if (++others <= kNamed)
                names += (names.empty() ? "" : ", ") + element.properties[i].name;
            if (others == kNamed + 1) names += ", ...";
        }
        if (!names.empty())
            file_.notes.push_back("left out of element " + element.name + ": " + names);
    }

    /// The place of the sensor, as the Point Cloud Library writes it.
    std::vector<Column> cameraColumns(const PlyElement& camera) {
        std::vector<Column> columns(camera.properties.size());
        double* component = &viewpoint_.x;
        for (const char* name : {"view_px", "view_py", "view_pz"}) {
            const std::size_t at = findProperty(camera, name, false);
            if (at != kNoProperty) columns[at] = {component, 0};
            ++component;
        }
        return columns;
    }

    /// Reads all rows: scalars to their columns; list number `taken`, whose values name points, to
    /// list_, upon which `onRow` is called at the end of each row.
    template <typename OnRow>
    bool readRows(const PlyElement& element, const std::vector<Column>& columns, std::size_t taken,
                  OnRow onRow) {
        if constexpr (std::is_same_v<Rows, BinaryRows>) {
            if (!element.hasList()) {
                rows_.readColumns(element, columns);
                return true;
            }
        }
        for (std::uint64_t row = 0; row < element.count; ++row) {
            if (!rows_.beginRow(element, row)) return false;
            for (std::size_t i = 0; i < element.properties.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (property.isList) {
                    if (!readList(element, property, i == taken)) return false;
                    continue;
                }
                double value = 0.0;
                if (!rows_.scalar(property, property.type, value)) return false;
                columns[i].set(row, value);
            }
            if (!rows_.endRow() || !onRow()) return false;
        }
        return true;
    }

    bool readList(const PlyElement& element, const PlyProperty& property, bool isTaken) {
        double count = 0.0;
        if (!rows_.scalar(property, property.countType, count)) return false;
        if (count < 0.0 || count > kGreatestWhole) {
            return rows_.fail("expected the length of list " + inQuotes(property.name) +
                              ", found " + wholeText(count));
        }
        if (!isTaken) return rows_.skipList(property, static_cast<std::uint64_t>(count));
        list_.clear();
        const bool restarts = element.name == "tristrips";
        for (auto left = static_cast<std::uint64_t>(count); left > 0; --left) {
            double value = 0.0;
            if (!rows_.scalar(property, property.type, value)) return false;
            if (value == -1.0 && restarts) {
                list_.push_back(kNone);
                continue;
            }
            if (value < 0.0 || value >= static_cast<double>(points_)) {
                return rows_.fail(
                    "list " + inQuotes(property.name) + " names point " + wholeText(value) +
                    ", but the points are numbered from 0 to below " + std::to_string(points_) +
                    "; the file is damaged, or its rows are not as the header says");
            }
            list_.push_back(static_cast<Index>(value));
        }
        return true;
    }

    bool appendNeighbors() {
        if (list_.size() > kNone - file_.neighbors.ids.size()) {
            return rows_.fail("the neighbor lists hold more than 4294967295 entries in all");
        }
        file_.neighbors.append(list_);
        return true;
    }

    /// Allocates the points and returns the target of each property of `vertex`. Lists have none.
    std::vector<Column> makeColumns(const PlyElement& vertex) {
        const auto count = static_cast<std::size_t>(vertex.count);
        std::vector<Column> columns(vertex.properties.size());
        takeVector(vertex, kPositionNames, file_.position, file_.positionType, columns);
        takeVector(vertex, normalNames(vertex), file_.normal, file_.normalType, columns);
        std::size_t type = findProperty(vertex, "scalar_se_type", false);
        if (type == kNoProperty) type = findProperty(vertex, "se_type", false);
        if (type != kNoProperty) {
            types_.resize(count);
            columns[type] = {types_.data(), 1};
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const PlyProperty& property = vertex.properties[i];
            if (property.isList || columns[i].first != nullptr || count == 0) continue;
            // Moving the vector of attributes later does not move the values.
            file_.attributes.push_back({property.name, property.type, std::vector<double>(count)});
            columns[i] = {file_.attributes.back().values.data(), 1};
        }
        return columns;
    }

    /// Sends three properties to the components of `vectors`, if `vertex` has them all.
    void takeVector(const PlyElement& vertex, const VectorNames& names, std::vector<Vec3>& vectors,
                    ScalarType& type, std::vector<Column>& columns) {
        std::array<std::size_t, 3> at{};
        type = ScalarType::Float;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            at[axis] = findScalar(vertex, names[axis]);
            if (at[axis] == kNoProperty) return;
            if (vertex.properties[at[axis]].type != ScalarType::Float) type = ScalarType::Double;
        }
        vectors.resize(static_cast<std::size_t>(vertex.count));
        if (vectors.empty()) return;
        columns[at[0]] = {&vectors[0].x, 3};
        columns[at[1]] = {&vectors[0].y, 3};
        columns[at[2]] = {&vectors[0].z, 3};
    }

    Status takeTypes() {
        file_.type.reserve(types_.size());
        for (const double value : types_) {
            if (!(value >= 0.0 && value <= 255.0 && value == std::floor(value))) {
                return Error{name_ + ": point " + std::to_string(file_.type.size()) +
                             ": the type (scalar_se_type) must be a whole number from 0 to 255, "
                             "found " +
                             std::to_string(value)};
            }
            file_.type.push_back(static_cast<std::uint8_t>(value));
        }
        return success();
    }

    const PlyHeader& header_;
    Rows rows_;
    std::uint64_t points_;
    Vec3 viewpoint_{0.0};
    const std::string& name_;
    PointFile file_;
    std::vector<double> types_;
    std::vector<Index> list_;
    Polygons polygons_;
};

}  // namespace

bool isPly(const FileStart& start) {
    const std::string_view bytes = start.bytes;
    return bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || bytes.starts_with("ply ");
}

Result<PointFile> readPly(std::string_view bytes, const std::string& name) {
    const Result<PlyHeader> header = HeaderReader(bytes, name).read();
    if (!header) return header.error();
    if (const Status status = checkHeader(header.value(), name); !status) return status.error();
    if (header.value().format == PlyFormat::Ascii) {
        return BodyReader<AsciiRows>(bytes, header.value(), name).read();
    }
    return BodyReader<BinaryRows>(bytes, header.value(), name).read();
}

}  // namespace se::io
