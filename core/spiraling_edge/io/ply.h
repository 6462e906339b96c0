/// The header of PLY, and the rows of its elements: one class per encoding with the same members,
/// so that ply_reader.cpp reads both with the same templates. A member of them that returns false
/// has set problem().
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {

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

/// The common state of both encodings: the file's name, the current element and row, the problem.
class RowsBase {
  public:
    explicit RowsBase(const std::string& name) : name_(name) {}
    const Error& problem() const { return problem_; }

  protected:
    bool failAt(const std::string& place, const std::string& what) {
        problem_ = errorAt(name_, place, what);
        return false;
    }
    void enter(const PlyElement& element, std::uint64_t row) {
        element_ = &element;
        row_ = row;
    }
    bool failCut(const std::string& place) {
        return failAt(place, "the file ends after " + std::to_string(row_) + " of " +
                                 std::to_string(element_->count) + " rows of element " +
                                 inQuotes(element_->name) +
                                 "; it is cut short, or its header announces too many");
    }

  private:
    const std::string& name_;
    const PlyElement* element_ = nullptr;
    std::uint64_t row_ = 0;
    Error problem_;
};

/// One row per line.
class AsciiRows : public RowsBase {
  public:
    AsciiRows(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : RowsBase(name), lines_(bytes.substr(header.size), header.lines), fields_({}) {}

    bool fail(const std::string& what) { return failAt(lineText(lines_.number()), what); }

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
        const std::string_view field = fields_.next();
        if (parseDouble(field, value) && roundTo(type, value)) return true;
        return fail("expected a value of type " + std::string(nameOf(type)) + " for property " +
                    inQuotes(property.name) + ", found " +
                    (field.empty() ? "the end of the line" : inQuotes(field)));
    }
    bool skipList(const PlyProperty& property, std::uint64_t count) {
        double ignored = 0.0;
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!scalar(property, property.type, ignored)) return false;
        }
        return true;
    }
    /// After the last element nothing may be left.
    bool finish() {
        if (!lines_.nextContent()) return true;
        return fail(
            "the file goes on after the last row that its header announces; correct the "
            "counts in the header");
    }

  private:
    LineReader lines_;
    Fields fields_;
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

    bool fail(const std::string& what) { return failAt(place(at_), what); }

    bool checkRoom(const PlyElement& element) {
        const std::uint64_t room = left() / leastRowSize(element);
        if (element.count <= room) return true;
        enter(element, room);
        return element.hasList() ? failAt(place(bytes_.size()), tooMany(element))
                                 : failCut(place(bytes_.size()));
    }
    bool beginRow(const PlyElement& element, std::uint64_t row) {
        enter(element, row);
        return true;
    }
    bool endRow() { return true; }
    bool scalar(const PlyProperty&, ScalarType type, double& value) {
        return withScalar(type, [&](auto zero) {
            if (left() < sizeof(zero)) return failCut(place(bytes_.size()));
            value = static_cast<double>(loadScalar<decltype(zero)>(bytes_.data() + at_, swapped_));
            at_ += sizeof(zero);
            return true;
        });
    }
    bool skipList(const PlyProperty& property, std::uint64_t count) {
        const std::size_t size = sizeOf(property.type);
        if (count > left() / size) return failCut(place(bytes_.size()));
        at_ += static_cast<std::size_t>(count) * size;
        return true;
    }
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
    static std::string place(std::size_t byte) { return "byte " + std::to_string(byte); }
    /// The size of a row whose lists are all empty.
    static std::size_t leastRowSize(const PlyElement& element) {
        std::size_t size = 0;
        for (const PlyProperty& p : element.properties)
            size += sizeOf(p.isList ? p.countType : p.type);
        return size;
    }
    static std::string tooMany(const PlyElement& element) {
        return "the file ends too early to hold the " + std::to_string(element.count) +
               " rows of element " + inQuotes(element.name) +
               "; it is cut short, or its header announces too many";
    }

    std::string_view bytes_;
    std::size_t at_;
    bool swapped_;
};

}  // namespace se::io
