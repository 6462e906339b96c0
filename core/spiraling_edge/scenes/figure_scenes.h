/// Small inputs that each show one figure of the paper.
#pragma once

#include "spiraling_edge/points/point_file.h"

namespace se {

PointFile figure2();
PointFile figure4();
PointFile figure5();
PointFile figure6();
PointFile figure7();
PointFile figure9();
PointFile figure12();
/// Begins with two points on one wall.
PointFile figure14();

}  // namespace se
