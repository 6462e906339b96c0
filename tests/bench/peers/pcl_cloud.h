/// From our points to PCL's, and from its meshes to ours.
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "method.h"

namespace se::peers {

/// Positions and normals, as the floats that PCL works with.
pcl::PointCloud<pcl::PointNormal>::Ptr toCloud(const PointFile& points);
/// The triangles of a mesh; polygons with other than three corners are left out.
std::vector<Triangle> trianglesOf(const std::vector<pcl::Vertices>& polygons);
/// Points and triangles of a mesh that has points of its own. Points nearer than `tolerance` become
/// one (PCL's marching cubes give every triangle its own three); triangles that lose a corner are
/// left out.
void takeMesh(const pcl::PointCloud<pcl::PointNormal>& cloud,
              const std::vector<pcl::Vertices>& polygons, double tolerance, Outcome& outcome);

}  // namespace se::peers
