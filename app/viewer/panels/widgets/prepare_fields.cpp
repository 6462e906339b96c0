// The fields of the preparation: one form for two panels.

#include <imgui.h>

#include <algorithm>
#include <span>
#include <utility>

#include "input/key_routing.h"
#include "session/session.h"
#include "widgets.h"

namespace se::view {

namespace {

constexpr float kChoice = 11.0F;  ///< Width of a choice before its field, in em.
constexpr float kField = 4.5F;    ///< Minimum width of a field.
constexpr float kTwo = 22.0F;     ///< Width from which two switches are side by side.

/// Position of a field after its choice.
float xOfFields(const PanelContext& context) {
    const float room = ImGui::GetContentRegionMax().x - kField * context.em;
    return std::min(kChoice * context.em, room);
}

void besideIfRoom(const PanelContext& context) {
    if (ImGui::GetContentRegionMax().x >= kTwo * context.em) ImGui::SameLine(kChoice * context.em);
}

/// The form and the context of its drawing.
struct Fields {
    const PanelContext& context;
    PrepareForm& form;
    const std::string& prefix;

    /// Names the last item, if it can be seen, and gives it a tooltip.
    void name(const char* item, const char* tip = "") const {
        if (ImGui::IsItemVisible()) nameItem(context, prefix + item, tip);
    }
};

/// A choice; the next item is beside it.
template <typename T>
void choice(const Fields& fields, const char* label, T& value, T mine, const char* help) {
    if (ImGui::RadioButton(label, value == mine)) value = mine;
    fields.name(label, help);
}

void toggle(const Fields& fields, const char* label, bool& value, const char* help) {
    ImGui::Checkbox(label, &value);
    fields.name(label, help);
}

/// A title, and whether the current data was derived.
void part(const PanelContext& context, const char* title, bool derived) {
    ImGui::Spacing();
    heading(context, title, derived ? "derived now" : "from the input now");
}

/// A field; typing in it makes its choice.
template <typename T>
bool valueField(const Fields& fields, const char* id, std::string& text, T& value, T mine) {
    ImGui::SameLine(xOfFields(fields.context));
    ImGui::SetNextItemWidth(-1.0F);
    const std::string before = text;
    const bool entered = textField(id, "", text, kEntered);
    if (ImGui::IsItemActive()) fields.context.state<TypingWait>().takesKeys();
    if (text != before) value = mine;
    fields.name(id + 2);
    return entered;
}

bool drawNeighbors(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    using Reach = PrepareForm::Reach;
    const Session& session = context.session();
    const bool computed = session.model().report.neighborsComputed;
    part(context, "Neighbors", computed);
    const bool none = computed && !session.input().spec().neighbors.recompute;
    choice(fields, none ? "The 12 nearest, as the input has no lists" : "From the input##n",
           form.reach, Reach::File, "Its lists; if it has none, the 12 nearest");
    choice(fields, "K nearest", form.reach, Reach::Nearest, "The k nearest points (--neighbors)");
    if (std::exchange(form.wantsKeyboard, false)) ImGui::SetKeyboardFocusHere();
    bool entered = valueField(fields, "##count", form.count, form.reach, Reach::Nearest);
    choice(fields, "Within a radius", form.reach, Reach::Radius, "In scene units (--radius)");
    entered = valueField(fields, "##radius", form.radius, form.reach, Reach::Radius) || entered;
    choice(fields, "Within spacings", form.reach, Reach::Spacings,
           "A multiple of the mean distance to the nearest point (--reach)");
    entered =
        valueField(fields, "##spacings", form.spacings, form.reach, Reach::Spacings) || entered;
    toggle(fields, "Symmetric", form.symmetric, "Make neighbor lists symmetric (--symmetric)");
    besideIfRoom(context);
    toggle(fields, "Keep opposing normals", form.keepOpposing,
           "Keep neighbors whose normal opposes that of the point (--keep-opposing)");
    return entered;
}

/// Three fields beside each other. True if Enter was pressed in one.
bool drawCoordinates(const PanelContext& context, const std::string& name,
                     std::span<std::string> texts) {
    bool entered = false;
    const float gap = 0.3F * context.em;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0.0F, gap);
        ImGui::SetNextItemWidth(width);
        const std::string id = "##" + name + std::to_string(i);
        constexpr const char* kHints[] = {"x", "y", "z"};
        entered = textField(id.c_str(), kHints[i], texts[i], kEntered) || entered;
    }
    return entered;
}

bool drawNormals(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    const DerivedPieces& derived = context.session().model().report.derived;
    part(context, "Normals", derived.normals || derived.orientation);
    const bool none =
        derived.normals && context.session().input().spec().normals != NormalSource::Derived;
    choice(fields, none ? "Derived, as the input has none" : "From the input##m", form.normals,
           NormalSource::AsGiven, "Derived from the positions if it has none");
    choice(fields, "Flipped to agree with each other", form.normals, NormalSource::Oriented,
           "Those of the input, outward for closed parts (--orient)");
    choice(fields, "Derived from the positions", form.normals, NormalSource::Derived,
           "Planes through the nearest points, flipped to agree (--derive-normals)");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Facing a scanner at");
    ImGui::SameLine(xOfFields(context));
    const auto before = form.scanner;
    ImGui::BeginGroup();
    const bool entered = drawCoordinates(context, "scanner", form.scanner);
    ImGui::EndGroup();
    fields.name("scanner",
                "Flipped and derived normals face this position, part by part; empty: they face "
                "outward (--scanner)");
    // Normals of the input stay as they are.
    if (form.scanner != before && form.normals == NormalSource::AsGiven)
        form.normals = NormalSource::Oriented;
    return entered;
}

bool drawWalls(const Fields& fields) {
    const auto& [context, form, prefix] = fields;
    using From = WallChoice::From;
    const DerivedPieces& derived = context.session().model().report.derived;
    part(context, "Walls", derived.types || derived.rim);
    choice(fields, "From the input##w", form.walls, From::File,
           "The types of its points, if it has any");
    choice(fields, "The box around all points", form.walls, From::Around,
           "Points on its faces are boundary points (--box auto)");
    choice(fields, "This box", form.walls, From::Box,
           "Points on its faces are boundary points (--box)");
    const BoxFields before = form.box;
    const bool entered = drawBoxFields(context, form.box);
    if (form.box != before) form.walls = From::Box;
    toggle(fields, "Find rims without walls", form.rim,
           "Points where the surface ends without a wall are boundary points (--derive-rim)");
    return entered;
}

}  // namespace

bool drawPrepareFields(const PanelContext& context, PrepareForm& form, const std::string& prefix) {
    const Fields fields{context, form, prefix};
    bool entered = drawNeighbors(fields);
    entered = drawNormals(fields) || entered;
    entered = drawWalls(fields) || entered;
    ImGui::Spacing();
    heading(context, "Noise and strays");
    toggle(fields, "Keep all points of noisy input", form.keepNoise,
           "Robust rules set aside points that lie above or below others (--keep-noise)");
    toggle(fields, "Keep points far from all others", form.keepStrays,
           "Corrected and robust rules set them aside (--keep-strays)");
    return entered;
}

bool drawBoxFields(const PanelContext& context, BoxFields& fields) {
    bool entered = false;
    for (std::size_t row = 0; row < 2; ++row) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", row == 0 ? "from" : "to");
        ImGui::SameLine(3.0F * context.em);
        const auto texts = std::span(fields).subspan(3 * row, 3);
        entered = drawCoordinates(context, row == 0 ? "low" : "high", texts) || entered;
    }
    return entered;
}

}  // namespace se::view
