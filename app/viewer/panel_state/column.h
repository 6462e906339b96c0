/// The column beside the view: a rail of tasks, and the parts of each task. Plain values, no ImGui.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace se::view {

/// Tasks of a user, in the order of the rail.
enum class Task : std::uint8_t { Step, Why, Faults, Find, Change, Input, Lesson };
inline constexpr std::size_t kTaskCount = 7;

struct TaskRow {
    Task id;
    std::string_view title;
    std::string_view help;  ///< What its parts are for.
};
std::span<const TaskRow> taskRows();
inline const TaskRow& rowOf(Task task) { return taskRows()[static_cast<std::size_t>(task)]; }

// Titles of parts that commands open.
inline constexpr const char* kLedgerPart = "Why";
inline constexpr const char* kAlertsPart = "Alerts";
inline constexpr const char* kQueryPart = "Query";
inline constexpr const char* kBreakpointsPart = "Breakpoints";
inline constexpr const char* kWatchPart = "Watch";
inline constexpr const char* kChartsPart = "Charts";
inline constexpr const char* kRulesPart = "Rules";
inline constexpr const char* kWhatIfPart = "What if";
inline constexpr const char* kComparePart = "Compare";
inline constexpr const char* kDoctorPart = "Doctor";
inline constexpr const char* kPreparePart = "Prepare";
inline constexpr const char* kSectionPart = "Section";
inline constexpr const char* kLessonPart = "Lesson";

struct PanelContext;

/// One part: a panel within the column, which can be folded to its title.
struct PartRow {
    std::string_view title;
    Task task;
    void (*draw)(const PanelContext& context);
    bool open = true;  ///< Unless the user has folded or unfolded it.
    /// The least height in em, if it scrolls by itself and takes the room that is left; 0: it is as
    /// high as its content.
    float least = 0.0F;
    /// Null: the part is always there.
    bool (*isThere)(const PanelContext& context) = nullptr;
    std::string_view synonyms = {};  ///< For the palette, of a part that no action opens.
};
/// The table of the parts, in their order; it is in panels/frame/column.cpp.
std::span<const PartRow> partRows();
/// The part of that title; null if there is none.
const PartRow* partNamed(std::string_view title);

/// Which parts the user has folded (false) or unfolded (true), by title.
using FoldedParts = std::map<std::string, bool, std::less<>>;
bool isOpen(const FoldedParts& parts, const PartRow& part);
void setOpen(FoldedParts& parts, const PartRow& part, bool open);

struct Column {
    Task task = Task::Step;
    bool chosen = false;  ///< By the user: what happens in the run does not switch it.
    bool sheet = false;   ///< In a phone's shape: it is pulled up.
    std::string part;     ///< Title of the part that was opened last; empty: none.
    std::string reveal;   ///< Title of a part to scroll to in the next frame.
    std::array<bool, kTaskCount> news{};  ///< Tasks with something that was not looked at yet.
    std::array<float, 24> heights{};      ///< Of parts, as last drawn, in pixels.

    /// The user picks a task.
    void choose(Task picked) {
        show(picked);
        chosen = sheet = true;
    }
    /// The run calls for a task; the user's own choice stays.
    void suggest(Task wanted) {
        if (!chosen) show(wanted);
    }
    /// Something was found meanwhile.
    void note(Task where) { news[static_cast<std::size_t>(where)] = where != task; }
    /// Remembers the task while two runs are compared, and returns to it.
    void keep() { kept_ = {task, chosen}; }
    void takeBack() {
        show(kept_.first);
        chosen = kept_.second;
    }
    /// Another input is opened.
    void reset() {
        chosen = false;
        news = {};
        show(Task::Step);
    }
    /// A command needs a part.
    void open(const PartRow& row) {
        show(row.task);
        sheet = true;
        part = reveal = row.title;
    }

  private:
    std::pair<Task, bool> kept_{Task::Step, false};

    void show(Task wanted) {
        task = wanted;
        news[static_cast<std::size_t>(wanted)] = false;
    }
};

}  // namespace se::view
