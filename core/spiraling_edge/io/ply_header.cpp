#include <optional>

#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/ply.h"

namespace se::io {
namespace {

std::optional<ScalarType> scalarTypeNamed(std::string_view name) {
    struct Named {
        std::string_view name;
        ScalarType type;
    };
    constexpr Named kTypes[] = {
        {"char", ScalarType::Int8},     {"int8", ScalarType::Int8},
        {"uchar", ScalarType::UInt8},   {"uint8", ScalarType::UInt8},
        {"short", ScalarType::Int16},   {"int16", ScalarType::Int16},
        {"ushort", ScalarType::UInt16}, {"uint16", ScalarType::UInt16},
        {"int", ScalarType::Int32},     {"int32", ScalarType::Int32},
        {"uint", ScalarType::UInt32},   {"uint32", ScalarType::UInt32},
        {"float", ScalarType::Float},   {"float32", ScalarType::Float},
        {"double", ScalarType::Double}, {"float64", ScalarType::Double},
    };
    for (const Named& known : kTypes) {
        if (known.name == name) return known.type;
    }
    return std::nullopt;
}

class HeaderReader {
  public:
    HeaderReader(std::string_view bytes, const std::string& name)
        : bytes_(bytes), lines_(bytes), name_(name) {}

    Result<PlyHeader> read() {
        lines_.next();  // "ply", checked by the caller
        bool ended = false;
        while (!ended && lines_.next()) {
            Fields fields(lines_.line());
            const std::string_view keyword = fields.next();
            ended = keyword == "end_header";
            if (!ended && !readStatement(keyword, fields)) return problem_;
        }
        if (!ended) {
            fail(
                "the file ends within its header, before the line \"end_header\"; it is cut short");
            return problem_;
        }
        if (!hasFormat_) {
            fail("the header has no line \"format\", so the rows cannot be read");
            return problem_;
        }
        header_.size = bytes_.size() - lines_.rest().size();
        header_.lines = lines_.number();
        return std::move(header_);
    }

  private:
    bool fail(const std::string& what) {
        problem_ = errorAt(name_, lineText(lines_.number()), what);
        return false;
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
        if (format == "ascii") {
            header_.format = PlyFormat::Ascii;
        } else if (format == "binary_little_endian") {
            header_.format = PlyFormat::LittleEndian;
        } else if (format == "binary_big_endian") {
            header_.format = PlyFormat::BigEndian;
        } else {
            return fail("expected ascii, binary_little_endian or binary_big_endian, found " +
                        inQuotes(format));
        }
        return true;
    }

    bool readElement(Fields& fields) {
        PlyElement element;
        element.name = fields.next();
        element.line = lines_.number();
        const std::string_view field = fields.next();
        std::int64_t count = 0;
        if (!parseInteger(field, count) || count < 0) {
            return fail("expected \"element NAME COUNT\", found " + inQuotes(field) +
                        " for the count");
        }
        element.count = static_cast<std::uint64_t>(count);
        for (const PlyElement& other : header_.elements) {
            if (other.name == element.name) {
                return fail("element " + inQuotes(element.name) + " is announced twice");
            }
        }
        header_.elements.push_back(std::move(element));
        return true;
    }

    bool readType(std::string_view field, ScalarType& type) {
        const std::optional<ScalarType> known = scalarTypeNamed(field);
        if (!known) {
            return fail(
                "expected a type: char, uchar, short, ushort, int, uint, float or double; "
                "found " +
                inQuotes(field));
        }
        type = *known;
        return true;
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

    std::string_view bytes_;
    LineReader lines_;
    const std::string& name_;
    PlyHeader header_;
    Error problem_;
    bool hasFormat_ = false;
};

}  // namespace

Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name) {
    return HeaderReader(bytes, name).read();
}

}  // namespace se::io
