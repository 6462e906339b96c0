// The page that replaces all panels while new points spread: the form of what they are made of, the
// view of the particles, and the bar to play and to use them.
#include <algorithm>
#include <array>
#include <filesystem>

#include "document/actions.h"
#include "document/new_points.h"
#include "document/ui_state.h"
#include "panels/widgets/widgets.h"
#include "run/strings.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/field.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

// ---- The form: what the points are made of ------------------------------------------------------

constexpr int kShapesShown = 8;  ///< Rows of the list at once.
constexpr float kName = 6.4F;    ///< Width of the names before the fields, in em.

/// A dim name before the next item.
void name(const PanelContext& context, const char* text) {
    fieldName(context, text, kName);
    ImGui::SetNextItemWidth(-1.0F);
}

/// Starts spreading. The particles get the keyboard focus back.
void beginByEnter(const PanelContext& context) {
    context.commands.sampling.start();
    context.ui().closesPopups = true;
}

/// A field after its name. Enter in it starts.
void field(const PanelContext& context, const char* title, const char* hint, std::string& text,
           const std::string& tip = {}) {
    name(context, title);
    const std::string id = std::string("##") + title;
    const bool entered = textField(id.c_str(), hint, text, kEntered);
    nameItem(context, std::string("field ") + title, tip);
    if (entered) beginByEnter(context);
}

void drawSources(const PanelContext& context) {
    GrowthForm& form = context.state<GrowthPage>().form;
    if (ImGui::RadioButton("Shape", form.from == GrowthSource::Shape))
        context.run("file.new.shape");
    ImGui::SameLine(kName * context.em);
    if (ImGui::RadioButton("Volume", form.from == GrowthSource::Volume))
        context.run("file.new.volume");
}

void drawShapes(const PanelContext& context) {
    GrowthPage& page = context.state<GrowthPage>();
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const auto all = static_cast<int>(shapes().size());
    const float high = row * static_cast<float>(context.rects.left.size.y > 44.0F * context.em
                                                    ? all
                                                    : std::min(all, kShapesShown));
    const ImGuiStyle& style = ImGui::GetStyle();
    if (ImGui::BeginChild("##shapes", {-1.0F, high + 2.0F * style.WindowPadding.y}, true)) {
        const float room = ImGui::GetContentRegionAvail().x;
        for (const se::Shape& shape : shapes()) {
            const std::string id(shape.id);
            const bool chosen = page.form.shape == id;
            const std::string label = fittedWords(std::string(shape.title), room) + "##" + id;
            if (ImGui::Selectable(label.c_str(), chosen)) {
                page.form.choose(id);
                context.commands.sampling.start();
            }
            if (ImGui::IsItemVisible()) context.where()["shape " + id] = lastItem();
            tooltip(std::string(shape.title) + " (" + id + ")");
        }
    }
    ImGui::EndChild();
}

void drawVolume(const PanelContext& context) {
    GrowthForm& form = context.state<GrowthPage>().form;
    const std::string hint = "path of a " + wordList(volumeExtensions(), "or");
    field(context, "File", hint.c_str(), form.volume, form.volume);
    // A long path shows its beginning.
    const std::string file = std::filesystem::path(form.volume).filename().string();
    if (file != form.volume && !file.empty()) {
        name(context, "");
        ImGui::TextUnformatted(fittedName(file, ImGui::GetContentRegionAvail().x).c_str());
    }
    if (ImGui::Button("Choose...", {-1.0F, 0.0F}))
        actions::openBrowser(context.commands, BrowserTask::Volume);
}

/// One of the two ways to give the number of points, with its field; typing there chooses it.
void drawNumber(const PanelContext& context, const char* title, const char* help, bool spacing) {
    GrowthForm& form = context.state<GrowthPage>().form;
    std::string& text = spacing ? form.spacing : form.count;
    if (ImGui::RadioButton(title, form.bySpacing == spacing)) form.bySpacing = spacing;
    tooltip(help);
    ImGui::SameLine(kName * context.em);
    ImGui::SetNextItemWidth(-1.0F);
    const std::string before = text;
    const std::string id = std::string("##") + title;
    const bool entered = textField(id.c_str(), "", text, kEntered);
    // Enter starts; only typing here chooses this one.
    if (text != before) form.bySpacing = spacing;
    nameItem(context, std::string("field ") + title);
    if (entered) beginByEnter(context);
}

void drawBox(const PanelContext& context) {
    GrowthPage& page = context.state<GrowthPage>();
    bool cut = page.form.cut;
    if (ImGui::Checkbox("Clip to a box", &cut)) {
        if (cut) page.form.cutByOwnBox();
        page.form.cut = cut;
    }
    tooltip("Points on its walls are boundary points");
    if (page.form.cut && drawBoxFields(context, page.form.box)) beginByEnter(context);
}

