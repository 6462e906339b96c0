/// Panel for overriding decisions at the cursor: the run forks, and can return.
#include <imgui.h>

#include <algorithm>

#include "panel_state/ui_requests.h"
#include "panel_state/what_if_offers.h"
#include "panels/panel.h"
#include "panels/widgets/widgets.h"
#include "run/rule_set.h"
#include "session/layout_preset.h"
#include "session/session.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::view {

namespace {

void ask(const PanelContext& context, const RuleSet& rules) { context.requests().rules = rules; }

/// A button that adds a what-if.
void offer(const PanelContext& context, const RuleSet& rules, const WhatIf& what,
           const std::string& label, const std::string& name) {
    if (ImGui::Button(label.c_str())) ask(context, withWhatIf(rules, what));
    context.where()["what if " + name] = lastItem();
    tooltip(describe(what) + "\n--what-if \"" + lineOf(what) + "\"\nCtrl+Z undoes it.");
}

void drawPresent(const PanelContext& context, const RuleSet& rules) {
    Session& session = context.session();
    for (std::size_t i = 0; i < rules.whatIf.size(); ++i) {
        const WhatIf& what = rules.whatIf[i];
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton("x")) ask(context, withoutWhatIf(rules, i));
        context.where()["what if remove " + std::to_string(i + 1)] = lastItem();
        tooltip("Remove this what-if");
        ImGui::SameLine();
        const std::string text = lineOf(what);
        if (ImGui::Selectable(fitted(text, ImGui::GetContentRegionAvail().x).c_str())) {
            session.moves().goTo(placeOf(what));
        }
        context.where()["what if " + std::to_string(i + 1)] = lastItem();
        tooltip(describe(what) + "\nClick to go there.");
        const std::string& problem = session.input().whatIfProblem(i);
        if (!problem.empty() && !session.input().isRerunning()) {
            ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
            wrappedText("No effect. " + problem);
            ImGui::PopStyleColor();
        }
        ImGui::PopID();
    }
    if (rules.whatIf.empty()) {
        ImGui::TextDisabled("No what-ifs are active.");
        return;
    }
    if (ImGui::Button("Remove all what-ifs")) context.run("edit.whatif.clear");
    context.where()["what if clear"] = lastItem();
}

void drawOffers(const PanelContext& context, const RuleSet& rules) {
    const Session& session = context.session();
    const Event* event = session.event();
    heading(context, "Here", addressText(session));
    if (event == nullptr) {
        ImGui::TextDisabled("No decision at the start of the run.");
        return;
    }
    const auto offers = offersHere(session);
    for (std::size_t i = 0; i < offers.size(); ++i) {
        const std::string name = i == 0 ? "here" : "here " + std::to_string(i + 1);
        offer(context, rules, offers[i].what, offers[i].label, name);
    }
    const bool said = describe(*event).starts_with("What if");
    if (said) wrappedText("A what-if decides here: the cross above removes it.");
    if (offers.empty() && !said) {
        wrappedText(noOfferText(*event));
    }
}

/// The selected point, otherwise the pivot.
Index subject(const Session& session) {
    return session.selected() != kNone ? session.selected() : session.picture().pivot;
}

void drawMove(const PanelContext& context, const RuleSet& rules, std::uint32_t pivot) {
    WhatIfForm& form = context.state<WhatIfForm>();
    constexpr const char* kNames[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        // Each has a line of its own, with room for all digits.
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", kNames[i]);
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1.0F);
        ImGui::PushID(kNames[i]);
        textField("##to", kNames[i], form.to[i]);
        ImGui::PopID();
        context.where()[std::string("what if ") + kNames[i]] = lastItem();
    }
    if (ImGui::Button("Move it there")) {
        const auto what = form.move(pivot);
        what ? ask(context, withWhatIf(rules, what.value()))
             : context.session().messages().say(what.error().message);
    }
    context.where()["what if move"] = lastItem();
    tooltip("From pivot " + std::to_string(pivot) + " on; its triangles move along.");
}

void drawList(const PanelContext& context, const RuleSet& rules, std::uint32_t pivot) {
    WhatIfForm& form = context.state<WhatIfForm>();
    ImGui::SetNextItemWidth(-1.0F);
    textField("##list", "its neighbors, as numbers", form.list);
    context.where()["what if list"] = lastItem();
    if (ImGui::Button("Give it this list")) {
        const auto what = form.neighbors(pivot);
        what ? ask(context, withWhatIf(rules, what.value()))
             : context.session().messages().say(what.error().message);
    }
    context.where()["what if neighbors"] = lastItem();
    tooltip("From pivot " + std::to_string(pivot) + " on; the list is sorted by distance.");
}

void drawPoint(const PanelContext& context, const RuleSet& rules) {
    const Session& session = context.session();
    const Index point = subject(session);
    ImGui::Spacing();
    if (point == kNone) {
        heading(context, "Point");
        ImGui::TextDisabled("Select a point to move it or to edit its list.");
        return;
    }
    heading(context, ("Point " + std::to_string(point)).c_str(),
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
    if (!session.ready()) {
        ImGui::TextDisabled("Nothing is open.");
        return;
    }
    const RuleSet rules = session.input().rules();
    const std::size_t count = rules.whatIf.size();
    heading(context, "What if",
            count == 0 ? "" : std::to_string(count) + (count == 1 ? " change" : " changes"));
    drawPresent(context, rules);
    ImGui::Spacing();
    drawOffers(context, rules);
    drawPoint(context, rules);
}

void drawWhatIfBanner(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready() || context.rects.layoutPreset == LayoutPreset::Present) return;
    const std::size_t count = session.input().spec().whatIf.size();
    if (count == 0) return;
    const Rect& view = context.rects.view;
    const float em = context.em;
    ImGui::SetNextWindowPos({view.min.x + 0.5F * view.size.x, view.min.y + 0.6F * em},
                            ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * em, 0.3F * em});
    ImGui::PushStyleColor(ImGuiCol_Border, toVec4(context.palette.test));
    if (ImGui::Begin("##whatif", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(
            ("What if: " + std::to_string(count) + (count == 1 ? " change" : " changes")).c_str());
        ImGui::SameLine();
        if (ImGui::SmallButton("Remove all")) context.run("edit.whatif.clear");
        context.where()["true run"] = lastItem();
        tooltip("Remove all what-ifs");
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace se::view
