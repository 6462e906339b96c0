/// The binary mesh formats: STL and GLB (binary glTF 2.0).
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/io/mesh_formats.h"

namespace se::io {
namespace {

/// Little endian. Four at a time: one by one a mesh of two million triangles takes half a second.
void append(std::string& bytes, std::uint32_t value) {
    std::array<char, 4> four{};
    for (unsigned i = 0; i < 4; ++i) four[i] = static_cast<char>((value >> (8 * i)) & 0xFFU);
    bytes.append(four.data(), four.size());
}
void append(std::string& bytes, float value) { append(bytes, bitsAs<std::uint32_t>(value)); }
void append(std::string& bytes, const Vec3& v) {
    for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(v[i]));
}

/// The first 80 bytes. They must not begin with "solid", as text does.
std::string stlHeader(const std::optional<Vec3>& shift) {
    constexpr std::size_t kSize = 80;
    std::string text = "written by spiraling-edge";
    if (shift) {
        std::string sum = "add";
        for (int i = 0; i < 3; ++i) {
            sum += ' ';
            appendPlainNumber(sum, (*shift)[i]);
        }
        // Three of the longest doubles leave no room for the name.
        text = text.size() + 2 + sum.size() <= kSize ? text + "; " + sum : sum;
    }
    text.resize(kSize, ' ');
    return text;
}

}  // namespace

std::string stlBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    constexpr std::size_t kRow = 50;
    const std::optional<Vec3> found = floatShift(points, triangles);
    const Vec3 shift = found.value_or(Vec3(0.0));
    std::string bytes = stlHeader(found);
    bytes.reserve(bytes.size() + 4 + kRow * triangles.size());
    append(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& t : triangles) {
        const Vec3& a = points.position[t.a];
        const Vec3& b = points.position[t.b];
        const Vec3& c = points.position[t.c];
        const Vec3 area = glm::cross(b - a, c - a);
        const double size = std::sqrt(glm::dot(area, area));
        append(bytes, size > 0.0 ? area / size : Vec3(0.0));
        append(bytes, a - shift);
        append(bytes, b - shift);
        append(bytes, c - shift);
        bytes.append(2, '\0');
    }
    return bytes;
}

// ---- GLB ----------------------------------------------------------------------------------------

namespace {

Vec3 asFloats(const Vec3& v) { return {asFloat(v.x), asFloat(v.y), asFloat(v.z)}; }

struct Bounds {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};
    void add(const Vec3& x) {
        low = glm::min(low, x);
        high = glm::max(high, x);
    }
    /// The center as floats, which every program preserves; as doubles where floats are too coarse
    /// to be near the points.
    Vec3 middle() const {
        const Vec3 exact = 0.5 * (low + high);
        const Vec3 size = high - low;
        const Vec3 coarse = asFloats(exact);
        const Vec3 off = glm::abs(coarse - exact);
        const bool near = std::max({off.x, off.y, off.z}) <= std::max({size.x, size.y, size.z});
        return near ? coarse : exact;
    }
};

/// "[x,y,z]" with digits that read back exactly.
std::string jsonOf(const Vec3& v) {
    std::string text = "[";
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text += ',';
        appendNumber(text, v[i]);
    }
    return text + ']';
}

/// glTF requires unit normals; those without a direction become +z.
Vec3 unitNormal(const Vec3& n) {
    const double length = std::sqrt(glm::dot(n, n));
    return isFinite(n) && length > 0.0 ? n / length : Vec3(0, 0, 1);
}

/// The JSON and the binary chunk of a GLB file, while they grow.
class GlbParts {
  public:
    GlbParts(const PointFile& points, std::span<const Triangle> triangles)
        : points_(points), triangles_(triangles) {}

