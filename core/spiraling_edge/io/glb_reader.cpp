// GLB, binary glTF 2.0: the triangles and points of the scene, each mesh where its nodes place it.
// Vertices of triangles at the same place are one point, as in STL: a hard edge or a seam of a
// texture has several.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/merged_points.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

// ---- the document -------------------------------------------------------------------------------

// JSON by recursive descent (RFC 8259), with a limit of levels so that no text exhausts the stack:
// a tree of values that know their place, for errors.

/// A value of a JSON text.
struct JsonValue {
    enum class Kind : std::uint8_t { Missing, Null, Boolean, Number, Text, List, Object };

    Kind kind = Kind::Missing;
    std::size_t at = 0;              ///< Its first byte in the file.
    double number = 0.0;             ///< 1 for true.
    std::string text;                ///< Characters beyond ASCII by \u are "?".
    std::vector<std::string> names;  ///< Of the members of an object.
    std::vector<JsonValue> items;    ///< Members of an object, or values of a list.

    bool isThere() const { return kind != Kind::Missing; }
    bool isList() const { return kind == Kind::List; }
    /// The first member of that name; one that is missing for any other name or kind.
    const JsonValue& member(std::string_view name) const;
    /// The value at a place of a list; one that is missing beyond its end.
    const JsonValue& item(std::size_t i) const;
};

const JsonValue kMissingJson{};

const JsonValue& JsonValue::member(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? kMissingJson
                                : items[static_cast<std::size_t>(found - names.begin())];
}

const JsonValue& JsonValue::item(std::size_t i) const {
    return isList() && i < items.size() ? items[i] : kMissingJson;
}

constexpr int kMostLevels = 64;
constexpr std::size_t kMostValues = 2'000'000;  // About 250 MB of memory.

/// Parses a whole JSON text that begins at the byte `begin` of the file: at most 64 levels of lists
/// and objects, 2,000,000 values, and no number beyond the largest double. Errors name the byte.
class JsonParser : FirstProblem {
  public:
    JsonParser(std::string_view text, const std::string& name, std::size_t begin)
        : FirstProblem(name), text_(text), begin_(begin) {}

    Result<JsonValue> parse() {
        JsonValue root;
        if (!readValue(root, 0)) return problem_;
        skipBlanks();
        if (at_ < text_.size() && !fail("the JSON text goes on after its end")) return problem_;
        return root;
    }

  private:
    bool fail(const std::string& what) { return FirstProblem::fail(begin_ + at_, what); }
    bool failExpected(const char* what) {
        return fail(at_ >= text_.size() ? std::string("the JSON text ends within a value")
                                        : "expected " + std::string(what) + " in the JSON text");
    }
    void skipBlanks() {
        while (at_ < text_.size() && (isSpace(text_[at_]) || text_[at_] == '\n')) ++at_;
    }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    bool readValue(JsonValue& value, int level) {
        skipBlanks();
        value.at = begin_ + at_;
        if (level > kMostLevels) return fail("the JSON text has more than 64 levels");
        if (++values_ > kMostValues) return fail("the JSON text has more than 2,000,000 values");
        if (take('{')) return readItems(value, JsonValue::Kind::Object, level);
        if (take('[')) return readItems(value, JsonValue::Kind::List, level);
        if (at_ < text_.size() && text_[at_] == '"') {
            value.kind = JsonValue::Kind::Text;
            return readText(value.text);
        }
        return readWord(value);
    }

    /// The rest of a list, or of an object, whose members have names.
    bool readItems(JsonValue& value, JsonValue::Kind kind, int level) {
        value.kind = kind;
        const bool named = kind == JsonValue::Kind::Object;
        const char end = named ? '}' : ']';
        skipBlanks();
        if (take(end)) return true;
        do {
            skipBlanks();
            if (named && !readText(value.names.emplace_back())) return false;
            // Members are looked up one by one.
            constexpr std::size_t kMostNames = 1000;
            if (value.names.size() > kMostNames)
                return fail("an object of the JSON text has more than 1,000 names");
            skipBlanks();
            if (named && !take(':')) return failExpected("\":\"");
            if (!readValue(value.items.emplace_back(), level + 1)) return false;
            skipBlanks();
        } while (take(','));
        return take(end) || failExpected(named ? "\",\" or \"}\"" : "\",\" or \"]\"");
    }

