#include <algorithm>
#include <array>
#include <cstdio>

#include "input/tab_order.h"
#include "panel_state/growth_page.h"
#include "panels/panel.h"
#include "panels/widgets/camera_mouse.h"
#include "panels/widgets/widgets.h"
#include "run/strings.h"
#include "scene/draw_list.h"
#include "spiraling_edge/sampling/sampler.h"

namespace se::view {

namespace {

/// Values that fit beside each other share a line; the others go to the next.
class Values {
  public:
    explicit Values(const PanelContext& context) : context_(context) {}

    void add(const char* name, const std::string& value) {
        const float gap = 1.4F * context_.em;
        const float width =
            ImGui::CalcTextSize(name).x + ImGui::CalcTextSize(value.c_str()).x + 0.4F * context_.em;
        if (end_ > 0.0F && end_ + gap + width <= ImGui::GetContentRegionMax().x) {
            ImGui::SameLine(0.0F, gap);
        }
        ImGui::TextDisabled("%s", name);
        ImGui::SameLine(0.0F, 0.4F * context_.em);
        ImGui::TextUnformatted(value.c_str());
        end_ = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    }

  private:
    const PanelContext& context_;
    float end_ = 0.0F;
};

void drawValues(const PanelContext& context) {
    const GrowthPage& page = context.state<GrowthPage>();
    const GrowthNumbers& n = page.numbers;
    if (!page.hasPoints()) {
        ImGui::TextDisabled("%s", page.phase == GrowthPhase::Finding ? "Finding the surface ..."
                                                                     : "There are no points yet.");
        return;
    }
    Values values(context);
    values.add("points", grouped(n.points));
    values.add("spacing", formatted("%.4g", n.quality.spacing));
    values.add("varying by", formatted("%.1f %%", 100.0 * n.quality.variation));
    values.add("off by at most", formatted("%.1g spacings", n.quality.off));
    if (n.onWalls > 0) {
        values.add("on walls",
                   grouped(n.onWalls) + (n.corners > 0 ? ", corners " + grouped(n.corners) : ""));
    }
}

struct Button {
    const char* id;
    Icon icon;
    const char* command;
    const char* text;
};

void drawSteppers(const PanelContext& context) {
    const GrowthPage& page = context.state<GrowthPage>();
    const bool over = page.phase == GrowthPhase::Done;
    const bool plays = page.moving();
    const std::array buttons = {
        Button{"##restart", Icon::SkipStart, "run.start", "Restart"},
        Button{"##play", plays ? Icon::Pause : Icon::Play, "run.play",
               plays  ? "Pause"
               : over ? "Restart"
                      : "Continue spreading, 30 steps per second"},
        Button{"##step", Icon::StepForward, "step.event.next", "One step, then pause"},
        Button{"##finish", Icon::SkipEnd, "run.end", "All remaining steps, at full speed"}};
    for (const Button& b : buttons) {
        const bool forward = b.icon == Icon::StepForward || b.icon == Icon::SkipEnd;
        const bool enabled = !forward || (!over && page.phase != GrowthPhase::Failed);
        const std::string help = std::string(b.text) + " (" + context.key(b.command) + ")";
        if (iconButton(b.id, b.icon, help.c_str(), enabled, b.icon == Icon::Pause, context)) {
            context.run(b.command);
        }
        context.where()[std::string("growth ") + (b.id + 2)] = lastItem();
        ImGui::SameLine(0.0F, 0.2F * context.em);
    }
}

void drawProgress(const PanelContext& context, float width) {
    const GrowthPage& page = context.state<GrowthPage>();
    const int all = Sampler::allSteps();
    const bool finding = page.phase == GrowthPhase::Finding;
    const std::string step =
        finding ? "finding the surface"
                : "step " + std::to_string(page.numbers.step) + " of " + std::to_string(all);
    const float share = finding ? static_cast<float>(page.found)
                                : static_cast<float>(page.numbers.step) / static_cast<float>(all);
    ImGui::ProgressBar(share, {width, ImGui::GetFrameHeight()}, step.c_str());
}

/// Buttons to use or save the points.
void drawEndings(const PanelContext& context) {
    GrowthPage& page = context.state<GrowthPage>();
    ImGui::BeginDisabled(!page.hasPoints());
    ImGui::PushStyleColor(ImGuiCol_Button, toVec4(context.palette.accent));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered,
                          toVec4(mix(context.palette.accent, context.palette.text, 0.15F)));
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.accentText));
    if (ImGui::Button("Use these points")) page.asked = GrowthAsk::Use;
    ImGui::PopStyleColor(3);
    context.where()["growth use"] = lastItem();
    tooltip(page.phase == GrowthPhase::Done ? "Open a run on them"
                                            : "Open a run on them as they are now");
    ImGui::SameLine();
    if (ImGui::Button("Save as PLY...")) context.run("file.savepoints");
    context.where()["growth save"] = lastItem();
    const std::string command = sampleCommand(page.made);
    tooltip(command.empty() ? "Save them as they are now" : "The same file as by\n" + command);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) page.asked = GrowthAsk::Leave;
    context.where()["growth cancel"] = lastItem();
    tooltip("Leave this page (" + context.key("help.leave") + ")");
}

