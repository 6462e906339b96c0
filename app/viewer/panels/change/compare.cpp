// The panel Rules, and the column of the layout Compare: the form for the other run; then the two
// runs, the counts, the first difference, the regions.
#include <algorithm>

#include "compare/compared_runs.h"
#include "compare/comparison.h"
#include "document/document.h"
#include "input/key_routing.h"
#include "jobs/questions.h"
#include "lesson/lesson_walk.h"
#include "panel_state/what_if_offers.h"
#include "panels/widgets/widgets.h"
#include "rows/rule_rows.h"
#include "session/session.h"
#include "spiraling_edge/run/event_text.h"

namespace se::view {

// All rules as switches: a change re-runs the input at once.

namespace {

struct RuleListFields {
    std::array<char, 64>& filter;
    std::string prefix;  ///< Prefix of the item names for test scripts: "", "compare ".
};

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

/// A field for a number, which takes effect on Enter, or when the field loses the focus.
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

/// The effect of a rule as one sentence, below its name.
void drawEffect(const RuleList& list, const RuleRow& row) {
    ImGui::PushFont(list.context.fonts.small);
    ImGui::Indent(kIndentWidth * list.context.em);
    dimText(ruleSentence(row));
    list.name("effect " + std::string(row.setting->name));
    ImGui::Unindent(kIndentWidth * list.context.em);
    ImGui::PopFont();
}

/// A rule, with a dot before a value that differs from the set, and a button to reset it.
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

/// Choice of the rule set; empty if nothing changed in this frame.
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

/// The filter, and all rules that match it.
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

}  // namespace

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

namespace {

/// A button that test scripts find as "compare NAME".
bool compareButton(const PanelContext& context, const char* label, const std::string& name,
                   const std::string& help) {
    return textButton(context, label, "compare " + name, help);
}

// ---- The form: the choice of the other run ------------------------------------------------------

/// A part of the form that can be opened, and a note after its name.
bool beginPart(const PanelContext& context, const char* name, const std::string& note,
               const std::string& help) {
    const std::string title = std::string(name) + ": " + note + "###" + name;
    const bool open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen);
    nameItem(context, std::string("compare part ") + name, help);
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
    const RunSpec& here = context.session().input().spec();
    const Result<RunSpec> there = form.prepare.spec(here);
    if (!there) return "a field is wrong";
    const std::string text = differenceText(here, there.value());
    return text == kNoDifference ? "as in A" : text;
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
    std::vector<WhatIf>& all = form.rules.whatIf;
    const std::string note = all.empty() ? "none" : counted(all.size(), "change", "changes");
    if (!beginPart(context, "What if", note, "Decisions of the rules that B overrides")) return;
    ImGui::PushID("what if");
    drawRemovable(all, [&](const WhatIf& each, std::size_t i) {
        const bool gone =
            smallButton(context, "x", "compare what if " + std::to_string(i + 1), "Remove from B");
        ImGui::SameLine();
        ImGui::TextUnformatted(fittedName(lineOf(each), ImGui::GetContentRegionAvail().x).c_str());
        tooltip(describe(each));
        return gone;
    });
    ImGui::SetNextItemWidth(-1.0F);
    if (textField("##line", "137.sphere keep 812, Enter", form.whatIf,
                  ImGuiInputTextFlags_EnterReturnsTrue))
        form.addWhatIf();
    nameItem(context, "compare what if line",
             "Another one, in the syntax of --what-if; Enter adds it.");
    ImGui::Spacing();
    ImGui::PopID();
}

/// Choices that need one click only.
void drawShortcuts(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    const RunSpec& here = context.session().input().spec();
    dimText("Or one of these:");
    if (compareButton(context, "Mesh or trace...", "mesh",
                      "A mesh, or a trace (.setrace), that another program made from the same "
                      "points"))
        context.run("run.compare.mesh");
    if (!here.whatIf.empty() &&
        compareButton(context, "Without what-ifs", "true run",
                      "This run without its what-ifs, to see what they changed"))
        context.commands.compare.begin(CompareWith::otherRun(trueRunOf(here)));
    if (page.before && compareButton(context, "Before the last change", "before",
                                     "This run as it was: " + differenceText(here, *page.before)))
        context.commands.compare.begin(CompareWith::otherRun(*page.before));
    if (page.choosing && compareButton(context, "Back", "back", "Keep the current comparison"))
        page.choosing = false;
}

void drawCompareForm(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    CompareForm& form = page.form;
    const RunSpec& here = context.session().input().spec();
    complain(context, page.now->refusal());
    dimText("B, to compare with the open run:");
    drawRuleFields(context, form);
    drawPrepared(context, form);
    drawWhatIfs(context, form);
    ImGui::Spacing();
    const Result<RunSpec> spec = form.spec(here);
    const std::string difference = spec ? differenceText(here, spec.value()) : "";
    if (compareButton(context, "Compare", "begin", "Run it in the background and compare")) {
        form.complaint = spec ? std::string{} : spec.error().message;
        if (spec) context.commands.compare.begin(CompareWith::otherRun(spec.value()));
    }
    ImGui::SameLine();
    dimText(difference == kNoDifference ? "B is the same as A" : difference);
    complain(context, form.complaint);
    ImGui::Spacing();
    drawShortcuts(context);
}

// ---- The comparison -----------------------------------------------------------------------------

/// A color, its meaning, and the number of its triangles.
void countRow(const PanelContext& context, const Color& color, const char* text,
              std::size_t count) {
    const float em = context.em;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.1F * line},
                                              {at.x + 0.8F * em, at.y + 0.9F * line}, toU32(color),
                                              0.15F * em);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.3F * em);
    ImGui::TextUnformatted(text);
    const std::string number = grouped(count);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(number.c_str()).x);
    ImGui::TextUnformatted(number.c_str());
}

