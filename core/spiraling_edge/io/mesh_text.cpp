/// The text mesh formats: OBJ and OFF.
#include <array>
#include <cassert>
#include <charconv>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/io/mesh_formats.h"

namespace se::io {
namespace {

void appendIndex(std::string& text, Index value) {
    std::array<char, 12> out;
    const auto end = std::to_chars(out.data(), out.data() + out.size(), value).ptr;
    text.append(out.data(), end);
}

void appendRow(std::string& text, const Vec3& v) {
    for (int i = 0; i < 3; ++i) {
        if (i > 0) text += ' ';
        appendNumber(text, v[i]);
    }
}

}  // namespace

std::string objBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    std::string text = "# written by spiraling-edge\n";
    for (const Vec3& x : points.position) {
        text += "v ";
        appendRow(text, x);
        text += '\n';
    }
    for (const Vec3& n : points.normal) {
        text += "vn ";
        appendRow(text, n);
        text += '\n';
    }
    for (const Triangle& t : triangles) {
        text += 'f';
        for (const Index corner : {t.a, t.b, t.c}) {
            text += ' ';
            appendIndex(text, corner + 1);
            if (!points.hasNormals()) continue;
            text += "//";
            appendIndex(text, corner + 1);
        }
        text += '\n';
    }
    return text;
}

namespace {

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
        for (const Index corner : {t.a, t.b, t.c}) {
            text += ' ';
            appendIndex(text, corner);
        }
        text += '\n';
    }
    return text;
}

}  // namespace

std::string offBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    return offText(points.position, {}, triangles);
}

std::string noffBytes(const PointFile& points, std::span<const Triangle> triangles) {
    assert(checkWritable(points, triangles).ok());
    return offText(points.position, points.normal, triangles);
}

}  // namespace se::io
