/// Panel for overriding decisions at the cursor: the run forks, and can return.
#include "document/actions.h"
#include "document/document.h"
#include "panel_state/view_tools.h"
#include "panel_state/what_if_offers.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "session/layout_preset.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::view {

namespace {

/// Runs again with a what-if, or reports why the fields form none.
void rerunOrReport(const PanelContext& context, const RunSpec& rules, const Result<WhatIf>& what) {
    if (what) return context.document().rerun(withWhatIf(rules, what.value()));
    context.session().messages().say(what.error().message);
}

/// A button that adds a what-if.
void offer(const PanelContext& context, const RunSpec& rules, const WhatIf& what,
           const std::string& label, const std::string& name) {
    if (textButton(context, label, "what if " + name,
                   describe(what) + "\n--what-if \"" + lineOf(what) + "\"\nCtrl+Z undoes it."))
        context.document().rerun(withWhatIf(rules, what));
}

void drawPresent(const PanelContext& context, const RunSpec& rules) {
    Session& session = context.session();
    RunSpec left = rules;
    drawRemovable(left.whatIf, [&](const WhatIf& what, std::size_t i) {
        const std::string number = std::to_string(i + 1);
        const bool gone =
            smallButton(context, "x", "what if remove " + number, "Remove this what-if");
        ImGui::SameLine();
        if (selectable(context, fittedName(lineOf(what), ImGui::GetContentRegionAvail().x), false,
                       "what if " + number, describe(what) + "\nClick to go there."))
            session.moves().goTo(placeOf(what));
        const std::string& problem = session.input().whatIfProblem(i);
        if (!problem.empty() && !session.input().isRerunning())
            wrappedText("No effect. " + problem, context.palette.rejected);
        return gone;
    });
    if (left != rules) context.document().rerun(left);
    if (rules.whatIf.empty()) return ImGui::TextDisabled("%s", kNoWhatIfs);
    if (textButton(context, "Remove all what-ifs", "what if clear"))
        context.run("edit.whatif.clear");
}

/// The effect of a drag in the view.
void drawDragHint(const Session& session) {
    if (session.drag().held()) return dimText("Shift: along its normal. Esc takes it back.");
    if (session.drag().possible(session.picture().pivot))
        dimText("Drag a point of this pivot in the view: its decisions follow.");
}

void drawOffers(const PanelContext& context, const RunSpec& rules) {
    const Session& session = context.session();
    const Event* event = session.event();
    heading(context, "Here", addressText(session));
    if (event == nullptr) return ImGui::TextDisabled("No decision at the start of the run.");
    const auto offers = offersHere(session);
    for (std::size_t i = 0; i < offers.size(); ++i) {
        const std::string name = i == 0 ? "here" : "here " + std::to_string(i + 1);
        offer(context, rules, offers[i].what, offers[i].label, name);
    }
    const bool isWhatIf = describe(*event).starts_with("What if");
    if (isWhatIf) wrappedText("A what-if decides here: the cross above removes it.");
    if (offers.empty() && !isWhatIf) wrappedText(noOfferText(*event));
}

/// The selected point, otherwise the pivot.
Index subject(const Session& session) {
    return session.selected() != kNone ? session.selected() : session.picture().pivot;
}

void drawMove(const PanelContext& context, const RunSpec& rules, std::uint32_t pivot) {
    WhatIfForm& form = context.state<WhatIfForm>();
    constexpr const char* kNames[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        // Each has a line of its own, with room for all digits.
        fieldName(context, kNames[i], 1.8F);
        ImGui::SetNextItemWidth(-1.0F);
        ImGui::PushID(kNames[i]);
        textField("##to", kNames[i], form.to[i]);
        ImGui::PopID();
        nameItem(context, std::string("what if ") + kNames[i]);
    }
    if (textButton(context, "Move it there", "what if move",
                   "From pivot " + std::to_string(pivot) + " on; its triangles move along."))
        rerunOrReport(context, rules, form.move(pivot));
}

void drawList(const PanelContext& context, const RunSpec& rules, std::uint32_t pivot) {
    WhatIfForm& form = context.state<WhatIfForm>();
    ImGui::SetNextItemWidth(-1.0F);
    textField("##list", "its neighbors, as numbers", form.list);
    nameItem(context, "what if list");
    if (textButton(context, "Give it this list", "what if neighbors",
                   "From pivot " + std::to_string(pivot) + " on; the list is sorted by distance."))
        rerunOrReport(context, rules, form.neighbors(pivot));
}

void drawPoint(const PanelContext& context, const RunSpec& rules) {
    const Session& session = context.session();
    const Index point = subject(session);
    ImGui::Spacing();
    if (point == kNone) {
        heading(context, "Point");
        return ImGui::TextDisabled("Select a point to move it or to edit its list.");
    }
    const std::string name = nameOf(point, session.names());
    const std::string number = std::to_string(point);
    heading(context, ("Point " + number + (name == number ? "" : " (" + name + ")")).c_str(),
            session.selected() == kNone ? "the pivot" : "selected");
    context.state<WhatIfForm>().take(session, point);
    const std::uint32_t pivot = forkPivot(session);
    if (session.selected() != kNone && session.record().pivot > 0) {
        offer(context, rules, {WhatIfKind::Pivot, pivot, Stage::Advance, point, Vec3(0.0), {}},
              "Continue there after this pivot", "pivot");
    }
    drawMove(context, rules, pivot);
    drawList(context, rules, pivot);
}

}  // namespace

void drawWhatIf(const PanelContext& context) {
    const Session& session = context.session();
    context.state<MoveTool>().offeredIn = ImGui::GetFrameCount();
    const RunSpec rules = session.input().rules();
    const std::size_t count = rules.whatIf.size();
    partNote(count == 0 ? "" : counted(count, "change", "changes"));
    drawPresent(context, rules);
    drawDragHint(session);
    ImGui::Spacing();
    drawOffers(context, rules);
    drawPoint(context, rules);
}

void drawWhatIfBanner(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready() || context.rects.layoutPreset == LayoutPreset::Present) return;
    const std::size_t count = session.input().spec().whatIf.size();
    if (count == 0) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * context.em, 0.3F * context.em});
    if (beginOverView(context, "##whatif", 0.6F, std::nullopt, &Palette::test)) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(("What if: " + counted(count, "change", "changes")).c_str());
        ImGui::SameLine();
        if (smallButton(context, "Remove all", "true run", "Remove all what-ifs"))
            context.run("edit.whatif.clear");
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace se::view
