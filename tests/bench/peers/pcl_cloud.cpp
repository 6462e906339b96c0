#include "pcl_cloud.h"

namespace se::peers {

pcl::PointCloud<pcl::PointNormal>::Ptr toCloud(const PointFile& points) {
    pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
    cloud->reserve(points.position.size());
    const auto narrow = [](double value) { return static_cast<float>(value); };
    for (std::size_t i = 0; i < points.position.size(); ++i) {
        const Vec3& p = points.position[i];
        const Vec3& n = points.normal[i];
        cloud->push_back(pcl::PointNormal(narrow(p.x), narrow(p.y), narrow(p.z), narrow(n.x),
                                          narrow(n.y), narrow(n.z)));
    }
    return cloud;
}

std::vector<Triangle> trianglesOf(const std::vector<pcl::Vertices>& polygons) {
    std::vector<Triangle> triangles;
    triangles.reserve(polygons.size());
    for (const pcl::Vertices& polygon : polygons) {
        if (polygon.vertices.size() != 3) continue;
        triangles.push_back({static_cast<Index>(polygon.vertices[0]),
                             static_cast<Index>(polygon.vertices[1]),
                             static_cast<Index>(polygon.vertices[2])});
    }
    return triangles;
}

void takeMesh(const pcl::PointCloud<pcl::PointNormal>& cloud,
              const std::vector<pcl::Vertices>& polygons, Outcome& outcome) {
    outcome.triangles = trianglesOf(polygons);
    outcome.ownPoints.emplace();
    outcome.ownPoints->position.reserve(cloud.size());
    for (const pcl::PointNormal& p : cloud) outcome.ownPoints->position.emplace_back(p.x, p.y, p.z);
}

}  // namespace se::peers
