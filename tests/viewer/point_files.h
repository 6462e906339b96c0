/// Files of points, for tests of the viewer.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "spiraling_edge/points/point_file.h"

namespace se::view::test {

/// Positions as XYZ, with normals where there are some; the path.
inline std::string writePoints(const std::filesystem::path& path, const PointFile& file) {
    std::ofstream out(path);
    out.precision(17);
    for (std::size_t p = 0; p < file.position.size(); ++p) {
        const Vec3& x = file.position[p];
        out << x.x << ' ' << x.y << ' ' << x.z;
        if (!file.normal.empty()) {
            const Vec3& n = file.normal[p];
            out << ' ' << n.x << ' ' << n.y << ' ' << n.z;
        }
        out << '\n';
    }
    return path.string();
}

/// A sheet of uneven points, `side` to a side, with a hole about its middle; `hole` is the square
/// of its radius.
inline PointFile holedSheet(int side, int hole) {
    PointFile sheet;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int far = (x - side / 2) * (x - side / 2) + (y - side / 2) * (y - side / 2);
            if (far <= hole) continue;
            sheet.position.emplace_back(x + 0.3 * std::sin(7 * x + 3 * y),
                                        y + 0.3 * std::sin(5 * x + 11 * y), 0.0);
            sheet.normal.emplace_back(0.0, 0.0, 1.0);
        }
    }
    return sheet;
}

/// A spiral over the unit sphere, with its normals.
inline PointFile spiralSphere(int count) {
    PointFile sphere;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt(1.0 - z * z);
        const double turn = 2.399963229728653 * i;
        sphere.position.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
        sphere.normal.push_back(sphere.position.back());
    }
    return sphere;
}

}  // namespace se::view::test
