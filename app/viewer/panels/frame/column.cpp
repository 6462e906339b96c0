// The rail of tasks, and the column with the parts of the open task: one below the other, each of
// which can be folded to its title. The table of the parts.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "document/actions.h"
#include "document/ui_state.h"
#include "input/key_routing.h"
#include "panel_state/column.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"

namespace se::view {

namespace {

// The parts: a row for each.

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

// The signs of the tasks.

/// Draws in a square of -1 to 1.
class Pen {
  public:
    Pen(ImDrawList* list, ImVec2 center, float size, ImU32 color)
        : list_(list), center_(center), half_(0.5F * size), color_(color) {}

    ImVec2 at(float x, float y) const { return {center_.x + half_ * x, center_.y + half_ * y}; }
    void line(std::initializer_list<ImVec2> corners, bool closed = false) const {
        for (const ImVec2& each : corners) list_->PathLineTo(at(each.x, each.y));
        list_->PathStroke(color_, closed ? ImDrawFlags_Closed : 0, width());
    }
    void circle(float x, float y, float r) const {
        list_->AddCircle(at(x, y), half_ * r, color_, 0, width());
    }
    void dot(float x, float y, float r) const {
        list_->AddCircleFilled(at(x, y), half_ * r, color_);
    }
    void arc(float x, float y, float r, float from, float to) const {
        list_->PathArcTo(at(x, y), half_ * r, from, to);
        list_->PathStroke(color_, 0, width());
    }

  private:
    float width() const { return std::max(1.25F, 0.18F * half_); }

    ImDrawList* list_;
    ImVec2 center_;
    float half_;
    ImU32 color_;
};

/// A pivot with the ends of its sector.
void drawStep(const Pen& pen) {
    pen.circle(0.0F, 0.0F, 1.0F);
    pen.line({{-0.5F, 0.87F}, {0.0F, 0.0F}, {1.0F, 0.0F}});
    pen.dot(0.0F, 0.0F, 0.25F);
}

void drawWhy(const Pen& pen) {
    pen.arc(0.0F, -0.45F, 0.5F, -3.14F, 1.2F);
    pen.line({{0.18F, 0.02F}, {0.0F, 0.2F}, {0.0F, 0.4F}});
    pen.dot(0.0F, 0.85F, 0.16F);
}

void drawFaults(const Pen& pen) {
    pen.line({{0.0F, -0.9F}, {1.0F, 0.85F}, {-1.0F, 0.85F}}, true);
    pen.line({{0.0F, -0.25F}, {0.0F, 0.3F}});
    pen.dot(0.0F, 0.57F, 0.13F);
}

void drawFind(const Pen& pen) {
    pen.circle(-0.2F, -0.2F, 0.65F);
    pen.line({{0.3F, 0.3F}, {0.95F, 0.95F}});
}

/// Sliders.
void drawChange(const Pen& pen) {
    constexpr std::array kKnobs = {-0.4F, 0.45F, -0.05F};
    for (std::size_t i = 0; i < kKnobs.size(); ++i) {
        const float y = -0.7F + 0.7F * static_cast<float>(i);
        pen.line({{-1.0F, y}, {1.0F, y}});
        pen.dot(kKnobs[i], y, 0.28F);
    }
}

/// Points, as a scan has them.
void drawInput(const Pen& pen) {
    for (const auto& [x, y] : std::to_array<std::pair<float, float>>({{-0.8F, 0.3F},
                                                                      {-0.5F, -0.4F},
                                                                      {0.05F, -0.8F},
                                                                      {0.0F, 0.05F},
                                                                      {-0.2F, 0.8F},
                                                                      {0.5F, 0.55F},
                                                                      {0.7F, -0.3F}}))
        pen.dot(x, y, 0.19F);
}

/// An open book. Not "drawLesson", which draws a part.
void drawLessonMark(const Pen& pen) {
    pen.line({{0.0F, -0.6F}, {-1.0F, -0.8F}, {-1.0F, 0.6F}, {0.0F, 0.8F}}, true);
    pen.line({{0.0F, -0.6F}, {1.0F, -0.8F}, {1.0F, 0.6F}, {0.0F, 0.8F}}, true);
}

/// By Task.
constexpr std::array<void (*)(const Pen&), kTaskCount> kDraw = {
    drawStep, drawWhy, drawFaults, drawFind, drawChange, drawInput, drawLessonMark};

/// Size of an entry of the rail, in em.
constexpr float kEntryHigh = 3.6F;
constexpr float kSignSize = 1.15F;
constexpr float kTaskNameSize = 0.72F;

/// A part of the open task, and where its row is.
struct Shown {
    const PartRow* row;
    std::size_t number;
};

std::vector<Shown> partsOf(const PanelContext& context) {
    std::vector<Shown> parts;
    const auto rows = partRows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].task != context.state<Column>().task) continue;
        if (rows[i].isThere == nullptr || rows[i].isThere(context)) parts.push_back({&rows[i], i});
    }
    return parts;
}

