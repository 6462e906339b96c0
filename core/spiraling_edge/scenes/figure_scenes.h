/// The points of the paper's figures, and the states in which they begin: what figures.cpp puts
/// into its table. Those named after a figure have their pivot p as point 0, and all normals toward
/// the viewer unless the figure is about them.
#pragma once

#include "spiraling_edge/points/point_file.h"
#include "spiraling_edge/stepper/given_start.h"

namespace se {

/// Figure 1: the points of Figure 2, with the list of point 1 as the figure has it.
PointFile figure1Points();
/// Figure 2: the figure's points 1 to 18 in a box, as points 0 to 17.
PointFile figure2Points();
PointFile figure3Points();
GivenStart figure3Start();
PointFile figure4Points();
GivenStart figure4Start();
PointFile figure5Points();
GivenStart figure5Start();
PointFile figure6Points();
GivenStart figure6Start();
PointFile figure7Points();
GivenStart figure7Start();
/// Figures 8 and 10: a flat sheet of 50 points.
PointFile figure8Points();
PointFile figure9Points();
GivenStart figure9Start();
PointFile figure11Points();
GivenStart figure11Start();
/// Figure 12: a torus of 160 points.
PointFile figure12Points();
PointFile figure13Points();
GivenStart figure13Start();
/// Figures 14, 16 and 19: the sheet of Figure 8, begun with two points on one wall.
PointFile figure14Points();
/// Figure 15: the mirror image of Figure 14.
PointFile figure15Points();
PointFile figure20Points();
GivenStart figure20Start();

// Samples that show no figure.
/// A flat or wavy sheet of 50 points whose run begins at an interior point.
PointFile smallWavySheet();
/// Tori of 160 points, with lists of 10, of 14, and other points.
PointFile smallTorus();
PointFile smallTorusWithLongLists();
PointFile coarseTorus();

}  // namespace se
