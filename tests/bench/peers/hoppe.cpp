// Marching cubes over the distance to the tangent planes: H. Hoppe and others, SIGGRAPH 1992; PCL.
// Cells are as large as the mean distance to the nearest point, but there are 16 to 256 along every
// side.
#include <pcl/search/kdtree.h>
#include <pcl/surface/marching_cubes_hoppe.h>

#include <algorithm>

#include "cloud_facts.h"
#include "method.h"
#include "pcl_cloud.h"

namespace se::peers {

Outcome hoppe(const PointFile& points, std::size_t) {
    Outcome outcome;
    const auto cloud = toCloud(points);
    StopWatch watch;
    const double spacing = meanSpacing(points);
    const Vec3 sides = extent(points);
    const auto cells = [&](double side) {
        return static_cast<int>(std::clamp(side / spacing, 16.0, 256.0));
    };
    const pcl::search::KdTree<pcl::PointNormal>::Ptr tree(
        new pcl::search::KdTree<pcl::PointNormal>);
    tree->setInputCloud(cloud);
    outcome.searchSeconds = watch.lap();

    pcl::MarchingCubesHoppe<pcl::PointNormal> method;
    method.setIsoLevel(0.0F);
    method.setGridResolution(cells(sides.x), cells(sides.y), cells(sides.z));
    method.setPercentageExtendGrid(0.02F);
    method.setDistanceIgnore(static_cast<float>(2.0 * spacing));
    method.setInputCloud(cloud);
    method.setSearchMethod(tree);
    pcl::PointCloud<pcl::PointNormal> made;
    std::vector<pcl::Vertices> polygons;
    method.reconstruct(made, polygons);
    outcome.reconstructSeconds = watch.lap();
    takeMesh(made, polygons, 1e-3 * spacing, outcome);
    return outcome;
}

}  // namespace se::peers