/// The title, which folds the part. A part alone needs no fold.
bool drawTitle(const PanelContext& context, const Shown& part, bool alone) {
    FoldedParts& folded = context.settings().parts;
    const bool open = alone || isOpen(folded, *part.row);
    const std::string title(part.row->title);
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton("##title", {ImGui::GetContentRegionAvail().x, height}) && !alone) {
        setOpen(folded, *part.row, !open);
        if (!open) context.state<Column>().part = title;
    }
    const bool hovered = ImGui::IsItemHovered() && !alone;
    nameItem(context, "part " + title);
    const Palette& colors = context.palette;
    const Color& ink = open || hovered ? colors.text : colors.textDim;
    float x = at.x;
    if (!alone) {
        const float r = 0.28F * em;
        drawFoldArrow({at.x + r, at.y + 0.5F * height}, r, open, ink);
        x += em;
    }
    ImGui::GetWindowDrawList()->AddText(context.fonts.strong, em, {x, at.y + 0.5F * (height - em)},
                                        toU32(ink), title.c_str());
    return open;
}

/// Height that the parts below `from` take at least.
float heightBelow(const PanelContext& context, std::span<const Shown> parts, std::size_t from) {
    const Column& column = context.state<Column>();
    float sum = 0.0F;
    for (std::size_t i = from; i < parts.size(); ++i) {
        sum += ImGui::GetFrameHeightWithSpacing();
        if (!isOpen(context.settings().parts, *parts[i].row)) continue;
        sum += parts[i].row->least > 0.0F ? parts[i].row->least * context.em
                                          : column.heights[parts[i].number];
    }
    return sum;
}

/// All parts but the lessons are about the open input.
void drawBody(const PanelContext& context, const PartRow& part) {
    if (context.session().ready() || part.task == Task::Lesson) return part.draw(context);
    dimText("Nothing is open.");
}

void drawContent(const PanelContext& context, std::span<const Shown> parts, std::size_t number) {
    const Shown& part = parts[number];
    const float from = ImGui::GetCursorPosY();
    if (part.row->least > 0.0F) {
        const float rest =
            ImGui::GetContentRegionAvail().y - heightBelow(context, parts, number + 1);
        const float height = std::max(part.row->least * context.em, rest);
        if (ImGui::BeginChild("##content", {0.0F, height}, false, ImGuiWindowFlags_NavFlattened))
            drawBody(context, *part.row);
        ImGui::EndChild();
    } else {
        drawBody(context, *part.row);
        ImGui::Spacing();
    }
    context.state<Column>().heights[part.number] = ImGui::GetCursorPosY() - from;
}

void drawParts(const PanelContext& context) {
    Column& column = context.state<Column>();
    const std::vector<Shown> parts = partsOf(context);
    if (parts.empty()) return;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        ImGui::PushID(static_cast<int>(parts[i].number));
        const bool open = drawTitle(context, parts[i], parts.size() == 1);
        if (i == 0 && context.state<KeyWalk>().offer(KeyStop::Content)) takeKeyboard();
        if (column.reveal == parts[i].row->title) {
            if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.0F);
            column.reveal.clear();
        }
        if (open) drawContent(context, parts, i);
        ImGui::PopID();
    }
}

/// The offer of the tour after the first run, above the parts.
void drawTourOffer(const PanelContext& context) {
    textIn(context.fonts.strong, "That was the Spiraling Edge");
    wrappedText("The tour explains what you saw, in ninety seconds.");
    if (textButton(context, "Take the tour", "tour take")) context.run("help.tour");
    ImGui::SameLine();
    if (textButton(context, "Not now", "tour later", "Help, Tour opens it later"))
        context.ui().offersTour = false;
    separator();
}