void drawGrowthForm(const PanelContext& context) {
    GrowthPage& page = context.state<GrowthPage>();
    heading(context, "New points");
    drawSources(context);
    page.form.from == GrowthSource::Shape ? drawShapes(context) : drawVolume(context);
    ImGui::Spacing();
    field(context, "Isovalue",
          page.form.from == GrowthSource::Shape ? "that of the shape" : "that of the volume",
          page.form.isovalue);
    drawNumber(context, "Points", "Exact number", false);
    drawNumber(context, "Spacing", "As many as fit at this distance", true);
    field(context, "Seed", "a whole number", page.form.seed, "Seed of the random start positions");
    field(context, "Curvature", "0 to 100", page.form.curvature,
          "Denser where the surface bends: the spacing is divided by 1 + this times the curvature "
          "over its mean, at most by 5");
    drawBox(context);
    ImGui::Spacing();
    if (textButton(context, "Restart", "growth begin",
                   "Spread these particles (Enter in a field, or " + context.key("run.start") + ")",
                   -1.0F))
        context.commands.sampling.start();
    complain(context, page.complaint);
}

// ---- The bar and the view -----------------------------------------------------------------------

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
    const Growth& growth = context.commands.sampling.growth();
    if (!growth.hasPoints())
        return ImGui::TextDisabled("%s", growth.phase() == GrowthPhase::Finding
                                             ? "Finding the surface ..."
                                             : "There are no points yet.");
    const GrowthPicture& n = *growth.picture();
    Values values(context);
    values.add("points", grouped(n.points->position.size()));
    values.add("spacing", formatted("%.4g", n.quality.spacing));
    values.add("varying by", formatted("%.1f %%", 100.0 * n.quality.variation));
    values.add("off by at most", formatted("%.1g spacings", n.quality.off));
    if (n.onWalls > 0) {
        values.add("on walls",
                   grouped(n.onWalls) + (n.corners > 0 ? ", corners " + grouped(n.corners) : ""));
    }
}

constexpr std::array kAgain = {CommandButton{"##restart", Icon::SkipStart, "run.start", "Restart"}};
constexpr std::array kOn = {
    CommandButton{"##step", Icon::StepForward, "step.event.next", "One step, then pause"},
    CommandButton{"##finish", Icon::SkipEnd, "run.end", "All remaining steps, at full speed"}};

void drawSteppers(const PanelContext& context) {
    const NewPoints& points = context.commands.sampling;
    const GrowthPhase phase = points.growth().phase();
    const bool over = phase == GrowthPhase::Done;
    const bool plays = points.moving();
    const CommandButton play{"##play", plays ? Icon::Pause : Icon::Play, "run.play",
                             plays  ? "Pause"
                             : over ? "Restart"
                                    : "Continue spreading"};
    drawButtons(context, kAgain, true);
    drawCommandButton(context, play, withKeys(context, play.text, play.command), true, true);
    ImGui::SameLine(0.0F, 0.2F * context.em);
    drawButtons(context, kOn, !over && phase != GrowthPhase::Failed);
    drawSpeed(context, points.playback());
    ImGui::SameLine(0.0F, 0.7F * context.em);
}

void drawProgress(const PanelContext& context, float width) {
    const Growth& growth = context.commands.sampling.growth();
    const int all = Sampler::allSteps();
    const int made = growth.picture() != nullptr ? growth.picture()->step : 0;
    const bool finding = growth.phase() == GrowthPhase::Finding;
    const std::string step = finding
                                 ? "finding the surface"
                                 : "step " + std::to_string(made) + " of " + std::to_string(all);
    const float share = finding ? static_cast<float>(growth.found())
                                : static_cast<float>(made) / static_cast<float>(all);
    ImGui::ProgressBar(share, {width, ImGui::GetFrameHeight()}, step.c_str());
}

/// Buttons to use or save the points.
void drawEndings(const PanelContext& context) {
    const Growth& growth = context.commands.sampling.growth();
    ImGui::BeginDisabled(!growth.hasPoints());
    if (accentButton(context, true, "Use these points", "growth use",
                     growth.phase() == GrowthPhase::Done ? "Open a run on them"
                                                         : "Open a run on them as they are now"))
        context.commands.sampling.use();
    ImGui::SameLine();
    const std::string command = sampleCommand(growth.spec());
    if (textButton(
            context, "Save as PLY...", "growth save",
            command.empty() ? "Save them as they are now" : "The same file as by\n" + command))
        context.run("file.savepoints");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (textButton(context, "Cancel", "growth cancel",
                   "Leave this page (" + context.key("help.leave") + ")"))
        context.commands.sampling.leave();
}

void drawBar(const PanelContext& context) {
    const float em = context.em;
    drawSteppers(context);
    const float rest = ImGui::GetContentRegionAvail().x - em -
                       buttonsWidth({"Use these points", "Save as PLY...", "Cancel"});
    const bool row = rest >= 9.0F * em;
    drawProgress(context, row ? rest : -1.0F);
    if (row) ImGui::SameLine(0.0F, em);
    drawEndings(context);
    const std::string& message = context.state<GrowthPage>().message;
    drawValues(context);
    if (!message.empty())
        ImGui::TextUnformatted(fitted(message, ImGui::GetContentRegionAvail().x).c_str());
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
    if (beginView(context, "##view")) {
        // The axes take clicks before the scene does, and lie over it.
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.ChannelsSplit(2);
        list.ChannelsSetCurrent(1);
        drawAxes(context, {});
        list.ChannelsSetCurrent(0);
        offerView(context);
        moveCameraByMouse(context);
        drawViewPicture(context);
        list.ChannelsMerge();
        drawGrowthLegend(context);
    }
    ImGui::End();
    if (beginRegion("##growthBar", l.narration)) drawBar(context);
    ImGui::End();
}

}  // namespace se::view
