#include <algorithm>
#include <filesystem>

#include "panel_state/file_browser_state.h"
#include "panel_state/growth_page.h"
#include "panel_state/ui_requests.h"
#include "panel_state/ui_state.h"
#include "panels/panel.h"
#include "panels/widgets/prepare_fields.h"
#include "panels/widgets/widgets.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/field.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::view {

namespace {

constexpr int kShapesShown = 8;  ///< Rows of the list at once.
constexpr float kName = 6.4F;    ///< Width of the names before the fields, in em.

/// A dim name before the next item.
void name(const PanelContext& context, const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(kName * context.em);
    ImGui::SetNextItemWidth(-1.0F);
}

/// The particles get the keyboard focus back.
void beginByEnter(const PanelContext& context) {
    context.state<GrowthPage>().asked = GrowthAsk::Begin;
    context.requests().closePopups = true;
}

/// A field after its name. Enter in it starts.
void field(const PanelContext& context, const char* title, const char* hint, std::string& text) {
    name(context, title);
    const std::string id = std::string("##") + title;
    if (textField(id.c_str(), hint, text, kEntered)) {
        beginByEnter(context);
    }
    context.where()[std::string("field ") + title] = lastItem();
}

void drawSources(const PanelContext& context) {
    GrowthForm& form = context.state<GrowthPage>().form;
    if (ImGui::RadioButton("Shape", form.from == GrowthSource::Shape)) {
        context.run("file.new.shape");
    }
    ImGui::SameLine(kName * context.em);
    if (ImGui::RadioButton("Volume", form.from == GrowthSource::Volume)) {
        context.run("file.new.volume");
    }
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
                page.asked = GrowthAsk::Begin;
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
    field(context, "File", hint.c_str(), form.volume);
    tooltip(form.volume);
    // A long path shows its beginning.
    const std::string file = std::filesystem::path(form.volume).filename().string();
    if (file != form.volume && !file.empty()) {
        name(context, "");
        ImGui::TextUnformatted(fitted(file, ImGui::GetContentRegionAvail().x).c_str());
    }
    if (ImGui::Button("Choose...", {-1.0F, 0.0F})) {
        context.ui().browser = BrowserTask::Volume;
        context.ui().fileBrowser = true;
    }
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
    context.where()[std::string("field ") + title] = lastItem();
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

}  // namespace

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
    field(context, "Seed", "a whole number", page.form.seed);
    tooltip("Seed of the random start positions");
    field(context, "Curvature", "0 to 100", page.form.curvature);
    tooltip(
        "Denser where the surface bends: the spacing is divided by 1 + this times the curvature "
        "over its mean, at most by 5");
    drawBox(context);
    ImGui::Spacing();
    if (ImGui::Button("Restart", {-1.0F, 0.0F})) page.asked = GrowthAsk::Begin;
    context.where()["growth begin"] = lastItem();
    tooltip("Spread these particles (Enter in a field, or " + context.key("run.start") + ")");
    if (page.complaint.empty()) return;
    wrappedText("! " + page.complaint, context.palette.rejected);
}

}  // namespace se::view
