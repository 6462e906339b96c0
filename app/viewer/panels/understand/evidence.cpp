#include <cmath>

#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "rows/evidence_rows.h"
#include "scene/outcome.h"
#include "session/session.h"
#include "spiraling_edge/replay/event_text.h"
#include "spiraling_edge/replay/reading.h"

namespace se::view {

namespace {

/// The value against its threshold, in the column of values.
void drawGauge(const PanelContext& context, const EvidenceGauge& bar, const Color& color) {
    if (!std::isfinite(bar.value) || !(bar.largest > 0.0)) return;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TableNextColumn();
    ImGui::Dummy({0.0F, 0.1F * context.em});
    gauge(context, bar.value, bar.threshold, bar.largest, color);
}

}  // namespace

void drawEvidence(const PanelContext& context, const Event& event) {
    if (!beginValues("##evidence", context)) return;
    const Session& session = context.session();
    const std::optional<Color> outcome = outcomeColor(context.palette, event);
    if (const std::string ending(endingText(event)); !ending.empty())
        valueRow(context, "verdict", ending, outcome.value_or(context.palette.text));
    // While the previous state is shown, the values stay those of the decision.
    std::optional<Picture> after;
    if (session.showsBefore()) after = makePicture(session.record(), session.cursor());
    const EvidenceInput input{session.shown(), after ? *after : session.picture(), event,
                              &session.overview()};
    for (const EvidenceRow& row : evidenceRows(input)) {
        valueRow(context, row.name.c_str(), row.value);
        if (row.gauge) drawGauge(context, *row.gauge, outcome.value_or(context.palette.accent));
    }
    endValues();
}

}  // namespace se::view