void drawCounts(const PanelContext& context, const Compared& found) {
    const Palette& colors = context.palette;
    heading(context, "Triangles");
    countRow(context, colors.mesh, "in both", found.meshes.both);
    countRow(context, colors.used, "only in A", found.meshes.onlyA);
    countRow(context, colors.last, "only in B", found.meshes.onlyB);
    if (found.meshes.reversed > 0)
        countRow(context, colors.rejected, "reversed", found.meshes.reversed);
    if (!found.unmatchedVertices.empty())
        dimText(grouped(found.unmatchedVertices.size()) + " vertices of B match no point.");
    ImGui::Spacing();
}

/// The deciding line of one run.
void drawSide(const PanelContext& context, const char* name, const DifferenceSide& side,
              const Color& color) {
    const std::string title =
        std::string(name) + "  " +
        (side.line ? toString(side.line->event.address) : std::string("the run has ended")) +
        (side.line && !side.decides ? "  instead" : "");
    textIn(context.fonts.strong, title, color);
    // The line is also shown below the views, once the cursor is there.
    if (side.line) tooltip(describe(side.line->event));
}

/// A sentence of a trace's difference; with an address also the way there.
void drawTraceReason(const PanelContext& context, const teach::TraceReason& reason,
                     std::size_t number) {
    const std::string label = withBreaks(teach::reasonText(reason));
    if (!reason.address) return ImGui::TextUnformatted(label.c_str());
    ImGui::PushID(static_cast<int>(number));
    if (selectable(context, label, false, "trace reason " + std::to_string(number + 1),
                   "Go to this decision of ours"))
        context.commands.compare.goTo({reason.address, std::nullopt});
    ImGui::PopID();
}