    bool readText(std::string& text) {
        if (!take('"')) return failExpected("a name in quotation marks");
        constexpr std::string_view kEscapes = "bfnrt";
        constexpr std::string_view kMeanings = "\b\f\n\r\t";
        while (at_ < text_.size() && text_[at_] != '"') {
            char c = text_[at_++];
            if (c == '\\' && at_ < text_.size()) {
                c = text_[at_++];
                const std::size_t known = kEscapes.find(c);
                if (known != std::string_view::npos) c = kMeanings[known];
                if (c == 'u') {
                    at_ = std::min(at_ + 4, text_.size());
                    c = '?';
                }
            }
            text += c;
        }
        return take('"') || failExpected("a quotation mark");
    }

    /// A number, or one of the three words.
    bool readWord(JsonValue& value) {
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]}:[{\"", at_), text_.size());
        const std::string_view word = text_.substr(at_, end - at_);
        if (word == "null") {
            value.kind = JsonValue::Kind::Null;
        } else if (word == "true" || word == "false") {
            value.kind = JsonValue::Kind::Boolean;
            value.number = word == "true" ? 1.0 : 0.0;
        } else if (parseDouble(word, value.number) && std::isfinite(value.number)) {
            value.kind = JsonValue::Kind::Number;
        } else {
            return failExpected("a value");
        }
        at_ = end;
        return true;
    }

    std::string_view text_;
    std::size_t begin_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
};

// ---- numbers ------------------------------------------------------------------------------------

// Sizes are compared by differences and quotients, so that no number of a file overflows.

constexpr std::size_t kGlbHeader = 12;  // Magic, version and length.
constexpr std::size_t kChunkHead = 8;   // Length and type of a chunk.

/// True for an extension that a file may require: it changes neither places nor triangles, or is
/// read here.
bool isHarmless(std::string_view extension) {
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_texture_") ||
           extension.starts_with("EXT_texture_") || extension == "KHR_lights_punctual" ||
           extension == "KHR_mesh_quantization";
}

bool isWholeNumber(const JsonValue& value, double below) {
    return value.kind == JsonValue::Kind::Number && value.number >= 0.0 && value.number < below &&
           value.number == std::floor(value.number);
}

/// Numbers of the binary chunk, known to lie within it.
struct GlbAccessor {
    const char* first = nullptr;
    std::size_t stride = 0;  ///< Bytes from one element to the next.
    std::size_t count = 0;   ///< Elements.
    std::size_t width = 0;   ///< Numbers of an element.
    ScalarType type = ScalarType::Float;
    bool normalized = false;  ///< Whole numbers stand for 0 to 1, or -1 to 1.

    /// The first three numbers of each element, of at least three.
    std::vector<Vec3> vectors() const;
    /// The only number of each element.
    std::vector<double> numbers() const;
};

std::vector<Vec3> GlbAccessor::vectors() const {
    std::vector<Vec3> values(count, Vec3(0.0));
    for (std::size_t axis = 0; axis < 3 && count > 0; ++axis) {
        Column{&values[0][static_cast<int>(axis)], 3}.load(type, first + axis * sizeOf(type),
                                                           stride, count, kLittleIsSwapped);
    }
    if (!normalized || !isInteger(type)) return values;
    const double most = withScalar(type, [](auto zero) {
        return static_cast<double>(std::numeric_limits<decltype(zero)>::max());
    });
    for (Vec3& value : values) value = glm::max(value / most, Vec3(-1.0));
    return values;
}

std::vector<double> GlbAccessor::numbers() const {
    std::vector<double> values(count);
    Column{values.data(), 1}.load(type, first, stride, count, kLittleIsSwapped);
    return values;
}

