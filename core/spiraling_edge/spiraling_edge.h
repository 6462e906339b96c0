/// The whole of the library that most programs need: from points to a mesh, decision by decision,
/// and the reasons. docs/library.md leads through it.
#pragma once

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/run/run_cursor.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/failure_moments.h"
#include "spiraling_edge/why/figure_check.h"
#include "spiraling_edge/why/ledger.h"
#include "spiraling_edge/why/run_compare.h"