    std::string file() {
        addPositions();
        if (points_.hasNormals()) addNormals();
        addIndices();
        const auto pad = [](std::string& chunk, char sign) {
            while (chunk.size() % 4 != 0) chunk += sign;
        };
        std::string json = document();
        pad(json, ' ');
        pad(binary_, '\0');
        constexpr std::uint32_t kMagic = 0x46546C67;
        constexpr std::uint32_t kJson = 0x4E4F534A;
        constexpr std::uint32_t kBinary = 0x004E4942;
        constexpr std::uint32_t kHeads = 12 + 8 + 8;
        std::string bytes;
        append(bytes, kMagic);
        append(bytes, std::uint32_t{2});
        append(bytes, kHeads + static_cast<std::uint32_t>(json.size() + binary_.size()));
        append(bytes, static_cast<std::uint32_t>(json.size()));
        append(bytes, kJson);
        bytes += json;
        append(bytes, static_cast<std::uint32_t>(binary_.size()));
        append(bytes, kBinary);
        return bytes + binary_;
    }

  private:
    /// Adds a view of the bytes since `begin`, and an accessor to it.
    void describe(std::size_t begin, int target, int type, std::size_t count, const char* shape,
                  const std::string& more = {}) {
        const auto comma = [](const std::string& list) { return list.empty() ? "" : ","; };
        accessors_ +=
            std::string(comma(accessors_)) + "{\"bufferView\":" + std::to_string(views_++) +
            ",\"componentType\":" + std::to_string(type) + ",\"count\":" + std::to_string(count) +
            ",\"type\":\"" + shape + "\"" + more + "}";
        bufferViews_ += std::string(comma(bufferViews_)) +
                        "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                        ",\"byteLength\":" + std::to_string(binary_.size() - begin) +
                        ",\"target\":" + std::to_string(target) + "}";
    }

    void addPositions() {
        Bounds whole;
        for (const Vec3& x : points_.position) {
            if (isFinite(x)) whole.add(x);
        }
        if (whole.low.x <= whole.high.x) middle_ = whole.middle();
        Bounds moved;
        for (const Vec3& x : points_.position) {
            const Vec3 place = isFinite(x) ? asFloats(x - middle_) : Vec3(0.0);
            moved.add(place);
            append(binary_, place);
        }
        describe(0, kVertices, kFloat, points_.position.size(), "VEC3",
                 ",\"min\":" + jsonOf(moved.low) + ",\"max\":" + jsonOf(moved.high));
    }
    void addNormals() {
        const std::size_t begin = binary_.size();
        for (const Vec3& n : points_.normal) append(binary_, unitNormal(n));
        describe(begin, kVertices, kFloat, points_.normal.size(), "VEC3");
    }
    void addIndices() {
        if (triangles_.empty()) return;
        const std::size_t begin = binary_.size();
        for (const Triangle& t : triangles_) {
            for (const Index corner : {t.a, t.b, t.c}) append(binary_, corner);
        }
        describe(begin, kIndices, kUnsigned, 3 * triangles_.size(), "SCALAR");
    }

    std::string document() const {
        std::string primitive = "{\"attributes\":{\"POSITION\":0";
        if (points_.hasNormals()) primitive += ",\"NORMAL\":1";
        primitive += "},\"mode\":";
        primitive += triangles_.empty()
                         ? "0"
                         : "4,\"indices\":" + std::to_string(points_.hasNormals() ? 2 : 1);
        primitive += "}";
        return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"spiraling-edge\"},\"scene\":0,"
               "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":" +
               jsonOf(middle_) + "}],\"meshes\":[{\"primitives\":[" + primitive +
               "]}],\"accessors\":[" + accessors_ + "],\"bufferViews\":[" + bufferViews_ +
               "],\"buffers\":[{\"byteLength\":" + std::to_string(binary_.size()) + "}]}";
    }

    static constexpr int kVertices = 34962;
    static constexpr int kIndices = 34963;
    static constexpr int kFloat = 5126;
    static constexpr int kUnsigned = 5125;

    const PointFile& points_;
    std::span<const Triangle> triangles_;
    std::string binary_, accessors_, bufferViews_;
    Vec3 middle_{0.0};
    int views_ = 0;
};

}  // namespace

std::string glbBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    return GlbParts(points, triangles).file();
}

}  // namespace se::io
