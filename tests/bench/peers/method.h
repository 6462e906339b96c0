/// The interface of every peer: its name and title, its Debian package, and one function.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "spiraling_edge/io/read_points.h"

namespace se::peers {

/// A mesh and how long it took.
struct Outcome {
    std::vector<Triangle> triangles;
    /// For methods that make points of their own; empty: the triangles are over the input points.
    std::optional<PointFile> ownPoints;
    /// Time of neighbor lists, spacing or the Delaunay triangulation, before the method's own work
    /// begins.
    double searchSeconds = 0.0;
    double reconstructSeconds = 0.0;
};

/// Reconstructs. `neighbors` counts others, not the point itself; methods without such a number
/// ignore it. Throws std::exception if the library does.
using Reconstruct = Outcome (*)(const PointFile& points, std::size_t neighbors);

/// One row of the table.
struct Method {
    std::string_view name;     ///< As on the command line.
    std::string_view title;    ///< The method and its origin.
    std::string_view package;  ///< The Debian package that contains it.
    std::size_t neighbors;     ///< Default number of neighbors; 0: the method takes no such number.
    Reconstruct run;           ///< Null if the library was absent when this was configured.
};

/// All methods, built or not.
std::span<const Method> methods();

Outcome greedyProjection(const PointFile& points, std::size_t neighbors);
Outcome advancingFront(const PointFile& points, std::size_t neighbors);
Outcome ballPivoting(const PointFile& points, std::size_t neighbors);
Outcome alphaShape(const PointFile& points, std::size_t neighbors);
Outcome crust(const PointFile& points, std::size_t neighbors);
Outcome hoppe(const PointFile& points, std::size_t neighbors);
Outcome poisson(const PointFile& points, std::size_t neighbors);

/// A stop watch for seconds since construction or the last call.
class StopWatch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - start_;
        start_ = now;
        return passed.count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace se::peers