/// Reads the two chunks of a file, and the accessors that its document names. Members that return
/// false have set the problem, with its byte.
class GlbData : protected FirstProblem {
  protected:
    GlbData(std::string_view bytes, const std::string& name) : FirstProblem(name), bytes_(bytes) {}

    /// Reads the chunks. Fails for extensions that change places or triangles, and for data in
    /// other files.
    bool readDocument() {
        if (!readChunks()) return false;
        for (const JsonValue& extension : root_.member("extensionsRequired").items) {
            if (isHarmless(extension.text)) continue;
            return fail(extension.at, "the file needs the extension " + inQuotes(extension.text) +
                                          ", which cannot be read; export it without, e.g. without "
                                          "compression");
        }
        for (const JsonValue& buffer : root_.member("buffers").items) {
            if (buffer.member("uri").isThere())
                return fail(buffer.at,
                            "the data are not in the chunk BIN; export it as one GLB file");
        }
        return true;
    }

    const JsonValue& document(std::string_view member) const { return root_.member(member); }
    std::size_t fileSize() const { return bytes_.size(); }

    /// The number of an item of a list of the document; `noun` is one of them.
    bool readNumber(const JsonValue& value, std::string_view list, const char* noun,
                    std::size_t& number) {
        const std::size_t count = document(list).items.size();
        if (!isWholeNumber(value, static_cast<double>(count))) {
            return fail(value.at, "expected the number of one of the " + counted(count, noun) +
                                      " of the file, from 0");
        }
        number = static_cast<std::size_t>(value.number);
        return true;
    }

    /// A whole number; 0 where it is missing.
    bool readSize(const JsonValue& value, std::uint64_t& size) {
        if (value.isThere() && !isWholeNumber(value, kGreatestWhole))
            return fail(value.at, "expected a whole number from 0");
        size = static_cast<std::uint64_t>(value.number);
        return true;
    }

