// The column of the layout Compare: the two runs, the counts, the first difference, the regions.
#include <algorithm>

#include "compare_parts.h"
#include "input/tab_order.h"
#include "jobs/questions.h"
#include "panel_state/compare_page.h"
#include "panels/widgets/widgets.h"
#include "session/session.h"
#include "spiraling_edge/replay/event_text.h"

namespace se::view {

bool compareButton(const PanelContext& context, const char* label, const char* name,
                   const std::string& help) {
    const bool pressed = ImGui::Button(label);
    context.where()[std::string("compare ") + name] = lastItem();
    tooltip(help);
    return pressed;
}

namespace {

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
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
    ImGui::PushFont(context.fonts.strong);
    const std::string title =
        std::string(name) + "  " +
        (side.line ? toString(side.line->event.address) : std::string("the run has ended")) +
        (side.line && !side.decides ? "  instead" : "");
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
    // The line is also shown below the views, once the cursor is there.
    if (side.line) tooltip(describe(side.line->event));
}

void drawFirstDifference(const PanelContext& context, const Compared& found) {
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
        page.ask = CompareAsk::FirstDifference;
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
            page.ask = CompareAsk::FirstHarmless;
    }
    ImGui::Spacing();
}

/// Answer of one run.
void drawAnswer(const PanelContext& context, const char* letter, const Color& color,
                const Session* run) {
    ImGui::PushFont(context.fonts.strong);
    ImGui::TextColored(toVec4(color), "%s", letter);
    ImGui::PopFont();
    ImGui::SameLine();
    if (run == nullptr) return dimText("a finished mesh, without decisions");
    const BackgroundQuery<WhyAnswer>& asked = run->questions().ledger();
    if (asked.answer() != nullptr) return wrappedText(asked.answer()->answer);
    dimText(asked.busy() ? "searching ..." : "no query");
}

std::optional<Address> causeIn(const Session* run) {
    const WhyAnswer* answer = run != nullptr ? run->questions().ledger().answer() : nullptr;
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
        page.goTo = ComparedAddresses{a, b};
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
    if (ImGui::Selectable(text.c_str(), shown)) page.show = number;
    if (ImGui::IsItemVisible())
        context.where()["compare region " + std::to_string(number + 1)] = lastItem();
    tooltip("Show it in the finished meshes.\nFirst made at " +
            addressOrDash(firstMade(found.runs.a, region.inA)) + " in A, " +
            addressOrDash(firstMade(found.runs.b, region.inB)) + " in B");
    if (shown) {
        const auto a = firstMade(found.runs.a, region.inA);
        const auto b = firstMade(found.runs.b, region.inB);
        if ((a || b) && ImGui::SmallButton("Where it began")) page.goTo = ComparedAddresses{a, b};
        tooltip("To its first triangle in A (" + addressOrDash(a) + ") and in B (" +
                addressOrDash(b) + ")");
    }
    ImGui::PopID();
}

void drawRegions(const PanelContext& context, const Compared& found) {
    ComparePage& page = context.state<ComparePage>();
    const std::size_t count = found.meshes.regions.size();
    heading(context, "Regions of difference", grouped(count));
    if (count == 0) return dimText("None: the meshes are the same.");
    if (compareButton(context, "Previous", "previous",
                      "Show the previous region (" + context.key("step.region.previous") + ")"))
        page.ask = CompareAsk::PreviousRegion;
    ImGui::SameLine();
    if (compareButton(context, "Next", "next",
                      "Show the next region (" + context.key("step.region.next") + ")"))
        page.ask = CompareAsk::NextRegion;
    constexpr std::size_t kMaxRows = 200;
    for (std::size_t i = 0; i < std::min(count, kMaxRows); ++i) drawRegion(context, found, i);
    if (count > kMaxRows) dimText("... smaller ones by Next and Previous.");
}

void drawWorking(const PanelContext& context) {
    ImGui::ProgressBar(static_cast<float>(context.state<ComparePage>().now->share()), {-1.0F, 0.0F},
                       "comparing");
    if (compareButton(context, "Cancel", "cancel", "End the comparison"))
        context.state<ComparePage>().ask = CompareAsk::Stop;
}

/// A and B by name.
void drawNames(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    const InputSpec& run = context.session().input().spec();
    const CompareWith& with = page.now->with();
    const auto name = [&](const char* letter, const std::string& text, const Color& color) {
        ImGui::PushFont(context.fonts.strong);
        ImGui::TextColored(toVec4(color), "%s", letter);
        ImGui::PopFont();
        ImGui::SameLine();
        wrappedText(text);
    };
    name("A", runTitle(run), context.palette.used);
    name("B",
         with.kind == CompareWith::Kind::Mesh ? meshTitle(with) : differenceText(run, with.run),
         context.palette.last);
    if (compareButton(context, "Other...", "other", "Choose another B")) {
        page.choosing = true;
        if (with.kind == CompareWith::Kind::Run)
            page.form.takeOther(with.run, context.session().model());
    }
    if (with.kind == CompareWith::Kind::Run) {
        ImGui::SameLine();
        if (compareButton(context, "Swap", "swap", "Show B in all panels"))
            page.ask = CompareAsk::Swap;
    }
    ImGui::SameLine();
    if (compareButton(context, "Stop", "stop", "End the comparison")) page.ask = CompareAsk::Stop;
    ImGui::Spacing();
}

void drawContent(const PanelContext& context) {
    ComparePage& page = context.state<ComparePage>();
    if (!context.session().ready() || page.now == nullptr)
        return ImGui::TextDisabled("Nothing is open.");
    heading(context, "Compare");
    if (!page.now->chosen() || page.choosing) return drawCompareForm(context);
    drawNames(context);
    if (!page.now->complaint().empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, toVec4(context.palette.rejected));
        wrappedText("! " + page.now->complaint());
        ImGui::PopStyleColor();
        return;
    }
    if (page.now->working()) return drawWorking(context);
    const Compared* found = page.result();
    if (found == nullptr) return;
    drawWhy(context);
    drawCounts(context, *found);
    drawFirstDifference(context, *found);
    drawRegions(context, *found);
}

}  // namespace

void drawCompareColumn(const PanelContext& context) {
    if (beginRegion("##compareColumn", context.rects.left)) {
        ImGui::PushFont(context.rects.left.size.x < 18.0F * context.em ? context.fonts.small
                                                                       : context.fonts.text);
        if (ImGui::BeginChild("##content", {0, 0}, false)) {
            if (context.state<KeyWalk>().offer(KeyStop::Content)) takeKeyboardHere();
            drawContent(context);
        }
        ImGui::EndChild();
        ImGui::PopFont();
    }
    ImGui::End();
}

}  // namespace se::view
