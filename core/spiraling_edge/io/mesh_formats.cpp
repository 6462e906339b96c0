/// The formats of meshes but PLY: OBJ and OFF as text, STL and GLB (binary glTF 2.0) in binary.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/types.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"
#include "spiraling_edge/points/wall_types.h"

namespace se::io {
namespace {

/// Three numbers that read back exactly.
void appendRow(std::string& text, const Vec3& v, char separator = ' ') {
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text += separator;
        appendNumber(text, v[i]);
    }
}

/// A line of OBJ.
void appendLine(std::string& text, const char* keyword, const Vec3& v) {
    text += keyword;
    appendRow(text, v);
    text += '\n';
}

/// OFF with one normal per point, or with none at all.
std::string offText(std::span<const Vec3> position, std::span<const Vec3> normal,
                    std::span<const Triangle> triangles) {
    std::string text = normal.empty() ? "OFF\n" : "NOFF\n";
    text += std::to_string(position.size()) + ' ' + std::to_string(triangles.size()) + " 0\n";
    for (std::size_t p = 0; p < position.size(); ++p) {
        appendRow(text, position[p]);
        if (!normal.empty()) {
            text += ' ';
            appendRow(text, normal[p]);
        }
        text += '\n';
    }
    for (const Triangle& t : triangles) {
        text += '3';
        for (const Index corner : {t.a, t.b, t.c}) text += ' ' + std::to_string(corner);
        text += '\n';
    }
    return text;
}

}  // namespace

std::string objBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    std::string text = "# written by spiraling-edge\n";
    for (const Vec3& x : points.position) appendLine(text, "v ", x);
    for (const Vec3& n : points.normal) appendLine(text, "vn ", n);
    for (const Triangle& t : triangles) {
        text += 'f';
        for (const Index corner : {t.a, t.b, t.c}) {
            const std::string number = std::to_string(corner + 1);
            text += ' ' + number;
            if (points.hasNormals()) text += "//" + number;
        }
        text += '\n';
    }
    return text;
}

std::string offBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    return offText(points.position, {}, triangles);
}

std::string noffBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    return offText(points.position, points.normal, triangles);
}

// ---- STL ----------------------------------------------------------------------------------------