/// The first difference from a trace: the sentences of spiraling-edge diff.
void drawTraceDifference(const PanelContext& context, const Compared& found) {
    const ComparedTrace& traced = *found.trace;
    const auto& difference = traced.comparison.difference;
    heading(context, "First difference", "after " + grouped(traced.comparison.alike) + " pivots");
    if (!difference) {
        return dimText(found.meshes.onlyA == 0
                           ? "None: the trace is that of the run, to its end."
                           : "None: the trace is that of the run, which goes on where it ends.");
    }
    if (compareButton(
            context, "First difference", "first",
            "To our first decision that accounts for it (" + context.key("step.difference") + ")"))
        context.run("step.difference");
    const bool early = difference->runPivots > 0;
    wrappedText(early ? teach::earlyEndText(traced.comparison) : teach::headText(*difference));
    for (const std::string& each : difference->both) wrappedText(each);
    for (std::size_t i = 0; i < difference->reasons.size(); ++i)
        drawTraceReason(context, difference->reasons[i], i);
    wrappedText(traced.guess);
    ImGui::Spacing();
}

void drawFirstDifference(const PanelContext& context, const Compared& found) {
    if (found.trace) return drawTraceDifference(context, found);
    ComparePage& page = context.state<ComparePage>();
    const bool mesh = page.now->with().kind == CompareWith::Kind::Mesh;
    heading(context, "First difference",
            mesh ? "" : "after " + grouped(found.runs.commonPivots) + " pivots");
    if (!mesh && !found.runs.first) {
        dimText("None: the runs are the same from the first pivot to the last.");
    } else if (compareButton(context, "First difference", "first",
                             mesh ? "To the first triangle of the run that the mesh lacks"
                                  : "To the first decision in which the runs differ (" +
                                        context.key("step.difference") + ")")) {
        context.run("step.difference");
    }
    if (found.runs.first) {
        wrappedText(found.runs.first->words);
        drawSide(context, "A", found.runs.first->a, context.palette.used);
        drawSide(context, "B", found.runs.first->b, context.palette.last);
    }
    if (found.runs.harmless) {
        ImGui::Spacing();
        const bool one = found.runs.harmlessPivots == 1;
        dimText("At " + grouped(found.runs.harmlessPivots) +
                (one ? " earlier pivot" : " earlier pivots") +
                " a decision differed without a consequence.");
        if (compareButton(context, one ? "Go there" : "The first of them", "harmless",
                          found.runs.harmless->words))
            context.commands.compare.toFirstHarmless();
    }
    ImGui::Spacing();
}

/// "A" or "B", before the text of the run.
void drawLetter(const PanelContext& context, const char* letter, const Color& color) {
    textIn(context.fonts.strong, letter, color);
    ImGui::SameLine();
}

/// Answer of one run.
void drawAnswer(const PanelContext& context, const char* letter, const Color& color,
                const Session* run) {
    drawLetter(context, letter, color);
    if (run == nullptr) {
        const Compared* found = context.state<ComparePage>().result();
        return dimText(found != nullptr && found->trace ? "no decisions in this trace"
                                                        : "a finished mesh, without decisions");
    }
    const BackgroundQuery<Ledger>& asked = run->questions().ledger();
    if (const Ledger* answer = run->questions().why()) return wrappedText(answer->answer);
    dimText(asked.busy() ? "searching ..." : "no query");
}

std::optional<Address> causeIn(const Session* run) {
    const Ledger* answer = run != nullptr ? run->questions().why() : nullptr;
    if (answer == nullptr) return std::nullopt;
    return answer->lines[answer->cause].event.address;
}

/// Answers of both runs to the same query.
void drawWhy(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    if (!page.why) return;
    const Session& run = context.session();
    const Session* other = page.now->other();
    heading(context, "Why", selectionText(*page.why));
    drawAnswer(context, "A", context.palette.used, &run);
    drawAnswer(context, "B", context.palette.last, other);
    const std::optional<Address> a = causeIn(&run);
    const std::optional<Address> b = causeIn(other);
    if (a && compareButton(
                 context, "Go there", "cause",
                 other == nullptr ? "To the decisive line in A" : "Both to their decisive lines"))
        context.commands.compare.goTo({a, b});
    if (a) ImGui::SameLine();
    if (compareButton(context, "Close", "why close", "Close the answers")) page.why.reset();
    ImGui::Spacing();
}

