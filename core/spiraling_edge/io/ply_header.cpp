#include <array>

#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/ply.h"

namespace se::io {
namespace {

/// The other names of types than nameOf(), by ScalarType.
constexpr std::array<std::string_view, 8> kSizedTypeNames{"int8",  "uint8",  "int16",   "uint16",
                                                          "int32", "uint32", "float32", "float64"};
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
        for (std::size_t i = 0; i < kFormatNames.size(); ++i) {
            header_.format = static_cast<PlyFormat>(i);
            if (format == kFormatNames[i]) return true;
        }
        return fail("expected ascii, binary_little_endian or binary_big_endian, found " +
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
        for (const PlyElement& other : header_.elements) {
            if (other.name == element.name) {
                return fail("element " + inQuotes(element.name) + " is announced twice");
            }
        }
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool readType(std::string_view field, ScalarType& type) {
        for (std::size_t i = 0; i < kSizedTypeNames.size(); ++i) {
            type = static_cast<ScalarType>(i);
            if (field == nameOf(type) || field == kSizedTypeNames[i]) return true;
        }
        return fail(
            "expected a type: char, uchar, short, ushort, int, uint, float or double; found " +
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
        PlyElement& element = header_.elements.back();
        for (const PlyProperty& other : element.properties) {
            if (other.name == property.name) {
                return fail("property " + inQuotes(property.name) + " is announced twice");
            }
        }
        element.properties.push_back(std::move(property));
        return true;
    }

    PlyHeader header_;
    bool hasFormat_ = false;
};

}  // namespace

Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace se::io