    /// An accessor of single numbers (`width` 1), or of vectors of at least `width` numbers.
    bool readAccessor(const JsonValue& reference, std::size_t width, GlbAccessor& accessor) {
        static constexpr std::array<std::pair<double, ScalarType>, 6> kTypes{
            {{5120, ScalarType::Int8},
             {5121, ScalarType::UInt8},
             {5122, ScalarType::Int16},
             {5123, ScalarType::UInt16},
             {5125, ScalarType::UInt32},
             {5126, ScalarType::Float}}};
        static constexpr std::array<std::pair<std::string_view, std::size_t>, 4> kWidths{
            {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
        std::size_t number = 0;
        if (!readNumber(reference, "accessors", "accessor", number)) return false;
        const JsonValue& value = document("accessors").item(number);
        if (value.member("sparse").isThere() || !value.member("bufferView").isThere()) {
            return fail(value.at,
                        "sparse or compressed data cannot be read; export the file without them");
        }
        const auto* const type = rowWhere(kTypes, [&](const auto& each) {
            return value.member("componentType").number == each.first;
        });
        const auto* const shape = rowWhere(
            kWidths, [&](const auto& each) { return value.member("type").text == each.first; });
        if (type == nullptr || shape == nullptr ||
            (width == 1 ? shape->second != 1 : shape->second < width)) {
            return fail(value.at, std::string("expected an accessor of ") +
                                      (width == 1 ? "single numbers" : "vectors of three numbers") +
                                      ", of a type that glTF names");
        }
        accessor.type = type->second;
        accessor.width = shape->second;
        accessor.normalized = value.member("normalized").number == 1.0;
        return readView(value, accessor);
    }

  private:
    std::uint32_t wordAt(std::size_t byte) const {
        return loadScalar<std::uint32_t>(bytes_.data() + byte, kLittleIsSwapped);
    }

    bool readChunk(std::size_t& at, std::uint32_t type, const char* kind, std::string_view& chunk) {
        if (bytes_.size() - at < kChunkHead || wordAt(at + 4) != type)
            return fail(at, std::string("expected the chunk ") + kind);
        const std::size_t size = wordAt(at);
        if (size > bytes_.size() - at - kChunkHead) {
            return fail(bytes_.size(), std::string("the file ends within its chunk ") + kind +
                                           " of " + std::to_string(size) +
                                           " bytes; it is cut short");
        }
        chunk = bytes_.substr(at + kChunkHead, size);
        at += kChunkHead + size;
        return true;
    }

    bool readChunks() {
        constexpr std::uint32_t kJson = 0x4E4F534A;
        constexpr std::uint32_t kBinary = 0x004E4942;
        if (bytes_.size() < kGlbHeader)
            return fail(bytes_.size(), "the file ends within its header of 12 bytes");
        if (wordAt(4) != 2) {
            return fail(4, "expected version 2, found " + std::to_string(wordAt(4)) +
                               "; export it as glTF 2.0");
        }
        if (wordAt(8) > bytes_.size()) {
            return fail(bytes_.size(), "the header announces " + std::to_string(wordAt(8)) +
                                           " bytes; the file is cut short");
        }
        std::size_t at = kGlbHeader;
        std::string_view json;
        if (!readChunk(at, kJson, "JSON", json)) return false;
        if (at < bytes_.size() && !readChunk(at, kBinary, "BIN", binary_)) return false;
        Result<JsonValue> root = JsonParser(json, name_, kGlbHeader + kChunkHead).parse();
        if (root) {
            root_ = std::move(root.value());
            return true;
        }
        problem_ = root.error();
        return false;
    }

    /// The bytes of an accessor, which must lie within its view, and that within the chunk.
    bool readView(const JsonValue& value, GlbAccessor& accessor) {
        std::size_t number = 0;
        if (!readNumber(value.member("bufferView"), "bufferViews", "buffer view", number))
            return false;
        const JsonValue& view = document("bufferViews").item(number);
        std::uint64_t buffer = 0;
        std::uint64_t begin = 0;
        std::uint64_t size = 0;
        std::uint64_t stride = 0;
        std::uint64_t offset = 0;
        std::uint64_t count = 0;
        if (!readSize(view.member("buffer"), buffer) ||
            !readSize(view.member("byteOffset"), begin) ||
            !readSize(view.member("byteLength"), size) ||
            !readSize(view.member("byteStride"), stride) ||
            !readSize(value.member("byteOffset"), offset) ||
            !readSize(value.member("count"), count))
            return false;
        if (buffer != 0 || begin > binary_.size() || size > binary_.size() - begin)
            return fail(view.at, "the buffer view ends beyond the chunk BIN");
        const std::uint64_t element = accessor.width * sizeOf(accessor.type);
        if (stride == 0) stride = element;
        const bool fits = offset <= size && stride >= element &&
                          (count == 0 || (size - offset >= element &&
                                          count - 1 <= (size - offset - element) / stride));
        if (!fits) {
            return fail(value.at, counted(count, "element") +
                                      " of the accessor do not fit into its buffer view of " +
                                      counted(size, "byte"));
        }
        accessor.first = binary_.data() + begin + offset;
        accessor.stride = static_cast<std::size_t>(stride);
        accessor.count = static_cast<std::size_t>(count);
        return true;
    }

    std::string_view bytes_;
    std::string_view binary_;
    JsonValue root_;
};

// ---- the scene ----------------------------------------------------------------------------------

/// Nodes may place a mesh many times: a small file could ask for any number of points. A file may
/// have this many (about 1.5 GB of memory), and one more for each of its bytes.
constexpr std::size_t kMostPlaced = 2'000'000;

/// Modes of primitives.
constexpr std::uint64_t kModePoints = 0;
constexpr std::uint64_t kModeList = 4;
constexpr std::uint64_t kModeStrip = 5;
constexpr std::uint64_t kModeFan = 6;

/// The place of a mesh in the scene.
class Placement {
  public:
    explicit Placement(const glm::dmat4& matrix)
        : matrix_(matrix), linear_(matrix), mirrors_(glm::determinant(linear_) < 0.0) {}

    bool mirrors() const { return mirrors_; }
    Vec3 place(const Vec3& x) const { return {matrix_ * glm::dvec4(x, 1.0)}; }
    /// By the inverse of the transpose, up to its length; as it is where the mesh is not turned.
    Vec3 normal(const Vec3& n) const {
        if (linear_ == glm::dmat3(1.0)) return n;
        const Vec3 turned = n.x * glm::cross(linear_[1], linear_[2]) +
                            n.y * glm::cross(linear_[2], linear_[0]) +
                            n.z * glm::cross(linear_[0], linear_[1]);
        return mirrors_ ? -turned : turned;
    }

  private:
    glm::dmat4 matrix_;
    glm::dmat3 linear_;
    bool mirrors_;
};

class GlbReader : GlbData {
  public:
    GlbReader(std::string_view bytes, const std::string& name) : GlbData(bytes, name) {}

    Result<PointFile> read() {
        if (!readDocument() || !placeNodes()) return problem_;
        takePoints();
        return std::move(file_);
    }

  private:
    /// A node to place, with the matrix of the one around it.
    using OpenNode = std::pair<std::size_t, glm::dmat4>;

    bool openNodes(const JsonValue& list, const glm::dmat4& matrix) {
        for (const JsonValue& each : list.items) {
            std::size_t number = 0;
            if (!readNumber(each, "nodes", "node", number)) return false;
            open_.emplace_back(number, matrix);
        }
        return true;
    }

    /// Places the meshes of all nodes of the scene, with a stack: files may nest them deeply.
    bool placeNodes() {
        const JsonValue& chosen = document("scene");
        std::size_t scene = 0;
        if (chosen.isThere() && !readNumber(chosen, "scenes", "scene", scene)) return false;
        if (!document("scenes").isThere() && document("nodes").isThere())
            return fail(document("nodes").at, "the file has nodes, but no scene that places them");
        if (!openNodes(document("scenes").item(scene).member("nodes"), glm::dmat4(1.0)))
            return false;
        std::vector<bool> seen(document("nodes").items.size(), false);
        while (!open_.empty()) {
            const auto [number, outer] = open_.back();
            open_.pop_back();
            const JsonValue& node = document("nodes").item(number);
            if (seen[number]) return fail(node.at, "the node is in two others, or in itself");
            seen[number] = true;
            glm::dmat4 own(1.0);
            if (!readMatrix(node, own)) return false;
            if (node.member("skin").isThere()) leftOut_.insert("skins: meshes are as stored");
            for (const std::string& name : node.member("extensions").names) {
                if (!isHarmless(name)) leftOut_.insert("extension " + excerpt(name) + " of nodes");
            }
            if (!placeMesh(node.member("mesh"), outer * own) ||
                !openNodes(node.member("children"), outer * own))
                return false;
        }
        return true;
    }

    /// Reads a list of as many numbers; they stay where there is no such member.
    template <std::size_t count>
    bool readNumbers(const JsonValue& list, std::array<double, count>& values) {
        if (!list.isThere()) return true;
        for (std::size_t i = 0; i < count; ++i) {
            if (list.item(i).kind != JsonValue::Kind::Number || list.items.size() != count)
                return fail(list.at, "expected " + std::to_string(count) + " numbers");
            values[i] = list.items[i].number;
        }
        return true;
    }
    /// The matrix of a node, column by column, or its scale, rotation (x y z w) and translation.
    bool readMatrix(const JsonValue& node, glm::dmat4& matrix) {
        std::array<double, 16> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        std::array<double, 3> move{0, 0, 0};
        std::array<double, 4> turn{0, 0, 0, 1};
        std::array<double, 3> scale{1, 1, 1};
        if (!readNumbers(node.member("matrix"), columns) ||
            !readNumbers(node.member("translation"), move) ||
            !readNumbers(node.member("rotation"), turn) ||
            !readNumbers(node.member("scale"), scale))
            return false;
        if (node.member("matrix").isThere()) {
            for (std::size_t i = 0; i < columns.size(); ++i)
                matrix[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = columns[i];
            return true;
        }
        const glm::dmat3 rotation = glm::mat3_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
        for (int axis = 0; axis < 3; ++axis)
            matrix[axis] = glm::dvec4(rotation[axis] * scale[static_cast<std::size_t>(axis)], 0.0);
        matrix[3] = glm::dvec4(move[0], move[1], move[2], 1.0);
        return true;
    }

    bool placeMesh(const JsonValue& reference, const glm::dmat4& matrix) {
        if (!reference.isThere()) return true;
        std::size_t number = 0;
        if (!readNumber(reference, "meshes", "mesh", number)) return false;
        if (matrix != glm::dmat4(1.0)) file_.positionType = ScalarType::Double;
        vertices_.clear();
        const Placement placement(matrix);
        for (const JsonValue& each : document("meshes").item(number).member("primitives").items) {
            if (!placePrimitive(each, placement)) return false;
        }
        return true;
    }

    bool placePrimitive(const JsonValue& primitive, const Placement& placement) {
        std::uint64_t mode = kModeList;
        if (primitive.member("mode").isThere() && !readSize(primitive.member("mode"), mode))
            return false;
        if (mode > kModeFan) return fail(primitive.at, "expected a mode of triangles from 0 to 6");
        if (primitive.member("targets").isThere()) leftOut_.insert("morph targets");
        if (primitive.member("material").isThere()) leftOut_.insert("materials");
        for (const std::string& name : primitive.member("attributes").names) {
            if (name != "POSITION" && name != "NORMAL" && name != "COLOR_0")
                leftOut_.insert("attribute " + excerpt(name));
        }
        if (mode > kModePoints && mode < kModeList) {
            leftOut_.insert("lines");
            return true;
        }
        const std::vector<Index>* points = nullptr;
        if (!readVertices(primitive, placement, mode != kModePoints, points)) return false;
        if (mode == kModePoints) return true;
        const JsonValue& indices = primitive.member("indices");
        std::vector<Index> corners;
        if (indices.isThere() && !readCorners(indices, *points, corners)) return false;
        addTriangles(mode, placement.mirrors(), indices.isThere() ? corners : *points);
        return true;
    }

    /// Counts what is about to be placed.
    bool mayPlace(const JsonValue& value, std::size_t count) {
        placed_ += count;
        const std::size_t most = kMostPlaced + fileSize();
        return placed_ <= most ||
               fail(value.at, "the nodes place more than " + std::to_string(most) +
                                  " points, which is the limit for a file of this size; export "
                                  "each mesh once");
    }

    /// The points of the vertices of a primitive; those of another primitive of the mesh with the
    /// same attributes are used again.
    bool readVertices(const JsonValue& primitive, const Placement& placement, bool merges,
                      const std::vector<Index>*& points) {
        const JsonValue& attributes = primitive.member("attributes");
        const JsonValue& position = attributes.member("POSITION");
        const JsonValue& normal = attributes.member("NORMAL");
        const JsonValue& color = attributes.member("COLOR_0");
        if (!position.isThere()) return fail(primitive.at, "expected the attribute POSITION");
        GlbAccessor places;
        GlbAccessor normals;
        GlbAccessor colors;
        if (!readAccessor(position, 3, places) ||
            (normal.isThere() && !readAccessor(normal, 3, normals)) ||
            (color.isThere() && !readAccessor(color, 3, colors)))
            return false;
        if ((normal.isThere() && normals.count != places.count) ||
            (color.isThere() && colors.count != places.count))
            return fail(primitive.at, "expected as many normals and colors as positions");
        const auto [known, fresh] =
            vertices_.try_emplace({position.number, normal.isThere() ? normal.number : -1.0,
                                   color.isThere() ? color.number : -1.0, merges ? 1.0 : 0.0});
        points = &known->second;
        if (!fresh) return true;
        if (!mayPlace(position, places.count)) return false;
        if (colors.width > 3) colors_.leaveOutAlpha();
        if (places.type != ScalarType::Float) file_.positionType = ScalarType::Double;
        (normal.isThere() ? withNormals_ : withoutNormals_) += places.count;
        addVertices(places.vectors(), normals.vectors(), colors.vectors(), placement, merges,
                    known->second);
        return true;
    }

    /// `normals` and `colors` may be empty.
    void addVertices(const std::vector<Vec3>& places, const std::vector<Vec3>& normals,
                     const std::vector<Vec3>& colors, const Placement& placement, bool merges,
                     std::vector<Index>& points) {
        points.reserve(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t before = points_.size();
            const Vec3 place = placement.place(places[i]);
            const Vec3 normal = normals.empty() ? Vec3(0.0) : placement.normal(normals[i]);
            points.push_back(merges ? points_.add(place, normal)
                                    : points_.addSeparate(place, normal));
            if (points_.size() == before) {
                ++merged_;
            } else if (!colors.empty()) {
                colors_.add(colors[i]);
            }
        }
    }

    bool readCorners(const JsonValue& reference, const std::vector<Index>& points,
                     std::vector<Index>& corners) {
        GlbAccessor accessor;
        if (!readAccessor(reference, 1, accessor) || !mayPlace(reference, accessor.count / 4))
            return false;
        corners.reserve(accessor.count);
        for (const double number : accessor.numbers()) {
            if (!(number >= 0.0 && number < static_cast<double>(points.size()))) {
                return fail(reference.at, "the indices name a vertex beyond the " +
                                              std::to_string(points.size()) + " of the primitive");
            }
            corners.push_back(points[static_cast<std::size_t>(number)]);
        }
        return true;
    }

    void addTriangles(std::uint64_t mode, bool mirrored, const std::vector<Index>& corners) {
        for (std::size_t i = 0; i + 2 < corners.size(); i += mode == kModeList ? 3 : 1) {
            const Index a = corners[mode == kModeFan ? 0 : i];
            Index b = corners[i + 1];
            Index c = corners[i + 2];
            const bool odd = mode == kModeStrip && i % 2 == 1;
            if (odd != mirrored) std::swap(b, c);
            if (a != b && b != c && c != a) file_.faces.push_back({a, b, c});
        }
    }

    void takePoints() {
        if (withNormals_ > 0 && withoutNormals_ > 0) {
            leftOut_.insert("normals, without those of " +
                            counted(withoutNormals_, "vertex", "vertices"));
        }
        std::size_t averaged = 0;
        for (const std::vector<Vec3>& each : points_.directions()) {
            if (withoutNormals_ > 0) break;
            file_.normal.push_back(each.empty() ? Vec3(0.0) : meanOfDirections(each, averaged));
        }
        file_.position = points_.takePositions();
        if (merged_ > 0) {
            file_.notes.push_back(counted(merged_, "vertex", "vertices") +
                                  " at the place of another one: one point for each place");
        }
        if (averaged > 0) file_.notes.push_back(averagedText(averaged));
        colors_.take(file_);
        for (const std::string& each : leftOut_) file_.notes.push_back("left out: " + each);
    }

    PointFile file_;
    MergedPoints points_;
    PointColors colors_;
    std::vector<OpenNode> open_;
    /// Of the mesh that is placed: points by POSITION, NORMAL, COLOR_0 and whether they merge.
    std::map<std::array<double, 4>, std::vector<Index>> vertices_;
    std::size_t placed_ = 0;
    std::size_t merged_ = 0;
    std::size_t withNormals_ = 0;
    std::size_t withoutNormals_ = 0;
    std::set<std::string> leftOut_;
};

}  // namespace

bool isGlb(const FileStart& start) { return start.bytes.starts_with("glTF"); }

Result<PointFile> readGlb(std::string_view bytes, const std::string& name) {
    return GlbReader(bytes, name).read();
}

}  // namespace se::io