std::string addressOrDash(const std::optional<Address>& address) {
    return address ? toString(*address) : "-";
}

void drawRegion(const PanelContext& context, const Compared& found, std::size_t number) {
    ComparePage& page = context.state<ComparePage>();
    const DifferenceRegion& region = found.meshes.regions[number];
    const std::string text = std::to_string(number + 1) + ".  A " + grouped(region.inA.size()) +
                             "  B " + grouped(region.inB.size());
    ImGui::PushID(static_cast<int>(number));
    const bool shown = page.region == number;
    if (ImGui::Selectable(text.c_str(), shown)) context.commands.compare.showRegion(number);
    if (ImGui::IsItemVisible()) nameItem(context, "compare region " + std::to_string(number + 1));
    const auto a = firstMade(found.runs.a, region.inA);
    const auto b = firstMade(found.runs.b, region.inB);
    tooltip("Show it in the finished meshes.\nFirst made at " + addressOrDash(a) + " in A, " +
            addressOrDash(b) + " in B");
    if (shown) {
        if ((a || b) && ImGui::SmallButton("Where it began")) context.commands.compare.goTo({a, b});
        tooltip("To its first triangle in A (" + addressOrDash(a) + ") and in B (" +
                addressOrDash(b) + ")");
    }
    ImGui::PopID();
}

void drawRegions(const PanelContext& context, const Compared& found) {
    const std::size_t count = found.meshes.regions.size();
    heading(context, "Regions of difference", grouped(count));
    if (count == 0) return dimText("None: the meshes are the same.");
    if (compareButton(context, "Previous", "previous",
                      "Show the previous region (" + context.key("step.region.previous") + ")"))
        context.run("step.region.previous");
    ImGui::SameLine();
    if (compareButton(context, "Next", "next",
                      "Show the next region (" + context.key("step.region.next") + ")"))
        context.run("step.region.next");
    constexpr std::size_t kMaxRows = 200;
    for (std::size_t i = 0; i < std::min(count, kMaxRows); ++i) drawRegion(context, found, i);
    if (count > kMaxRows) dimText("... smaller ones by Next and Previous.");
}

void drawWorking(const PanelContext& context) {
    ImGui::ProgressBar(static_cast<float>(context.state<ComparePage>().now->share()), {-1.0F, 0.0F},
                       "comparing");
    if (compareButton(context, "Cancel", "cancel", "End the comparison"))
        context.commands.compare.stop();
}

/// A and B by name.
void drawNames(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    const RunSpec& run = context.session().input().spec();
    const CompareWith& with = page.now->with();
    drawLetter(context, "A", context.palette.used);
    wrappedText(runTitle(run));
    drawLetter(context, "B", context.palette.last);
    wrappedText(with.isFile() ? fileTitle(with) : differenceText(run, with.run));
    if (compareButton(context, "Other...", "other", "Choose another B")) {
        page.choosing = true;
        if (!with.isFile()) page.form.takeOther(with.run, context.session().model());
    }
    if (!with.isFile()) {
        ImGui::SameLine();
        if (compareButton(context, "Swap", "swap", "Show B in all panels"))
            context.commands.compare.swap();
    }
    ImGui::SameLine();
    if (compareButton(context, "Stop", "stop", "End the comparison"))
        context.commands.compare.stop();
    ImGui::Spacing();
}

}  // namespace

void drawCompare(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    if (page.now == nullptr) return ImGui::TextDisabled("Nothing is open.");
    if (!page.now->chosen() || page.choosing) return drawCompareForm(context);
    drawNames(context);
    if (!page.now->complaint().empty())
        return wrappedText("! " + page.now->complaint(), context.palette.rejected);
    complain(context, page.now->refusal());
    const Compared* found = page.result();
    // A trace that has changed is compared again beside the result before.
    if (found == nullptr && page.now->working()) return drawWorking(context);
    if (found == nullptr) return;
    drawWhy(context);
    drawCounts(context, *found);
    drawFirstDifference(context, *found);
    drawRegions(context, *found);
}

}  // namespace se::view
