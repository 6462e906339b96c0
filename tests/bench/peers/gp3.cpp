// Greedy projection triangulation: Z. C. Marton, R. B. Rusu and M. Beetz, ICRA 2009; PCL, with the
// angles of its tutorial. Neighbor lists are made beforehand, by PCL's own tree, so that they are
// timed apart.
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "cloud_facts.h"
#include "method.h"
#include "pcl_cloud.h"

namespace se::peers {
namespace {

using Cloud = pcl::PointCloud<pcl::PointNormal>;
using Tree = pcl::search::KdTree<pcl::PointNormal>;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMu = 2.5;  // largest distance of a neighbor, in distances of the nearest

/// A search that returns the precomputed lists.
class FoundLists : public pcl::search::Search<pcl::PointNormal> {
  public:
    FoundLists(const Cloud::Ptr& cloud, int count) : Search("found", true) {
        Tree tree;
        tree.setInputCloud(cloud);
        setInputCloud(cloud);
        lists_.resize(cloud->size());
        distances_.resize(cloud->size());
        for (std::size_t p = 0; p < cloud->size(); ++p)
            tree.nearestKSearch(static_cast<pcl::index_t>(p), count, lists_[p], distances_[p]);
    }

    int nearestKSearch(pcl::index_t point, int, pcl::Indices& found,
                       std::vector<float>& distances) const override {
        const auto p = static_cast<std::size_t>(point);
        found = lists_[p];
        distances = distances_[p];
        return static_cast<int>(found.size());
    }
    int nearestKSearch(const pcl::PointNormal&, int, pcl::Indices&,
                       std::vector<float>&) const override {
        return 0;
    }
    int radiusSearch(const pcl::PointNormal&, double, pcl::Indices&, std::vector<float>&,
                     unsigned) const override {
        return 0;
    }
    /// The mean distance to the first neighbor at another place.
    double meanSpacing() const {
        double sum = 0.0;
        for (const auto& list : distances_)
            for (const float squared : list)
                if (squared > 0.0F) {
                    sum += std::sqrt(static_cast<double>(squared));
                    break;
                }
        return sum / static_cast<double>(distances_.size());
    }

  private:
    std::vector<pcl::Indices> lists_;
    std::vector<std::vector<float>> distances_;
};

}  // namespace

Outcome greedyProjection(const PointFile& points, std::size_t neighbors) {
    Outcome outcome;
    const Cloud::Ptr cloud = toCloud(points);
    StopWatch watch;
    const int count = static_cast<int>(neighbors) + 1;  // PCL counts the point itself
    const pcl::shared_ptr<FoundLists> lists(new FoundLists(cloud, count));
    outcome.searchSeconds = watch.lap();

    pcl::GreedyProjectionTriangulation<pcl::PointNormal> method;
    method.setSearchRadius(5.0 * lists->meanSpacing());
    method.setMu(kMu);
    method.setMaximumNearestNeighbors(count);
    method.setMaximumSurfaceAngle(45.0 * kDegree);
    method.setMinimumAngle(10.0 * kDegree);
    method.setMaximumAngle(120.0 * kDegree);
    method.setNormalConsistency(true);
    method.setConsistentVertexOrdering(true);
    method.setInputCloud(cloud);
    method.setSearchMethod(lists);
    std::vector<pcl::Vertices> polygons;
    method.reconstruct(polygons);
    outcome.triangles = trianglesOf(polygons);
    outcome.reconstructSeconds = watch.lap();
    return outcome;
}

}  // namespace se::peers
