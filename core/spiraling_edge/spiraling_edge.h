/// The whole of the library that most programs need: from points to a mesh, decision by decision,
/// and the reasons. docs/library.md leads through it.
#pragma once

#include "spiraling_edge/base/result.h"
#include "spiraling_edge/explain/failure_moments.h"
#include "spiraling_edge/explain/figure_check.h"
#include "spiraling_edge/explain/ledger.h"
#include "spiraling_edge/explain/run_compare.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/replay/event_text.h"
#include "spiraling_edge/replay/reconstruct.h"
#include "spiraling_edge/replay/run_cursor.h"
#include "spiraling_edge/scenes/figures.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/stepper/rule_settings.h"
#include "spiraling_edge/stepper/stepper.h"