// The shift of positions that are written as floats: an origin with few digits near the
// center of the mesh. It is the coarsest of a few powers of ten under which rounding to float
// moves no corner by more than a thousandth of the mean edge, or the best of them. O(triangles).
namespace {

/// `value` rounded to float.
double asFloat(double value) {
    // volatile: GCC 12 vectorizes "to float and back" and drops it.
    volatile float narrow = static_cast<float>(value);
    return static_cast<double>(narrow);
}

/// Exponents of the smallest and largest step of a shift.
constexpr int kLeastExponent = -30;
constexpr int kHighestExponent = 30;

/// 10^|exponent|; only multiplications, so that it is the same on every machine.
double powerOfTen(int exponent) {
    double power = 1.0;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10.0;
    return power;
}

/// The multiple of 10^exponent nearest to `value`, never -0. Powers below 1 divide, so that the
/// result is the double nearest to the decimal number.
double rounded(double value, int exponent) {
    const double power = powerOfTen(exponent);
    const double result =
        exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return result == 0.0 ? 0.0 : result;
}

/// The least exponent whose power of ten is not below `length`.
int exponentOf(double length) {
    int exponent = kLeastExponent;
    const auto power = [](int e) { return e < 0 ? 1.0 / powerOfTen(e) : powerOfTen(e); };
    while (exponent < kHighestExponent && power(exponent) < length) ++exponent;
    return exponent;
}

/// The corners of the triangles: mean length of the edges, and the box.
struct Corners {
    double spacing = 0.0;
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    Corners(std::span<const Vec3> position, std::span<const Triangle> triangles) {
        double sum = 0.0;
        for (const Triangle& t : triangles) {
            const std::array<Vec3, 3> corner{position[t.a], position[t.b], position[t.c]};
            for (std::size_t i = 0; i < 3; ++i) {
                sum += glm::length(corner[(i + 1) % 3] - corner[i]);
                low = glm::min(low, corner[i]);
                high = glm::max(high, corner[i]);
            }
        }
        if (!triangles.empty()) spacing = sum / static_cast<double>(3 * triangles.size());
    }
    double extent() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// The largest error by rounding to float of a corner's coordinate relative to `shift`.
double worstRounding(std::span<const Vec3> position, std::span<const Triangle> triangles,
                     const Vec3& shift) {
    double worst = 0.0;
    for (const Triangle& t : triangles) {
        for (const Index corner : {t.a, t.b, t.c}) {
            const Vec3 place = position[corner] - shift;
            for (int i = 0; i < 3; ++i)
                worst = std::max(worst, std::abs(asFloat(place[i]) - place[i]));
        }
    }
    return worst;
}

}  // namespace

std::optional<Vec3> floatShift(const PointFile& points, std::span<const Triangle> triangles) {
    constexpr double kSharpness = 1000.0;  // Parts of the spacing that must survive.
    constexpr int kMaxTries = 4;
    const Corners corners(points.position, triangles);
    const double allowed = corners.spacing / kSharpness;
    if (!(allowed > 0.0) || !std::isfinite(corners.spacing)) return std::nullopt;
    double best = worstRounding(points.position, triangles, Vec3(0.0));
    if (best <= allowed) return std::nullopt;
    std::optional<Vec3> shift;
    const Vec3 middle = 0.5 * (corners.low + corners.high);
    int exponent = exponentOf(corners.extent());
    for (int i = 0; i < kMaxTries && best > allowed; ++i, --exponent) {
        Vec3 tried;
        for (int axis = 0; axis < 3; ++axis) tried[axis] = rounded(middle[axis], exponent);
        const double left = worstRounding(points.position, triangles, tried);
        if (left >= best) continue;
        best = left;
        shift = tried;
    }
    return shift;
}

namespace {

/// Little endian. Four at a time: one by one a mesh of two million triangles takes half a second.
template <typename Scalar>
void append(std::string& bytes, Scalar value) {
    std::array<char, sizeof(Scalar)> raw;
    storeScalar(raw.data(), value);
    bytes.append(raw.data(), raw.size());
}
void append(std::string& bytes, const Vec3& v) {
    for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(v[i]));
}

/// The first 80 bytes. They must not begin with "solid", as text does.
std::string stlHeader(const std::optional<Vec3>& shift) {
    constexpr std::size_t kSize = 80;
    std::string text = "written by spiraling-edge";
    if (shift) {
        const std::string sum = "add " + plainNumbers(*shift, " ");
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

/// The center of a box as floats, which every program preserves; as doubles where floats are too
/// coarse to be near the points.
Vec3 middleOf(const WallBox& box) {
    const Vec3 exact = 0.5 * (box.low + box.high);
    const Vec3 size = box.high - box.low;
    const Vec3 coarse = asFloats(exact);
    const Vec3 off = glm::abs(coarse - exact);
    const bool near = std::max({off.x, off.y, off.z}) <= std::max({size.x, size.y, size.z});
    return near ? coarse : exact;
}

/// "[x,y,z]" with digits that read back exactly.
std::string jsonOf(const Vec3& v) {
    std::string text = "[";
    appendRow(text, v, ',');
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
        middle_ = middleOf(boxAround(points_.position));
        Vec3 low{std::numeric_limits<double>::infinity()};
        Vec3 high{-std::numeric_limits<double>::infinity()};
        for (const Vec3& x : points_.position) {
            const Vec3 place = isFinite(x) ? asFloats(x - middle_) : Vec3(0.0);
            low = glm::min(low, place);
            high = glm::max(high, place);
            append(binary_, place);
        }
        describe(0, kVertices, kFloat, points_.position.size(), "VEC3",
                 ",\"min\":" + jsonOf(low) + ",\"max\":" + jsonOf(high));
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
