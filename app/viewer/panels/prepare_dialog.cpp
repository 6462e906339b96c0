#include <algorithm>

#include "panel.h"
#include "text_field.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr float kChoice = 11.0F;  ///< Width of a choice before its field, in em.

/// One of several; what follows stands beside it.
template <typename T>
void choice(const PanelContext& context, const char* label, T& value, T mine, const char* help) {
    if (ImGui::RadioButton(label, value == mine)) value = mine;
    if (ImGui::IsItemVisible()) context.ui().where[std::string("prepare ") + label] = lastItem();
    tooltip(help);
}

/// A title, and whether what is there now was derived.
void part(const PanelContext& context, const char* title, bool derived) {
    ImGui::Spacing();
    heading(context, title, derived ? "derived now" : "from the input now");
}

/// A field that chooses what it belongs to.
template <typename T>
bool valueField(const PanelContext& context, const char* id, std::string& text, T& value, T mine) {
    ImGui::SameLine(kChoice * context.em);
    ImGui::SetNextItemWidth(-1.0F);
    const std::string before = text;
    const bool entered = textField(
        id, "", text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (text != before) value = mine;
    context.ui().where[std::string("prepare ") + (id + 2)] = lastItem();
    return entered;
}

bool drawNeighbors(const PanelContext& context, PrepareForm& form) {
    using Reach = PrepareForm::Reach;
    const Session& session = context.session();
    const bool computed = session.model().report.neighborsComputed;
    part(context, "Neighbors", computed);
    const bool none = computed && !session.spec().neighbors.recompute;
    choice(context, none ? "The 12 nearest, as the input has no lists" : "From the input##n",
           form.reach, Reach::File, "Its lists; if it has none, the 12 nearest");
    choice(context, "Nearest, so many", form.reach, Reach::Nearest,
           "The k nearest points (--neighbors)");
    bool entered = valueField(context, "##count", form.count, form.reach, Reach::Nearest);
    choice(context, "Within a radius", form.reach, Reach::Radius, "In scene units (--radius)");
    entered = valueField(context, "##radius", form.radius, form.reach, Reach::Radius) || entered;
    choice(context, "Within spacings", form.reach, Reach::Spacings,
           "So many times the mean distance to the nearest point (--reach)");
    entered =
        valueField(context, "##spacings", form.spacings, form.reach, Reach::Spacings) || entered;
    ImGui::Checkbox("Symmetric", &form.symmetric);
    tooltip("Whoever lists a point is listed by it as well (--symmetric)");
    ImGui::SameLine(kChoice * context.em);
    ImGui::Checkbox("Keep opposing normals", &form.keepOpposing);
    tooltip("Also neighbors whose normal opposes that of the point (--keep-opposing)");
    return entered;
}

void drawNormals(const PanelContext& context, PrepareForm& form) {
    const DerivedPieces& derived = context.session().model().report.derived;
    part(context, "Normals", derived.normals || derived.orientation);
    const bool none = derived.normals && context.session().spec().normals != NormalSource::Derived;
    choice(context, none ? "Derived, as the input has none" : "From the input##m", form.normals,
           NormalSource::AsGiven, "Derived from the positions if it has none");
    choice(context, "Turned to agree with each other", form.normals, NormalSource::Oriented,
           "Those of the input, outward for closed parts (--orient)");
    choice(context, "Derived from the positions", form.normals, NormalSource::Derived,
           "Planes through the nearest points, turned to agree (--derive-normals)");
}

bool drawWalls(const PanelContext& context, PrepareForm& form) {
    using From = WallChoice::From;
    part(context, "Walls",
         context.session().model().report.derived.types ||
             context.session().model().report.derived.rim);
    choice(context, "From the input##w", form.walls, From::File,
           "The types of its points, if it has some");
    choice(context, "The box around all points", form.walls, From::Around,
           "Points on its faces are boundary points (--box auto)");
    choice(context, "This box", form.walls, From::Box,
           "Points on its faces are boundary points (--box)");
    const BoxFields before = form.box;
    const bool entered = drawBoxFields(context, form.box);
    if (form.box != before) form.walls = From::Box;
    ImGui::Checkbox("Find rims without walls", &form.rim);
    tooltip("Points where the surface ends without a wall are boundary points (--derive-rim)");
    return entered;
}

void drawButtons(const PanelContext& context, PrepareForm& form, bool entered) {
    if (ImGui::Button("Prepare anew") || entered) {
        Result<InputSpec> spec = form.spec(context.session().spec());
        form.complaint = spec ? std::string{} : spec.error().message;
        if (spec) {
            context.ui().requests.openSpec = std::move(spec.value());
            form.open = false;
        }
    }
    context.ui().where["prepare ok"] = lastItem();
    tooltip("Read the input again with these options, and go to the start");
    ImGui::SameLine();
    if (ImGui::Button("Cancel (Esc)")) form.open = false;
    context.ui().where["prepare cancel"] = lastItem();
    if (form.complaint.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
    ImGui::TextWrapped("! %s", form.complaint.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

void drawPrepareDialog(const PanelContext& context) {
    PrepareForm& form = context.ui().prepare;
    if (!form.open || !context.session().ready()) return;
    const float em = context.em;
    const glm::vec2 screen(context.layout.status.size.x, context.layout.status.max().y);
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(30.0F * em, screen.x - 2.0F * em), std::min(39.3F * em, screen.y - 1.0F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    const bool shown = ImGui::Begin(
        "Prepare", &form.open,
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    if (shown) {
        const float buttons =
            (form.complaint.empty() ? 1.0F : 2.6F) * ImGui::GetFrameHeightWithSpacing() + 0.4F * em;
        bool entered = false;
        // The buttons stay in sight where the window is low.
        // To keys they and the fields are one.
        if (ImGui::BeginChild("##fields", {0.0F, -buttons}, false, ImGuiWindowFlags_NavFlattened)) {
            entered = drawNeighbors(context, form);
            drawNormals(context, form);
            entered = drawWalls(context, form) || entered;
            ImGui::Spacing();
            heading(context, "Noise");
            ImGui::Checkbox("Keep all points of noisy input", &form.keepNoise);
            tooltip("Robust rules set points aside that lie over or under others (--keep-noise)");
        }
        ImGui::EndChild();
        drawButtons(context, form, entered);
    }
    ImGui::End();
}

}  // namespace se::view
