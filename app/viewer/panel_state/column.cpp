#include "column.h"

#include "spiraling_edge/base/lists.h"

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

}  // namespace

std::span<const TaskRow> taskRows() { return kTasks; }

const PartRow* partNamed(std::string_view title) {
    return rowWhere(partRows(), [&](const PartRow& each) { return each.title == title; });
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
