// The two views of the layout Compare: their titles, and the second view.
#include <algorithm>

#include "compare/comparison.h"
#include "document/ui_state.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "panels/widgets/screen_painter.h"
#include "session/session.h"
#include "view_parts.h"

namespace se::view {

namespace {

void drawTitle(const PanelContext& context, const Rect& bar, const ComparedTitle& title) {
    if (bar.size.x < context.em) return;
    const std::string window = "##title" + title.letter;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    // Lower than the minimum height of windows, or it would cover the top of the view.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    const bool open =
        beginRegion(window.c_str(), bar, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    if (open) {
        ScreenPainter painter(context);
        drawTitleBar(painter, bar, title);
    }
    ImGui::End();
}

/// The second view before there is anything to compare.
void drawEmptyView(const PanelContext& context) {
    const Rect& view = context.rects.otherView;
    if (beginRegion("##otherEmpty", view)) {
        const Comparison* now = context.state<ComparePage>().now;
        const bool chosen = now != nullptr && now->chosen();
        const float width = std::min(view.size.x - 2.0F * context.em, 20.0F * context.em);
        // The button is visible in a low view as well.
        const float top = std::max(0.3F * context.em,
                                   std::min(0.35F * view.size.y, view.size.y - 5.8F * context.em));
        ImGui::SetCursorPos({0.5F * (view.size.x - width), top});
        ImGui::BeginGroup();
        if (chosen) {
            dimText(now->complaint().empty() ? "Opening and comparing ..." : now->complaint(),
                    width);
        } else {
            dimText("Choose in the panel Compare what to compare this run with, or", width);
            const std::string usual = usualOther(context.session().input().spec()).rules + " rules";
            if (textButton(context, fitted("Compare with the " + usual, width - 0.8F * context.em),
                           "compare usual"))
                context.run("run.compare");
        }
        ImGui::EndGroup();
    }
    ImGui::End();
}

/// The sentence of a mesh or a trace about the decision at the cursor, at the lower edge of its
/// view.
void drawStillSentence(const PanelContext& context) {
    const Compared* found = context.state<ComparePage>().result();
    const Comparison* now = context.state<ComparePage>().now;
    const bool trace = found != nullptr && found->trace && now != nullptr;
    const std::string text =
        trace ? found->trace->replay.sentence(now->tracePosition(*context.otherRun))
              : std::string("A finished mesh: no decisions of its own.");
    const Rect& view = context.rects.view;
    const float width = std::min(30.0F * context.em, view.size.x - 3.0F * context.em);
    drawPlate(context, {context.fonts.text, wrapped(text, width), "", context.palette.border,
                        context.palette.textDim});
}

/// A mesh from a file, or a trace: it can be viewed, but has no decisions.
void drawStill(const PanelContext& context) {
    if (beginView(context, "##otherStill")) {
        offerView(context);
        moveCameraByMouse(context);
        if (isClick(context, ImGuiMouseButton_Right)) context.state<SubjectMenu>().openBeside({});
        drawViewPicture(context);
        if (context.ui().picture.labels) drawLabels(context, {});
        drawStillSentence(context);
    }
    ImGui::End();
}

/// The panel context of the other run.
void drawOther(const PanelContext& context) {
    const OtherView& other = *context.other;
    PanelRects rects = context.rects;
    rects.view = rects.otherView;
    const PanelContext there{other.commands != nullptr ? *other.commands : context.commands,
                             context.palette,
                             context.fonts,
                             rects,
                             other.list,
                             other.counts,
                             context.em,
                             other.texture,
                             nullptr,
                             true,
                             &context.session()};
    if (other.commands == nullptr) return drawStill(there);
    drawView(there, "##otherView");
}

}  // namespace

void drawComparedViews(const PanelContext& context) {
    const PanelRects& rects = context.rects;
    context.where()["region other view"] = rects.otherView;
    const auto titles = comparedTitles(context.session(), context.state<ComparePage>().now);
    drawTitle(context, rects.title, titles[0]);
    drawTitle(context, rects.otherTitle, titles[1]);
    context.other == nullptr ? drawEmptyView(context) : drawOther(context);
}

}  // namespace se::view
