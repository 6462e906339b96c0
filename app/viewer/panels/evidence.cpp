#include <cmath>
#include <cstdio>

#include "panel.h"
#include "widgets.h"

namespace se::view {

namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string signedNumber(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%+.4g", value);
    return text;
}

std::string degrees(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1f\xC2\xB0", value);
    return text;
}

std::string points(const std::vector<Index>& list) {
    std::string text;
    for (const Index p : list) {
        text += (text.empty() ? "" : ", ") + (p == kNone ? std::string("none") : std::to_string(p));
    }
    return text;
}

/// The rows of one kind of evidence each.
class Rows {
  public:
    Rows(const PanelContext& context, const Event& event) : c_(context), event_(event) {}

    void operator()(const SeedEvidence& e) const {
        row("points", points({e.first, e.second}));
        row("distance", number(e.distance));
    }
    void operator()(const StrandEvidence& e) const {
        row("point", points({e.point}));
        row("why", e.isolated ? "its list is empty" : "every neighbor is DONE");
    }
    void operator()(const PivotEvidence& e) const {
        row("first, last", points({e.first, e.last}));
        row("ring", std::to_string(e.ringLength) + " points");
        row("free sector", degrees(e.sectorDegrees));
        bar(e.sectorDegrees, 180.0, 360.0);
    }
    void operator()(const SkipEvidence& e) const { row("pivot", points({e.pivot})); }
    void operator()(const InsertEvidence& e) const {
        row("third point", points({e.third}));
        row("rule", e.corner ? "7.2, corner" : "7.1, two boundary points");
        row("cross product",
            number(e.cross.x) + ", " + number(e.cross.y) + ", " + number(e.cross.z));
    }
    void operator()(const SortEvidence& e) const {
        row("point", points({e.point}));
        row("angle", degrees(e.degrees) + (e.secondHalf ? ", second half" : ", first half"));
        row("limit", degrees(e.endDegrees));
        row("cosine z\xC2\xB7v", number(e.cosine));
        if (e.rival != kNone) row("nearer point", points({e.rival}));
        bar(e.degrees, e.endDegrees, 360.0);
    }
    void operator()(const LimitEvidence& e) const {
        row(e.side == Side::Start ? "start, next" : "end, next", points({e.from, e.to}));
        row("turn", signedNumber(e.turn) + (e.turn > 0.0 ? ", concave" : ", convex"));
        row("angles", degrees(e.fromDegrees) + " \xE2\x86\x92 " + degrees(e.toDegrees));
    }
    void operator()(const DropEvidence& e) const {
        row("point", points({e.point}));
        row("side", e.side == Side::Start ? "start" : "end");
        row("angle", degrees(e.degrees));
    }
    void operator()(const ReciprocalEvidence& e) const {
        row("point e", points({e.point}));
        row("its ring", points({e.pred, e.succ}));
        row("angle of p at e", degrees(e.degrees));
        row("free sector of e", degrees(e.limitDegrees));
        bar(e.degrees, e.limitDegrees, 360.0);
    }
    void operator()(const HoleEvidence& e) const {
        if (e.point != kNone) row("point", points({e.point}));
        row("its side", signedNumber(e.side));
        row("side of p", signedNumber(e.pivotSide));
    }
    void operator()(const SphereEvidence& e) const {
        row("t, q, s", points({e.t, e.q, e.s}));
        if (e.verdict != Verdict::NoCircle) {
            row("radius r", number(e.radius));
            row("distance d", number(e.distance));
            row("d \xE2\x88\x92 r", signedNumber(e.distance - e.radius) +
                                        (e.distance < e.radius ? ", inside" : ", outside"));
            bar(e.distance, e.radius, 2.0 * e.radius);
        }
        row("gap t to s", degrees(e.gapDegrees) + ", limit 120\xC2\xB0");
        bar(e.gapDegrees, 120.0, 360.0);
    }
    void operator()(const TwoPointEvidence& e) const {
        row("angle", degrees(e.degrees) + ", limit 180\xC2\xB0");
        bar(e.degrees, 180.0, 360.0);
    }
    void operator()(const GuardEvidence& e) const {
        row(e.b == kNone ? "spoke to" : "triangle at",
            points(e.b == kNone ? std::vector{e.a} : std::vector{e.a, e.b}));
        row("dropped",
            e.dropped == kNone ? "nothing: the fan is refused" : std::to_string(e.dropped));
    }
    void operator()(const FillEvidence& e) const {
        row("ear", points({e.pivot, e.first, e.last}));
        row("hole", std::to_string(e.ringLength) + " points");
        row("least angle", degrees(e.leastDegrees));
        if (e.forced) row("forced", "no ear without a fault was left");
    }
    void operator()(const ReinsertEvidence& e) const { row("point", points({e.point})); }
    void operator()(const ReseatEvidence& e) const { row("point", points({e.point})); }
    void operator()(const FlipEvidence& e) const {
        row("edge before", points({e.u, e.v}));
        row("edge after", points({e.x, e.y}));
    }
    void operator()(const EmitEvidence& e) const {
        row("triangle", std::to_string(e.triangle));
        row("corners", points({e.corners.a, e.corners.b, e.corners.c}));
    }
    void operator()(const RingEvidence& e) const {
        row("point", points({e.point}));
        row("change", e.inserted ? "inserted" : "removed");
        row("status now", e.status == kDone ? "DONE" : "USED " + std::to_string(e.status));
    }
    void operator()(const SplitEvidence& e) const {
        row("at point", points({e.point}));
        row("stays active", std::to_string(e.activeLength) + " points");
        row("to the stack", std::to_string(e.stackedLength) + " points");
        row("stack depth", std::to_string(e.stackDepth));
    }
    void operator()(const JoinEvidence& e) const {
        row("at point", points({e.point}));
        row("found", e.depthFromTop == kNone
                         ? "in the active ring"
                         : "on the stack, #" + std::to_string(e.depthFromTop + 1));
        row("length", std::to_string(e.length) + " points");
    }
    void operator()(const CloseEvidence& e) const { row("points", points({e.a, e.b})); }
    void operator()(const AdvanceEvidence& e) const {
        row("next pivot", e.to == kNone ? "none" : std::to_string(e.to));
        if (e.popped) row("ring", "taken off the stack");
        row("without triangle",
            std::to_string(e.circuit) + (e.circuit == 1 ? " pivot" : " pivots"));
    }
    void operator()(const FreeEvidence& e) const {
        row("length", std::to_string(e.length) + " points");
        row("interior", std::to_string(e.interior));
    }
    void operator()(const ComponentEvidence& e) const {
        row("component", std::to_string(e.component));
        row("triangles", std::to_string(e.triangles));
    }
    void operator()(const AlertEvidence& e) const {
        row("alert", std::string(alertName(e.kind)));
        row("point", points({e.point}));
    }
    /// Kinds that have no rows of their own yet: the sentence under the view tells all.
    template <typename Other>
    void operator()(const Other&) const {}

  private:
    void row(const char* name, const std::string& value) const { valueRow(c_, name, value); }
    /// The value against its threshold, in the column of values.
    void bar(double value, double threshold, double largest) const {
        if (!std::isfinite(value) || !(largest > 0.0)) return;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TableNextColumn();
        ImGui::Dummy({0.0F, 0.1F * c_.em});
        gauge(c_, value, threshold, largest, verdictColor(c_, event_));
    }

    const PanelContext& c_;
    const Event& event_;
};

}  // namespace

void drawEvidence(const PanelContext& context, const Event& event) {
    if (!beginValues("##evidence", context)) return;
    if (const auto verdict = verdictOf(event)) {
        valueRow(context, "verdict", std::string(verdictText(*verdict)),
                 verdictColor(context, event));
    }
    std::visit(Rows(context, event), event.evidence);
    endValues();
}

}  // namespace se::view