/// A task in the rail: its sign above its name, and a mark if something there is new.
void drawEntry(const PanelContext& context, const TaskRow& row, const Rect& area) {
    const float em = context.em;
    const Palette& colors = context.palette;
    Column& column = context.state<Column>();
    const bool folded = context.rects.column.size.x <= 0.0F;
    const bool here = column.task == row.id && !folded;
    ImGui::SetCursorScreenPos(toVec2(area.min));
    const std::string title(row.title);
    if (ImGui::InvisibleButton(("##" + title).c_str(), toVec2(area.size)))
        actions::pickTask(context.commands, row.id);
    // A finger would leave the tooltip over the buttons.
    const std::string tip = std::string(row.help) + (here ? "\nClick to fold the panels." : "");
    nameItem(context, "rail " + title, context.rects.phone ? std::string{} : tip);
    const bool hovered = ImGui::IsItemHovered();
    if (column.task == row.id && context.state<KeyWalk>().offer(KeyStop::Rail)) takeKeyboard();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const Rect inner{area.min + glm::vec2(0.15F * em), area.size - glm::vec2(0.3F * em)};
    if (here) fill(list, inner, colors.panelRaised, 0.3F * em);
    const Color ink = here ? colors.accent : hovered ? colors.text : colors.textDim;
    const glm::vec2 middle(area.min.x + 0.5F * area.size.x, area.min.y + 1.3F * em);
    kDraw[static_cast<std::size_t>(row.id)](Pen(list, toVec2(middle), kSignSize * em, toU32(ink)));
    const float size = kTaskNameSize * em;
    const float width = context.fonts.text->CalcTextSizeA(size, 1e9F, 0.0F, title.c_str()).x;
    list->AddText(context.fonts.text, size,
                  {std::round(middle.x - 0.5F * width), middle.y + 0.85F * em},
                  toU32(here ? colors.text : ink), title.c_str());
    if (column.news[static_cast<std::size_t>(row.id)]) {
        list->AddCircleFilled({middle.x + 0.75F * em, middle.y - 0.6F * em}, 0.3F * em,
                              toU32(colors.rejected));
        context.where()["news " + title] = area;
    }
}

}  // namespace

std::span<const PartRow> partRows() { return kPartRows; }

void drawColumn(const PanelContext& context) {
    const Rect& area = context.rects.column;
    if (area.size.x <= 0.0F) return;
    if (beginRegion("##column", area)) {
        if (context.ui().offersTour) drawTourOffer(context);
        ImGui::PushID(static_cast<int>(context.state<Column>().task));
        drawParts(context);
        ImGui::PopID();
    }
    ImGui::End();
}

void drawRail(const PanelContext& context) {
    const Rect& area = context.rects.rail;
    if (area.size.x <= 0.0F) return;
    if (beginRegion("##rail", area, ImGuiWindowFlags_NoScrollbar)) {
        const float count = static_cast<float>(kTaskCount);
        const bool across = context.rects.phone;
        const float high = std::min(kEntryHigh * context.em, area.size.y / count);
        const glm::vec2 size =
            across ? glm::vec2(area.size.x / count, area.size.y) : glm::vec2(area.size.x, high);
        glm::vec2 at = area.min;
        for (const TaskRow& row : taskRows()) {
            drawEntry(context, row, {at, size});
            across ? at.x += size.x : at.y += size.y;
        }
    }
    ImGui::End();
}

void drawSplitter(const PanelContext& context) {
    const Rect& handle = context.rects.splitter;
    if (handle.size.x <= 0.0F || context.ui().coversView()) return;
    // A window of its own above the regions, so that neither of its neighbors gets the mouse.
    constexpr int kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                           ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    ImGui::SetNextWindowPos(toVec2(handle.min));
    ImGui::SetNextWindowSize(toVec2(handle.size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    if (ImGui::Begin("##splitter", nullptr, kFlags)) {
        ImGui::InvisibleButton("##handle", toVec2(handle.size));
        context.where()["splitter column"] = handle;
        const bool active = ImGui::IsItemActive();
        if (active || ImGui::IsItemHovered()) {
            ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
            const float thin = std::max(1.0F, 0.15F * context.em);
            fill(ImGui::GetWindowDrawList(),
                 {{handle.min.x + 0.5F * (handle.size.x - thin), handle.min.y},
                  {thin, handle.size.y}},
                 context.palette.accent);
        }
        float& width = context.settings().panels.column;
        if (active && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            width = 0.0F;
        } else if (active && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0F)) {
            // A press alone moves nothing.
            const float pixels = context.rects.column.max().x - ImGui::GetIO().MousePos.x;
            width = std::max(1.0F, pixels / context.em);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace se::view
