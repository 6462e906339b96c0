// GLB, binary glTF 2.0: the triangles and points of the scene, each mesh where its nodes place it.
// Vertices of triangles at the same place are one point, as in STL: a hard edge or a seam of a
// texture has several.
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/glb_data.h"
#include "spiraling_edge/io/merged_points.h"

namespace se::io {
namespace {

/// Nodes may place a mesh many times: a small file could ask for any number of points. A file may
/// have this many, and as many more as its size has room for.
constexpr std::size_t kMostPlaced = 50'000'000;
constexpr std::size_t kLeastVertex = 6;  ///< Bytes.

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
        return placed_ <= kMostPlaced + fileSize() / kLeastVertex ||
               fail(value.at, "the nodes place more than " + std::to_string(kMostPlaced) +
                                  " points; export each mesh once");
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