float endingsWidth() {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 2.0F * style.ItemSpacing.x;
    for (const char* label : {"Use these points", "Save as PLY...", "Cancel"}) {
        width += ImGui::CalcTextSize(label).x + 2.0F * style.FramePadding.x;
    }
    return width;
}

void drawBar(const PanelContext& context) {
    const float em = context.em;
    drawSteppers(context);
    const float rest = ImGui::GetContentRegionAvail().x - endingsWidth() - em;
    const bool row = rest >= 9.0F * em;
    drawProgress(context, row ? rest : -1.0F);
    if (row) ImGui::SameLine(0.0F, em);
    drawEndings(context);
    const std::string& said = context.state<GrowthPage>().said;
    drawValues(context);
    if (!said.empty())
        ImGui::TextUnformatted(fitted(said, ImGui::GetContentRegionAvail().x).c_str());
}

void drawParticles(const PanelContext& context) {
    const Rect& view = context.rects.view;
    if (view.size.x < 1.0F || view.size.y < 1.0F) return;
    const auto texture =
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(context.viewTexture));
    ImGui::SetCursorScreenPos(toVec2(view.min));
    ImGui::InvisibleButton("##scene", toVec2(view.size),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    moveCameraByMouse(context);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddImage(texture, toVec2(view.min), toVec2(view.max()), {0, 1}, {1, 0});
    drawAxes(context, {});
}

/// Legend of the shapes.
void drawKey(const PanelContext& context) {
    const GrowthNumbers& n = context.state<GrowthPage>().numbers;
    if (n.onWalls == 0) return;
    struct Row {
        Shape shape;
        Color color;
        const char* text;
        bool there;
    };
    const Palette& c = context.palette;
    const std::array rows = {Row{Shape::Disc, c.used, "inside", true},
                             Row{Shape::Square, c.first, "on a wall", true},
                             Row{Shape::Diamond, c.last, "in a corner", n.corners > 0}};
    const float em = context.em;
    ImDrawList* list = ImGui::GetWindowDrawList();
    glm::vec2 at = context.rects.view.min + glm::vec2(1.0F * em, 0.9F * em);
    const float width = ImGui::CalcTextSize(rows[1].text).x + 2.0F * em;
    const float height = (n.corners > 0 ? 4.05F : 2.7F) * em;
    list->AddRectFilled({at.x - 0.4F * em, at.y - 0.3F * em},
                        {at.x + width - 0.4F * em, at.y + height},
                        toU32(c.background.withAlpha(0.78F)), 0.3F * em);
    for (const Row& row : rows) {
        if (!row.there) continue;
        drawShape(list, {at.x + 0.4F * em, at.y + 0.6F * em}, 0.7F * em, row.shape,
                  toU32(row.color));
        list->AddText({at.x + 1.2F * em, at.y}, toU32(c.textDim), row.text);
        at.y += 1.35F * em;
    }
}

}  // namespace

void drawGrowthPage(const PanelContext& context) {
    const PanelRects& l = context.rects;
    if (beginRegion("##growthForm", l.left)) {
        if (context.state<KeyWalk>().offer(KeyStop::Content)) takeKeyboardHere();
        drawGrowthForm(context);
        ImGui::GetWindowDrawList()->AddLine({l.left.max().x - 0.5F, l.left.min.y},
                                            {l.left.max().x - 0.5F, l.left.max().y},
                                            toU32(context.palette.border));
    }
    ImGui::End();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, toVec4(context.palette.background));
    const bool open = beginRegion(
        "##view", l.view, ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    if (open) {
        drawParticles(context);
        drawKey(context);
    }
    ImGui::End();
    if (beginRegion("##growthBar", l.narration)) drawBar(context);
    ImGui::End();
}

}  // namespace se::view
