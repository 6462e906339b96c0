#include "pcl_cloud.h"

#include <array>
#include <glm/common.hpp>
#include <map>

namespace se::peers {
namespace {

/// Gives points numbers; points nearer than the tolerance share one.
class Welder {
  public:
    Welder(std::vector<Vec3>& positions, double tolerance)
        : positions_(positions), tolerance_(tolerance) {}

    Index indexOf(const Vec3& p) {
        // Cells of four tolerances: whatever is near is in one of these eight.
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 probe =
                p + tolerance_ * Vec3((corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
            const auto place = indexAt_.find(cellOf(probe));
            if (place == indexAt_.end()) continue;
            if (glm::length(positions_[place->second] - p) < tolerance_) return place->second;
        }
        indexAt_.emplace(cellOf(p), static_cast<Index>(positions_.size()));
        positions_.push_back(p);
        return static_cast<Index>(positions_.size() - 1);
    }

  private:
    using Cell = std::array<long long, 3>;

    Cell cellOf(const Vec3& p) const {
        const Vec3 scaled = glm::floor(p / (4.0 * tolerance_));
        return {static_cast<long long>(scaled.x), static_cast<long long>(scaled.y),
                static_cast<long long>(scaled.z)};
    }

    std::vector<Vec3>& positions_;
    double tolerance_;
    std::map<Cell, Index> indexAt_;
};

}  // namespace

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
              const std::vector<pcl::Vertices>& polygons, double tolerance, Outcome& outcome) {
    PointFile& made = outcome.ownPoints.emplace();
    Welder welder(made.position, tolerance);
    std::vector<Index> indexOf;
    indexOf.reserve(cloud.size());
    for (const pcl::PointNormal& p : cloud) indexOf.push_back(welder.indexOf({p.x, p.y, p.z}));
    for (const Triangle& t : trianglesOf(polygons)) {
        const Triangle merged{indexOf[t.a], indexOf[t.b], indexOf[t.c]};
        if (merged.a != merged.b && merged.b != merged.c && merged.c != merged.a)
            outcome.triangles.push_back(merged);
    }
}

}  // namespace se::peers
