// Ball pivoting: F. Bernardini and others, IEEE TVCG 1999; Open3D. Balls of 1.5 and 3 times the
// mean distance to the nearest point, as in Open3D's tutorial.
#include <open3d/geometry/PointCloud.h>
#include <open3d/geometry/TriangleMesh.h>

#include "cloud_facts.h"
#include "method.h"

namespace se::peers {

Outcome ballPivoting(const PointFile& points, std::size_t) {
    Outcome outcome;
    StopWatch watch;
    const double spacing = meanSpacing(points);
    outcome.searchSeconds = watch.lap();

    open3d::geometry::PointCloud cloud;
    for (const Vec3& p : points.position) cloud.points_.emplace_back(p.x, p.y, p.z);
    for (const Vec3& n : points.normal) cloud.normals_.emplace_back(n.x, n.y, n.z);
    const auto mesh = open3d::geometry::TriangleMesh::CreateFromPointCloudBallPivoting(
        cloud, {1.5 * spacing, 3.0 * spacing});
    for (const auto& t : mesh->triangles_)
        outcome.triangles.push_back(
            {static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2])});
    outcome.reconstructSeconds = watch.lap();
    return outcome;
}

}  // namespace se::peers
