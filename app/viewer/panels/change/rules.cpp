// All rules as switches: a change re-runs the input at once.
#include "rules.h"

#include <algorithm>
#include <array>

#include "document/document.h"
#include "panels/widgets/widgets.h"
#include "rows/rule_rows.h"
#include "session/session.h"

namespace se::view {

namespace {

struct RuleFilter {
    std::array<char, 64> typed{};
};

/// Position after its name, and width, of an input that is not a switch, in em.
constexpr float kNameWidth = 7.0F;
constexpr float kControl = 8.2F;
/// The width of the longest option; its position below the name.
constexpr float kLongestControl = 11.0F;
constexpr float kIndentWidth = 2.0F;

/// The row to draw, and the choice made there.
struct RuleList {
    const PanelContext& context;
    const RunSpec& rules;
    const RuleListFields& place;
    std::optional<RunSpec> chosen = std::nullopt;

    void set(const RuleSetting& setting, double value) {
        chosen = withRule(rules, setting.name, value);
    }
    /// Records the rectangle of the last item under this name, for test scripts.
    void name(const std::string& item) const { context.where()[place.prefix + item] = lastItem(); }
};

void drawOption(RuleList& list, const RuleRow& row) {
    const RuleSetting& setting = *row.setting;
    const std::string value = valueText(setting, row.value);
    if (!ImGui::BeginCombo("##value", value.c_str())) return;
    for (std::size_t i = 0; i < setting.options.size(); ++i) {
        const std::string name(setting.options[i]);
        if (ImGui::Selectable(name.c_str(), name == value)) {
            list.set(setting, static_cast<double>(i));
        }
    }
    ImGui::EndCombo();
}

/// Takes effect on Enter, or when the field loses the focus.
void drawNumber(RuleList& list, const RuleRow& row) {
    const RuleSetting& setting = *row.setting;
    double value = row.value;
    const char* format = setting.kind == SettingKind::Whole ? "%.0f" : "%.6g";
    const bool entered = ImGui::InputDouble("##value", &value, 0.0, 0.0, format,
                                            ImGuiInputTextFlags_EnterReturnsTrue);
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    if ((!entered && !left) || value == row.value) return;
    if (isValue(setting, value)) return list.set(setting, value);
    list.context.session().messages().say(std::string(setting.name) + ": " + valuesText(setting) +
                                          ".");
}

/// One sentence, below the name.
void drawEffect(const RuleList& list, const RuleRow& row) {
    ImGui::PushFont(list.context.fonts.small);
    ImGui::Indent(kIndentWidth * list.context.em);
    dimText(ruleSentence(row));
    list.name("effect " + std::string(row.setting->name));
    ImGui::Unindent(kIndentWidth * list.context.em);
    ImGui::PopFont();
}

/// A dot before a value that differs from the set, and a button to reset it.
void drawRow(RuleList& list, const RuleRow& row) {
    const PanelContext& context = list.context;
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
        if (ImGui::Checkbox(name.c_str(), &on)) list.set(setting, on ? 1.0 : 0.0);
        list.name("rule " + name);
    } else {
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(name.c_str());
    }
    if (row.differs()) ImGui::PopFont();
    if (setting.kind != SettingKind::Switch) {
        // A name without room for the choices after it has them below.
        ImGui::SameLine(kNameWidth * em);
        const float reset = row.differs() ? 3.0F * em : 0.3F * em;
        const bool below = setting.kind == SettingKind::Option &&
                           ImGui::GetContentRegionAvail().x - reset < kLongestControl * em;
        if (below) ImGui::SetCursorPos({kIndentWidth * em, ImGui::GetCursorPosY() + height});
        ImGui::SetNextItemWidth(
            std::clamp(ImGui::GetContentRegionAvail().x - reset, em, kLongestControl * em));
        setting.kind == SettingKind::Option ? drawOption(list, row) : drawNumber(list, row);
        list.name("rule " + name);
    }
    ImGui::EndGroup();
    if (ImGui::IsItemHovered()) showTooltip(ruleHelp(row));
    if (row.differs()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - 2.9F * em);
        if (smallButton(context, "reset", list.place.prefix + "reset " + name,
                        "Reset to " + valueText(setting, row.usual)))
            list.set(setting, row.usual);
    }
    drawEffect(list, row);
    ImGui::PopID();
}

}  // namespace

std::optional<RunSpec> drawRuleSets(const PanelContext& context, const RunSpec& rules,
                                    const RuleListFields& place) {
    std::optional<RunSpec> chosen;
    const float reset = ImGui::CalcTextSize("Reset all").x + 2.0F * context.em;
    ImGui::SetNextItemWidth(std::clamp(ImGui::GetContentRegionAvail().x - reset, 4.0F * context.em,
                                       kControl * context.em));
    if (ImGui::BeginCombo("##set", rules.rules.c_str())) {
        for (const std::string_view name : paramSetNames()) {
            const std::string text(name);
            if (ImGui::Selectable(text.c_str(), text == rules.rules)) chosen = withSet(rules, text);
        }
        ImGui::EndCombo();
    }
    nameItem(context, place.prefix + "rules set",
             "The set of rules (--rules). Choosing another one resets single changes.");
    ImGui::SameLine();
    ImGui::BeginDisabled(differingCount(rules) == 0);
    if (textButton(context, "Reset all", place.prefix + "rules reset all",
                   "Reset all rules to the values of the set"))
        chosen = withSet(rules, rules.rules);
    ImGui::EndDisabled();
    return chosen;
}

std::optional<RunSpec> drawRuleList(const PanelContext& context, const RunSpec& rules,
                                    const RuleListFields& place) {
    RuleList list{context, rules, place};
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##rulefilter", "filter", place.filter.data(), place.filter.size());
    list.name("rules filter");
    tooltip("A name, a section or a word; differs: those that differ from the set");
    const auto groups = ruleGroups(rules, place.filter.data());
    if (groups.empty()) ImGui::TextDisabled("No rule matches.");
    const ImVec2 usual = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {usual.x, 0.4F * usual.y});
    for (const RuleGroup& group : groups) {
        ImGui::Spacing();
        ImGui::TextDisabled("%s", group.title.c_str());
        for (const RuleRow& row : group.rows) drawRow(list, row);
    }
    ImGui::PopStyleVar();
    return list.chosen;
}

void drawRules(const PanelContext& context) {
    const Session& session = context.session();
    const RunSpec rules = session.input().rules();
    const std::size_t count = differingCount(rules);
    const RuleListFields place{context.state<RuleFilter>().typed, ""};
    std::optional<RunSpec> chosen = drawRuleSets(context, rules, place);
    dimText(session.input().isRerunning() ? "Re-running ..."
            : count == 0                  ? "All have the values of the set."
                                          : counted(count, "differs", "differ") + " from the set.");
    if (auto single = drawRuleList(context, rules, place)) chosen = std::move(single);
    if (chosen) context.document().rerun(*chosen);
}

}  // namespace se::view
