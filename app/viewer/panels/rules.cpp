/// All rules as switches: what is changed is run anew at once.
#include <imgui.h>

#include <algorithm>

#include "interface/rule_rows.h"
#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

/// Of what is not a switch: where it stands behind its name, and its width, in em.
constexpr float kName = 5.6F;
constexpr float kControl = 8.2F;

void ask(const PanelContext& context, const RuleSet& rules) { context.ui().requests.rules = rules; }

void set(const PanelContext& context, const RuleSet& rules, const RuleSetting& setting,
         double value) {
    ask(context, withRule(rules, setting.name, value));
}

/// The sets of rules; another one takes the single choices away.
void drawSets(const PanelContext& context, const RuleSet& rules) {
    ImGui::SetNextItemWidth(kControl * context.em);
    if (ImGui::BeginCombo("##set", rules.name.c_str())) {
        for (const std::string_view name : paramSetNames()) {
            const std::string text(name);
            if (ImGui::Selectable(text.c_str(), text == rules.name)) {
                ask(context, {text, {}, rules.whatIf});
            }
        }
        ImGui::EndCombo();
    }
    context.ui().where["rules set"] = lastItem();
    tooltip("The set of rules (--rules). Another one takes back what was changed singly.");
    const std::size_t count = differingCount(rules);
    ImGui::SameLine();
    ImGui::BeginDisabled(count == 0);
    if (ImGui::Button("Reset all")) ask(context, {rules.name, {}, rules.whatIf});
    context.ui().where["rules reset all"] = lastItem();
    ImGui::EndDisabled();
    tooltip("All rules as the set has them");
}

void drawFilter(const PanelContext& context) {
    auto& filter = context.ui().ruleFilter;
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##rulefilter", "filter: name, section, word, differs", filter.data(),
                             filter.size());
    context.ui().where["rules filter"] = lastItem();
}

void drawOption(const PanelContext& context, const RuleSet& rules, const RuleRow& row) {
    const RuleSetting& setting = *row.setting;
    const std::string value = valueText(setting, row.value);
    if (!ImGui::BeginCombo("##value", value.c_str())) return;
    for (std::size_t i = 0; i < setting.options.size(); ++i) {
        const std::string name(setting.options[i]);
        if (ImGui::Selectable(name.c_str(), name == value)) {
            set(context, rules, setting, static_cast<double>(i));
        }
    }
    ImGui::EndCombo();
}

/// Takes effect with Enter, or when it is left.
void drawNumber(const PanelContext& context, const RuleSet& rules, const RuleRow& row) {
    const RuleSetting& setting = *row.setting;
    double value = row.value;
    const char* format = setting.kind == SettingKind::Whole ? "%.0f" : "%.6g";
    const bool entered = ImGui::InputDouble("##value", &value, 0.0, 0.0, format,
                                            ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    if ((!entered && !left) || value == row.value) return;
    if (isValue(setting, value)) return set(context, rules, setting, value);
    context.session().say(std::string(setting.name) + ": " + valuesText(setting) + ".");
}

/// A dot before what is not as the set has it, and the way back behind it.
void drawRow(const PanelContext& context, const RuleSet& rules, const RuleRow& row) {
    const RuleSetting& setting = *row.setting;
    const std::string name(setting.name);
    const float em = context.em;
    ImGui::PushID(name.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    if (row.differs()) {
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.3F * em, at.y + 0.5F * height},
                                                    0.2F * em, toU32(context.palette.test));
    }
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.8F * em);
    ImGui::BeginGroup();
    if (row.differs()) ImGui::PushFont(context.fonts.strong);
    if (setting.kind == SettingKind::Switch) {
        bool on = row.value != 0.0;
        if (ImGui::Checkbox(name.c_str(), &on)) set(context, rules, setting, on ? 1.0 : 0.0);
        context.ui().where["rule " + name] = lastItem();
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name.c_str());
    }
    if (row.differs()) ImGui::PopFont();
    if (setting.kind != SettingKind::Switch) {
        ImGui::SameLine(kName * em);
        ImGui::SetNextItemWidth(
            std::min(kControl * em, ImGui::GetContentRegionAvail().x - 3.0F * em));
        setting.kind == SettingKind::Option ? drawOption(context, rules, row)
                                            : drawNumber(context, rules, row);
        context.ui().where["rule " + name] = lastItem();
    }
    ImGui::EndGroup();
    if (ImGui::IsItemHovered()) showTooltip(ruleHelp(row));
    if (row.differs()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - 2.9F * em);
        if (ImGui::SmallButton("reset")) set(context, rules, setting, row.usual);
        context.ui().where["reset " + name] = lastItem();
        tooltip("Back to " + valueText(setting, row.usual));
    }
    ImGui::PopID();
}

}  // namespace

void drawRules(const PanelContext& context) {
    const Session& session = context.session();
    if (!session.ready()) {
        ImGui::TextDisabled("Nothing is open.");
        return;
    }
    const RuleSet rules = session.rules();
    const std::size_t count = differingCount(rules);
    heading(context, "Rules",
            session.runsAnew() ? "running anew ..."
            : count == 0       ? "as the set has them"
                               : std::to_string(count) + (count == 1 ? " differs" : " differ"));
    drawSets(context, rules);
    drawFilter(context);
    const auto groups = ruleGroups(rules, context.ui().ruleFilter.data());
    if (groups.empty()) ImGui::TextDisabled("No rule has these words.");
    const ImVec2 usual = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {usual.x, 0.4F * usual.y});
    for (const RuleGroup& group : groups) {
        ImGui::Spacing();
        ImGui::TextDisabled("%s", group.title.c_str());
        for (const RuleRow& row : group.rows) drawRow(context, rules, row);
    }
    ImGui::PopStyleVar();
}

}  // namespace se::view
