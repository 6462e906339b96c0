#include "column.h"

#include <algorithm>
#include <tuple>

namespace se::view {

namespace {

constexpr std::array<TaskRow, kTaskCount> kTasks = {{
    {Task::Step, "Step", "The decision at the cursor: its rule and its numbers."},
    {Task::Why, "Why", "Why something is in the mesh, or is not."},
    {Task::Faults, "Faults", "The verdict on the mesh, and the places with faults."},
    {Task::Find, "Find", "Decisions of the whole run: queries, breakpoints, watches, charts."},
    {Task::Change, "Change", "Other rules, decisions and runs."},
    {Task::Input, "Input", "Problems of the input, and what is derived from it."},
    {Task::Lesson, "Lesson", "The open lesson, or all of them."},
}};

constexpr auto kPartRows = std::to_array<PartRow>({
    {"Dial", Task::Step},
    {"Inspect", Task::Step},
    {"Paper", Task::Step},
    {kSectionPart, Task::Step, false},
    {"Steps", Task::Step, false, 14.0F},
    {"Rings", Task::Step, false, 12.0F},
    {kLedgerPart, Task::Why, true, 12.0F},
    {"Verdict", Task::Faults},
    {kAlertsPart, Task::Faults, true, 14.0F},
    {kQueryPart, Task::Find, true, 14.0F},
    {kBreakpointsPart, Task::Find, false},
    {kWatchPart, Task::Find, false},
    {kChartsPart, Task::Find, false},
    {kComparePart, Task::Change, false},
    {kRulesPart, Task::Change, true, 18.0F},
    {kWhatIfPart, Task::Change, false},
    {kDoctorPart, Task::Input},
    {kPreparePart, Task::Input, false, 18.0F},
    {kLessonPart, Task::Lesson, true, 12.0F},
});
static_assert(kPartRows.size() <= std::tuple_size_v<decltype(Column::heights)>);

}  // namespace

std::span<const TaskRow> taskRows() { return kTasks; }

std::span<const PartRow> partRows() { return kPartRows; }

const PartRow* partNamed(std::string_view title) {
    const auto found = std::find_if(kPartRows.begin(), kPartRows.end(),
                                    [&](const PartRow& each) { return each.title == title; });
    return found == kPartRows.end() ? nullptr : &*found;
}

bool isOpen(const FoldedParts& parts, const PartRow& part) {
    const auto found = parts.find(part.title);
    return found == parts.end() ? part.open : found->second;
}

void setOpen(FoldedParts& parts, const PartRow& part, bool open) {
    if (open == part.open) {
        if (const auto found = parts.find(part.title); found != parts.end()) parts.erase(found);
    } else {
        parts.insert_or_assign(std::string(part.title), open);
    }
}

}  // namespace se::view
