// Screened Poisson reconstruction: M. Kazhdan and H. Hoppe, ACM TOG 2013; PCL. The tree is as deep
// as makes its cells the mean distance to the nearest point, between 6 and 10. The result is always
// closed, also where the surface is not.
#include <pcl/search/kdtree.h>
#include <pcl/surface/poisson.h>

#include <algorithm>
#include <cmath>

#include "cloud_facts.h"
#include "method.h"
#include "pcl_cloud.h"

namespace se::peers {

Outcome poisson(const PointFile& points, std::size_t) {
    Outcome outcome;
    const auto cloud = toCloud(points);
    StopWatch watch;
    const double spacing = meanSpacing(points);
    const Vec3 sides = extent(points);
    const double side = std::max({sides.x, sides.y, sides.z});
    const double cells = side / spacing;
    outcome.searchSeconds = watch.lap();

    pcl::Poisson<pcl::PointNormal> method;
    method.setDepth(static_cast<int>(std::clamp(std::ceil(std::log2(cells)), 6.0, 10.0)));
    method.setInputCloud(cloud);
    pcl::PointCloud<pcl::PointNormal> made;
    std::vector<pcl::Vertices> polygons;
    method.reconstruct(made, polygons);
    outcome.reconstructSeconds = watch.lap();
    takeMesh(made, polygons, 1e-6 * spacing, outcome);
    return outcome;
}

}  // namespace se::peers
