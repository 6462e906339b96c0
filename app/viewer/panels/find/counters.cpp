// The counters: size of the run at the cursor, and facts about the input.
#include <string>
#include <variant>

#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/run/status_list.h"

namespace se::view {

namespace {

void count(const PanelContext& context, const char* name, std::size_t value,
           Color Palette::*color = &Palette::text) {
    const Palette& palette = context.palette;
    valueRow(context, name, grouped(value), value == 0 ? palette.textDim : palette.*color);
}

void warn(const PanelContext& context, const char* name, std::size_t value) {
    count(context, name, value, &Palette::rejected);
}

/// Derived values are highlighted among those of the input.
void origin(const PanelContext& context, const char* name, bool derived, const std::string& note) {
    valueRow(context, name, derived ? "derived" + note : "from the input",
             derived ? context.palette.test : context.palette.text);
}

std::string neighborNote(const PanelContext& context) {
    const NeighborOptions& options = context.session().input().spec().neighbors;
    std::string text;
    if (const auto* nearest = std::get_if<KNearest>(&options.reach)) {
        text = ": " + std::to_string(nearest->k) + " nearest";
    } else if (const auto* reach = std::get_if<WithinSpacings>(&options.reach)) {
        text = formatted(": within %.4g spacings", reach->spacings);
    } else {
        text = formatted(": within %.4g", std::get<WithinRadius>(options.reach).radius);
    }
    return text + (options.symmetric ? ", symmetric" : "");
}

std::string normalNote(const DerivedPieces& derived) {
    return derived.normals ? std::string{} : ": " + grouped(derived.turnedNormals) + " flipped";
}

void drawInput(const PanelContext& context) {
    const PrepareReport& report = context.session().model().report;
    ImGui::Spacing();
    heading(context, "Input");
    if (!beginValues("##input", context)) return;
    count(context, "points", context.session().model().points.size());
    const DerivedPieces& derived = report.derived;
    origin(context, "neighbors", report.neighborsComputed, neighborNote(context));
    origin(context, "normals", derived.normals || derived.orientation, normalNote(derived));
    if (derived.types) origin(context, "wall types", derived.types, {});
    if (derived.rim) origin(context, "rims", derived.rim, {});
    if (derived.completedNormals > 0) warn(context, "normals derived", derived.completedNormals);
    if (report.averagedNormals > 0) warn(context, "mean normals", report.averagedNormals);
    for (const AsideWords& each : asideReasons()) {
        const std::size_t aside = report.count(each.reason);
        if (aside > 0) warn(context, std::string(each.name).c_str(), aside);
    }
    if (report.droppedListEntries > 0) count(context, "list cleaned", report.droppedListEntries);
    endValues();
}

}  // namespace

void drawCounters(const PanelContext& context) {
    const Session& session = context.session();
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
        count(context, "failed seeds", c.failedSeeds);
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
