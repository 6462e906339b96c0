/// §3: the end of a run, "Repeat until All Points are USED".
#include "spiraling_edge/mesh/mesh_report.h"
#include "spiraling_edge/stepper/step_context.h"

namespace se {

void finishRun(AnyContext auto& context) {
    State& s = context.state;
    s.phase = Phase::Finished;
    const bool capped = s.capped();
    // After the last pivot, like points that cannot begin a ring.
    noteAt(context, s.counters.pivots + (capped ? 0 : 1), Stage::Finished, [&] {
        const MeshReport report = reportMesh(context.points, s.mesh());
        return FinishedEvidence{static_cast<Index>(report.triangles),
                                static_cast<Index>(report.components),
                                static_cast<Index>(report.unusedPoints),
                                static_cast<Index>(report.boundaryLoops), capped};
    });
}

template void finishRun(UnloggedContext&);
template void finishRun(LoggedContext&);

}  // namespace se
