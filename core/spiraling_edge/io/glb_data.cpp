// Sizes are compared by differences and quotients, so that no number of a file overflows.
#include "spiraling_edge/io/glb_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

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

}  // namespace

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

std::uint32_t GlbData::wordAt(std::size_t byte) const {
    return loadScalar<std::uint32_t>(bytes_.data() + byte, kLittleIsSwapped);
}

bool GlbData::readChunk(std::size_t& at, std::uint32_t type, const char* kind,
                        std::string_view& chunk) {
    if (bytes_.size() - at < kChunkHead || wordAt(at + 4) != type)
        return fail(at, std::string("expected the chunk ") + kind);
    const std::size_t size = wordAt(at);
    if (size > bytes_.size() - at - kChunkHead) {
        return fail(bytes_.size(), std::string("the file ends within its chunk ") + kind + " of " +
                                       std::to_string(size) + " bytes; it is cut short");
    }
    chunk = bytes_.substr(at + kChunkHead, size);
    at += kChunkHead + size;
    return true;
}

bool GlbData::readChunks() {
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
    Result<JsonValue> root = parseJson(json, name_, kGlbHeader + kChunkHead);
    if (root) {
        root_ = std::move(root.value());
        return true;
    }
    problem_ = root.error();
    return false;
}

bool GlbData::readDocument() {
    if (!readChunks()) return false;
    for (const JsonValue& extension : root_.member("extensionsRequired").items) {
        if (isHarmless(extension.text)) continue;
        return fail(extension.at, "the file needs the extension " + inQuotes(extension.text) +
                                      ", which cannot be read; export it without, e.g. without "
                                      "compression");
    }
    for (const JsonValue& buffer : root_.member("buffers").items) {
        if (buffer.member("uri").isThere())
            return fail(buffer.at, "the data are not in the chunk BIN; export it as one GLB file");
    }
    return true;
}

bool GlbData::readNumber(const JsonValue& value, std::string_view list, const char* noun,
                         std::size_t& number) {
    const std::size_t count = document(list).items.size();
    if (!isWholeNumber(value, static_cast<double>(count))) {
        return fail(value.at, "expected the number of one of the " + counted(count, noun) +
                                  " of the file, from 0");
    }
    number = static_cast<std::size_t>(value.number);
    return true;
}

bool GlbData::readSize(const JsonValue& value, std::uint64_t& size) {
    if (value.isThere() && !isWholeNumber(value, kGreatestWhole))
        return fail(value.at, "expected a whole number from 0");
    size = static_cast<std::uint64_t>(value.number);
    return true;
}

bool GlbData::readAccessor(const JsonValue& reference, std::size_t width, GlbAccessor& accessor) {
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
    const auto* const type = std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& each) {
        return value.member("componentType").number == each.first;
    });
    const auto* const shape = std::find_if(kWidths.begin(), kWidths.end(), [&](const auto& each) {
        return value.member("type").text == each.first;
    });
    if (type == kTypes.end() || shape == kWidths.end() ||
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

/// The bytes of an accessor, which must lie within its view, and that within the chunk.
bool GlbData::readView(const JsonValue& value, GlbAccessor& accessor) {
    std::size_t number = 0;
    if (!readNumber(value.member("bufferView"), "bufferViews", "buffer view", number)) return false;
    const JsonValue& view = document("bufferViews").item(number);
    std::uint64_t buffer = 0;
    std::uint64_t begin = 0;
    std::uint64_t size = 0;
    std::uint64_t stride = 0;
    std::uint64_t offset = 0;
    std::uint64_t count = 0;
    if (!readSize(view.member("buffer"), buffer) || !readSize(view.member("byteOffset"), begin) ||
        !readSize(view.member("byteLength"), size) ||
        !readSize(view.member("byteStride"), stride) ||
        !readSize(value.member("byteOffset"), offset) || !readSize(value.member("count"), count))
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

}  // namespace se::io
