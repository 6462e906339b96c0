// The parts of the column: a row for each.
#include <tuple>

#include "panel_state/column.h"
#include "panels/panel.h"
#include "session/session.h"

namespace se::view {

namespace {

bool hasPivot(const PanelContext& context) {
    return !context.session().ready() || !context.session().atEnd();
}
bool compares(const PanelContext& context) {
    return context.rects.layoutPreset == LayoutPreset::Compare;
}

constexpr bool kFolded = false;

constexpr auto kPartRows = std::to_array<PartRow>({
    {"Dial", Task::Step, drawDial, true, 0.0F, hasPivot, "angles tangent plane circle"},
    {"Inspect", Task::Step, drawInspect, true, 0.0F, nullptr,
     "values properties details numbers selection"},
    {"Paper", Task::Step, drawPaper, true, 0.0F, hasPivot, "rule pseudocode section"},
    {kSectionPart, Task::Step, drawSection, kFolded, 0.0F, hasPivot},
    {"Steps", Task::Step, drawSteps, kFolded, 14.0F, nullptr, "tree list events pivots"},
    {"Rings", Task::Step, drawRings, kFolded, 12.0F, hasPivot, "stack edge"},
    {kLedgerPart, Task::Why, drawLedger, true, 12.0F, nullptr, "why history explain"},
    {"Verdict", Task::Faults, drawVerdict},
    {kAlertsPart, Task::Faults, drawAlerts, true, 14.0F},
    {kQueryPart, Task::Find, drawQuery, true, 14.0F, nullptr, "find search filter"},
    {kBreakpointsPart, Task::Find, drawBreakpoints, kFolded},
    {kWatchPart, Task::Find, drawWatch, kFolded},
    {kChartsPart, Task::Find, drawCharts, kFolded},
    {kComparePart, Task::Change, drawCompare, kFolded, 0.0F, compares},
    {kRulesPart, Task::Change, drawRules, true, 18.0F},
    {kWhatIfPart, Task::Change, drawWhatIf, kFolded},
    {kDoctorPart, Task::Input, drawDoctor},
    {kPreparePart, Task::Input, drawPrepare, kFolded, 18.0F},
    {kLessonPart, Task::Lesson, drawLesson, true, 12.0F},
});
static_assert(kPartRows.size() <= std::tuple_size_v<decltype(Column::heights)>);

}  // namespace

std::span<const PartRow> partRows() { return kPartRows; }

}  // namespace se::view
