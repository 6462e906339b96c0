#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

void count(const PanelContext& context, const char* name, std::size_t value) {
    valueRow(context, name, grouped(value),
             value == 0 ? context.palette.textDim : context.palette.text);
}

void warn(const PanelContext& context, const char* name, std::size_t value) {
    valueRow(context, name, grouped(value),
             value == 0 ? context.palette.textDim : context.palette.rejected);
}

void drawInput(const PanelContext& context) {
    const PrepareReport& report = context.session().model().report;
    ImGui::Spacing();
    heading(context, "Input");
    if (!beginValues("##input", context)) return;
    count(context, "points", context.session().model().points.size());
    valueRow(context, "neighbors", report.neighborsComputed ? "computed" : "from the file");
    const DerivedPieces& derived = report.derived;
    if (derived.normals) valueRow(context, "normals", "derived");
    if (derived.types) valueRow(context, "wall types", "derived");
    if (derived.rim) valueRow(context, "rims", "derived");
    if (report.neighborsComputed) valueRow(context, "neighbors", "derived");
    if (derived.planelessPoints > 0) warn(context, "no plane", derived.planelessPoints);
    if (report.nonFinitePoints > 0) warn(context, "not finite", report.nonFinitePoints);
    if (report.zeroNormals > 0) warn(context, "zero normals", report.zeroNormals);
    if (report.duplicatePoints > 0) warn(context, "duplicates", report.duplicatePoints);
    if (report.noisyPoints > 0) warn(context, "noise", report.noisyPoints);
    if (report.droppedListEntries > 0) count(context, "list cleaned", report.droppedListEntries);
    endValues();
}

}  // namespace

void drawCounters(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) return;
    const bool complete = session.picture().complete;
    const RunState& state = complete ? session.record().after : session.record().before;
    const Counters& c = state.counters;
    heading(context, "Run", complete ? "after this pivot" : "before this pivot");
    if (beginValues("##run", context)) {
        count(context, "triangles",
              session.picture().finishedTriangles + session.picture().newTriangles.size());
        count(context, "UNUSED", context.counts.unused);
        count(context, "USED", context.counts.used);
        count(context, "DONE", context.counts.done);
        count(context, "pivots", c.pivots);
        count(context, "passed over", c.skipped);
        count(context, "seeds", c.seeds);
        count(context, "splits", c.splits);
        count(context, "joins", c.joins);
        count(context, "closed rings", c.closedRings);
        count(context, "freed rings", c.freedRings);
        count(context, "inserted (7)", c.inserted);
        count(context, "discarded", c.discarded);
        count(context, "longest ring", c.maxRingLength);
        count(context, "deepest stack", c.maxStackDepth);
        warn(context, "isolated", c.isolated);
        warn(context, "stranded", c.stranded);
        warn(context, "holes", c.holes);
        warn(context, "lost seeds", c.lostSeeds);
        endValues();
    }
    drawInput(context);
}

}  // namespace se::view
