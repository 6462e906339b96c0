/// Small inputs that fail, each for a reason that the paper names.
#pragma once

#include "spiraling_edge/points/point_file.h"

namespace se {

PointFile fourEdgeHole();
PointFile sparseSpot();
PointFile closeSheets();
PointFile sharpCrease();
PointFile unevenDensity();
PointFile noiseAlongNormal();
PointFile wrongLists();
PointFile flippedPatch();
PointFile nearDuplicates();
PointFile strandedPoint();
PointFile teeAtWall();

}  // namespace se
