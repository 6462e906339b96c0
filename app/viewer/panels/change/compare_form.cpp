// The form of the layout Compare: the choice of the other run.
#include "compare_parts.h"
#include "panel_state/compare_page.h"
#include "panel_state/what_if_offers.h"
#include "panels/widgets/prepare_fields.h"
#include "panels/widgets/widgets.h"
#include "rows/rule_rows.h"
#include "rule_list.h"
#include "run/strings.h"
#include "session/session.h"

namespace se::view {

namespace {

/// A part of the form that can be opened, and a note after its name.
bool beginPart(const PanelContext& context, const char* name, const std::string& note,
               const std::string& help) {
    const std::string title = std::string(name) + ": " + note + "###" + name;
    const bool open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen);
    context.where()[std::string("compare part ") + name] = lastItem();
    tooltip(help);
    return open;
}

void drawRuleFields(const PanelContext& context, CompareForm& form) {
    const RuleListFields place{form.ruleFilter, "compare "};
    ImGui::PushID("rules");
    if (const auto set = drawRuleSets(context, form.rules, place)) form.rules = *set;
    const std::size_t differing = differingCount(form.rules);
    const std::string note =
        differing == 0 ? "values of the set" : counted(differing, "differs", "differ");
    if (beginPart(context, "Rules", note, "Every rule as a switch, a choice or a number")) {
        if (const auto chosen = drawRuleList(context, form.rules, place)) form.rules = *chosen;
        ImGui::Spacing();
    }
    ImGui::PopID();
}

/// Differences in the preparation of the other input.
std::string prepareNote(const PanelContext& context, const CompareForm& form) {
    const InputSpec& here = context.session().input().spec();
    const Result<InputSpec> there = form.prepare.spec(here);
    if (!there) return "a field is wrong";
    const std::string text = differenceText(here, there.value());
    return text == "the same" ? "as in A" : text;
}

void drawPrepared(const PanelContext& context, CompareForm& form) {
    if (!beginPart(context, "Input", prepareNote(context, form),
                   "Neighbor lists, normals, walls and rims of B, as in File > Prepare"))
        return;
    ImGui::PushID("input");
    drawPrepareFields(context, form.prepare, "compare prepare ");
    ImGui::Spacing();
    ImGui::PopID();
}

void drawWhatIfs(const PanelContext& context, CompareForm& form) {
    const auto& all = form.rules.whatIf;
    const std::string note = all.empty() ? "none" : counted(all.size(), "change", "changes");
    if (!beginPart(context, "What if", note, "Decisions of the rules that B overrides")) return;
    ImGui::PushID("what if");
    for (std::size_t i = 0; i < all.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool gone = ImGui::SmallButton("x");
        context.where()["compare what if " + std::to_string(i + 1)] = lastItem();
        tooltip("Remove from B");
        ImGui::SameLine();
        ImGui::TextUnformatted(fitted(lineOf(all[i]), ImGui::GetContentRegionAvail().x).c_str());
        tooltip(describe(all[i]));
        ImGui::PopID();
        if (gone) {
            form.rules = withoutWhatIf(form.rules, i);
            break;
        }
    }
    ImGui::SetNextItemWidth(-1.0F);
    if (textField("##line", "137.sphere keep 812, Enter", form.whatIf,
                  ImGuiInputTextFlags_EnterReturnsTrue))
        form.addWhatIf();
    context.where()["compare what if line"] = lastItem();
    tooltip("Another one, in the syntax of --what-if; Enter adds it.");
    ImGui::Spacing();
    ImGui::PopID();
}

void begin(const PanelContext& context, const Result<InputSpec>& spec) {
    ComparePage& page = context.state<ComparePage>();
    page.form.complaint = spec ? std::string{} : spec.error().message;
    if (spec) page.begin = CompareWith::otherRun(spec.value());
}

/// Choices that need one click only.
void drawShortcuts(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    const InputSpec& here = context.session().input().spec();
    dimText("Or one of these:");
    if (compareButton(context, "Mesh from file...", "mesh",
                      "A mesh that another program made from the same points"))
        context.run("run.compare.mesh");
    if (!here.whatIf.empty() &&
        compareButton(context, "Without what-ifs", "true run",
                      "This run without its what-ifs, to see what they changed"))
        page.begin = CompareWith::otherRun(trueRunOf(here));
    if (page.before && compareButton(context, "Before the last change", "before",
                                     "This run as it was: " + differenceText(here, *page.before)))
        page.begin = CompareWith::otherRun(*page.before);
    if (page.choosing && compareButton(context, "Back", "back", "Keep the current comparison"))
        page.choosing = false;
}

}  // namespace

void drawCompareForm(const PanelContext& context) {
    CompareForm& form = context.state<ComparePage>().form;
    const InputSpec& here = context.session().input().spec();
    dimText("B, to compare with the open run:");
    drawRuleFields(context, form);
    drawPrepared(context, form);
    drawWhatIfs(context, form);
    ImGui::Spacing();
    const Result<InputSpec> spec = form.spec(here);
    const std::string difference = spec ? differenceText(here, spec.value()) : "";
    if (compareButton(context, "Compare", "begin", "Run it in the background and compare"))
        begin(context, spec);
    ImGui::SameLine();
    dimText(difference == "the same" ? "B is the same as A" : difference);
    if (!form.complaint.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
        wrappedText("! " + form.complaint);
        ImGui::PopStyleColor();
    }
    ImGui::Spacing();
    drawShortcuts(context);
}

}  // namespace se::view
