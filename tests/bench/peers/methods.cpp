// The table of methods. Each SE_PEERS_... is set by CMake if it found the library.
#include <array>

#include "method.h"

#ifdef SE_PEERS_PCL
#define SE_IF_PCL(function) function
#else
#define SE_IF_PCL(function) nullptr
#endif
#ifdef SE_PEERS_CGAL
#define SE_IF_CGAL(function) function
#else
#define SE_IF_CGAL(function) nullptr
#endif
#ifdef SE_PEERS_OPEN3D
#define SE_IF_OPEN3D(function) function
#else
#define SE_IF_OPEN3D(function) nullptr
#endif

namespace se::peers {
namespace {

constexpr std::array kMethods{
    Method{"gp3", "Greedy projection triangulation (Marton et al. 2009), PCL", "libpcl-dev", 20,
           SE_IF_PCL(greedyProjection)},
    Method{"afs", "Advancing front (Cohen-Steiner, Da 2004), CGAL", "libcgal-dev", 0,
           SE_IF_CGAL(advancingFront)},
    Method{"bpa", "Ball pivoting (Bernardini et al. 1999), Open3D", "libopen3d-dev", 0,
           SE_IF_OPEN3D(ballPivoting)},
    Method{"alpha", "Alpha shape (Edelsbrunner, Muecke 1994), CGAL", "libcgal-dev", 0,
           SE_IF_CGAL(alphaShape)},
    Method{"crust", "Crust (Amenta, Bern, Kamvysselis 1998), ours on CGAL's Delaunay",
           "libcgal-dev", 0, SE_IF_CGAL(crust)},
    Method{"hoppe", "Marching cubes (Hoppe et al. 1992), PCL", "libpcl-dev", 0, SE_IF_PCL(hoppe)},
    Method{"poisson", "Screened Poisson (Kazhdan, Hoppe 2013), PCL", "libpcl-dev", 0,
           SE_IF_PCL(poisson)},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

}  // namespace se::peers
