// A list of decisions, two lines of text each: what was decided, and the numbers it compared. Only
// the rows in sight are drawn, so that a list of any length costs the same; all rows are of one
// height, which lets the list scroll to the row of the cursor without a search.
#include "decision_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "document/alert_actions.h"
#include "paint/shapes.h"
#include "panel_state/side_panels.h"
#include "rows/evidence_rows.h"
#include "run/strings.h"
#include "screen_painter.h"
#include "session/playback.h"
#include "session/session.h"
#include "session/view_position.h"

namespace se::view {

namespace {

/// Between two rows, in em.
constexpr float kRowGap = 0.25F;
/// Frames that count as a move of the cursor.
constexpr int kSettlingFrames = 4;

/// Outcome of the subject, by shape and color.
struct RoleLook {
    Shape shape;
    float size;
    Color Palette::*color;
};

/// By LineRole.
constexpr std::array<RoleLook, 6> kRoleLooks = {{
    {Shape::Dot, 0.3F, &Palette::textDim},
    {Shape::Disc, 0.56F, &Palette::used},
    {Shape::Cross, 0.6F, &Palette::rejected},
    {Shape::Disc, 0.4F, &Palette::used},
    {Shape::Diamond, 0.74F, &Palette::test},
    {Shape::OpenDiamond, 0.74F, &Palette::rejected},
}};
static_assert(static_cast<std::size_t>(LineRole::Undone) + 1 == kRoleLooks.size());

/// One row, two lines of text high.
class RowDrawer {
  public:
    RowDrawer(const PanelContext& context, const DecisionRows& rows, const LinePosition& place)
        : context_(context), rows_(rows), place_(place) {}

    float pitch() const { return height() + kRowGap * context_.em; }

    /// True if it was chosen.
    bool draw(std::size_t i) {
        const LedgerLine& line = rows_.lines[i];
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float room = ImGui::GetContentRegionAvail().x;
        const bool here = place_.here == i;
        ImGui::PushID(static_cast<int>(i));
        const bool chosen = ImGui::Selectable("##line", here, 0, {0.0F, height()});
        const bool hovered = ImGui::IsItemHovered();
        if (ImGui::IsItemVisible()) nameItem(context_, "line " + toString(line.event.address));
        const Index tested = testedPoint(line.event);
        const Index point = tested != kNone ? tested : line.pivot;
        if (hovered) context_.state<Navigation>().pointedAt = point;
        if (hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right))
            context_.state<SubjectMenu>().open(Selection::ofPoint(point));
        const RowNote note = rows_.note ? rows_.note(i) : RowNote{};
        tooltip(lineText(line) + (note.tooltip.empty() ? "" : "\n" + note.tooltip));
        ImGui::PopID();
        drawTop(line, at, room, i == rows_.cause, here);
        drawBelow(line, {at.x, at.y + ImGui::GetTextLineHeight()}, room, note.below);
        drawCursorLine({i, 1}, at, room);
        return chosen;
    }

    /// Repeats of the row above. True if they are to be unfolded.
    bool drawFold(const LineFold& fold) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushID(static_cast<int>(fold.first));
        const bool chosen = ImGui::Selectable("##fold", false, 0, {0.0F, height()});
        if (ImGui::IsItemVisible())
            nameItem(context_, "fold " + toString(rows_.lines[fold.first].event.address),
                     "Click to list them");
        ImGui::PopID();
        ScreenPainter p(context_);
        p.text({at.x + left(), at.y}, "and " + grouped(fold.count) + " more like it",
               p.ink(&Palette::textDim), {em()});
        drawCursorLine(fold, at, ImGui::GetContentRegionAvail().x);
        return chosen;
    }

  private:
    float em() const { return context_.em; }
    float height() const { return ImGui::GetTextLineHeight() + 1.15F * smallSize(); }
    float smallSize() const { return 0.86F * em(); }
    float left() const { return 1.5F * em(); }

    /// Mark, address, role; the section at the right end.
    void drawTop(const LedgerLine& line, ImVec2 at, float room, bool cause, bool here) const {
        ScreenPainter p(context_);
        const RoleLook& look = kRoleLooks[static_cast<std::size_t>(line.role)];
        const float middle = at.y + 0.5F * ImGui::GetTextLineHeight();
        drawShape(p, {at.x + 0.85F * em(), middle}, look.size * em(), look.shape,
                  p.ink(look.color));
        if (here)
            drawShape(p, {at.x + 0.2F * em(), middle}, 0.6F * em(), Shape::Forward,
                      p.ink(&Palette::pivot));
        const std::string section = sectionOf(line.event);
        const float right = at.x + room - 0.2F * em() - textWidth(section);
        p.text({right, at.y}, section, p.ink(&Palette::textDim), {em()});
        float x = at.x + left();
        const Type type{em(), cause ? Typeface::Strong : Typeface::Text};
        const auto put = [&](const std::string& text, Color Palette::*color) {
            const float width = p.textSize(text, type).x;
            if (x + width > right - 0.3F * em()) return false;
            p.text({x, at.y}, text, p.ink(color), type);
            x += width + 0.6F * em();
            return true;
        };
        put(toString(line.event.address), &Palette::text);
        // The mark shows the role as well.
        if (cause && !put("\xE2\x97\x80 cause", &Palette::text))
            put("\xE2\x97\x80", &Palette::text);
        if (line.role != LineRole::Fact) put(std::string(roleName(line.role)), look.color);
    }

    /// The pivot, and the numbers; the margin, which rows are compared by, at the right
    /// end.
    void drawBelow(const LedgerLine& line, ImVec2 at, float room, const std::string& note) const {
        ScreenPainter p(context_);
        const Ink ink = p.ink(&Palette::textDim);
        ImGui::PushFont(context_.fonts.small);
        const float size = ImGui::GetFontSize();
        float rest = room - left() - 0.2F * em();
        if (line.reading) {
            const std::string margin = marginText(line.reading->margin);
            p.text({at.x + room - 0.2F * em(), at.y}, margin, ink,
                   {size, Typeface::Small, Align::Right});
            rest -= textWidth(margin) + 0.6F * em();
        }
        const std::string text = note.empty() ? numbersOf(line, rest) : note;
        p.text({at.x + left(), at.y}, fitted(text, rest), ink, {size, Typeface::Small});
        ImGui::PopFont();
    }

    /// The numbers of a decision, with the name of the quantity if it fits.
    static std::string numbersOf(const LedgerLine& line, float room) {
        if (!line.reading) return shortSentence(line.event);
        const std::string at =
            line.pivot != kNone ? "at " + std::to_string(line.pivot) + ": " : std::string{};
        const std::string full = at + comparisonText(*line.reading, true);
        return textWidth(full) <= room ? full : at + comparisonText(*line.reading, false);
    }

    /// Position of the cursor between two rows.
    void drawCursorLine(const LineFold& row, ImVec2 at, float room) const {
        const bool here = place_.before - row.first < row.count;
        if (!rows_.inOrder || place_.here || !here) return;
        const float y = std::round(at.y - 0.12F * em());
        ScreenPainter p(context_);
        p.line({at.x, y}, {at.x + room, y}, p.ink(&Palette::pivot).line(p.px(0.1F)));
    }

    const PanelContext& context_;
    const DecisionRows& rows_;
    LinePosition place_;
};

/// Without an order only the line at the cursor has a mark.
LinePosition positionOfCursor(const DecisionRows& rows, const Session& session) {
    if (rows.inOrder) return positionAmong(rows.lines, session);
    LinePosition place;
    for (std::size_t i = 0; i < rows.lines.size(); ++i) {
        if (session.event() != nullptr && rows.lines[i].event.address == session.address())
            place.here = i;
    }
    return place;
}

/// The rows of a list: one for each line, but for repeats that are folded. Repeats around the
/// cursor are not. Takes memory for what is folded alone: lists may be long.
class ShownRows {
  public:
    ShownRows(const DecisionRows& rows, const LinePosition& place) : size_(rows.lines.size()) {
        for (const LineFold& fold : rows.folds) {
            const bool here = place.here && *place.here - fold.first < fold.count;
            if (here || isAmong(fold.first, rows.list.unfolded)) continue;
            folded_.push_back({fold, fold.first + size_ - rows.lines.size()});
            size_ -= fold.count - 1;
        }
    }
    std::size_t size() const { return size_; }
    /// The lines of a row.
    LineFold operator[](std::size_t row) const {
        const Folded* last = lastWhere([row](const Folded& each) { return each.row <= row; });
        if (last == nullptr) return {row, 1};
        if (last->row == row) return last->lines;
        return {last->after() + row - last->row - 1, 1};
    }
    /// The number of the row that shows a line.
    std::size_t rowOf(std::size_t line) const {
        const Folded* last =
            lastWhere([line](const Folded& each) { return each.lines.first <= line; });
        if (last == nullptr) return line;
        return line < last->after() ? last->row : last->row + 1 + line - last->after();
    }

  private:
    struct Folded {
        LineFold lines;
        std::size_t row;

        std::size_t after() const { return lines.first + lines.count; }
    };

    /// The last one for which this holds, as for all before it; null: none.
    template <typename Holds>
    const Folded* lastWhere(const Holds& holds) const {
        const auto end = std::partition_point(folded_.begin(), folded_.end(), holds);
        return end == folded_.begin() ? nullptr : &*std::prev(end);
    }

    std::vector<Folded> folded_;
    std::size_t size_;
};

/// Scrolls from `scroll` to a row at `y`, unless that is in sight then.
void scrollTo(float y, float pitch, float scroll) {
    const float height = ImGui::GetWindowHeight();
    const bool inSight = y >= scroll && y + pitch <= scroll + height;
    ImGui::SetScrollY(inSight ? scroll : std::max(0.0F, y - 0.4F * height));
}

/// Scrolls to the line that the cursor moves to, and to the decisive one of a new answer. To be
/// called before the first row.
void follow(const PanelContext& context, const DecisionRows& rows, const LinePosition& place,
            const ShownRows& shown, float pitch) {
    const float top = ImGui::GetCursorPosY();
    const Session& session = context.session();
    const bool moved =
        rows.list.watch.moved(session.generation(), session.record().pivot, session.cursor());
    const void* answer = rows.lines.data();
    if (std::exchange(rows.list.answer, answer) != answer) {
        rows.list.settling = kSettlingFrames;
        // Where the answer scrolls with its lines, it is to be read first.
        const bool alone = top < pitch;
        const std::size_t first = alone ? rows.cause.value_or(0) : 0;
        scrollTo(static_cast<float>(shown.rowOf(first)) * pitch, pitch, 0.0F);
    }
    if (rows.list.settling > 0) --rows.list.settling;
    if (!moved || !place.here || rows.list.settling > 0) return;
    scrollTo(top + static_cast<float>(shown.rowOf(*place.here)) * pitch, pitch,
             ImGui::GetScrollY());
}

}  // namespace

void drawDecisionRows(const PanelContext& context, const DecisionRows& rows, FrameRequest frame) {
    std::optional<std::size_t> chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, kRowGap * context.em});
    const LinePosition place = positionOfCursor(rows, context.session());
    if (rows.list.answer != rows.lines.data()) rows.list.unfolded.clear();
    const ShownRows shown(rows, place);
    RowDrawer drawer(context, rows, place);
    follow(context, rows, place, shown, drawer.pitch());
    drawSeen(shown.size(), drawer.pitch(), [&](std::size_t i) {
        const LineFold row = shown[i];
        if (row.count > 1) {
            if (drawer.drawFold(row)) rows.list.unfolded.push_back(row.first);
        } else if (drawer.draw(row.first)) {
            chosen = row.first;
        }
    });
    ImGui::PopStyleVar();
    if (chosen) goToDecision(context, rows.lines[*chosen].event.address, frame);
}

bool drawPreventing(const PanelContext& context, const FieldValue& change) {
    const RuleSetting* rule = ruleOf(change);
    const bool again =
        rule != nullptr
            ? smallButton(context, "Switch on " + std::string(rule->name), "change on",
                          std::string(rule->summary))
            : smallButton(
                  context, "Run with " + wordsOf(SpecChange{change}), "change on",
                  "Prepare the points so, and run again: " + optionsOf(SpecChange{change}).front());
    if (again) runWith(context.commands, change);
    sameLineFor({"Compare"});
    if (smallButton(context, "Compare", "change beside",
                    "This run and the one with it side by side, at this position"))
        showBeside(context.commands, change);
    return again;
}

void goToDecision(const PanelContext& context, const Address& address, FrameRequest frame) {
    context.pausedMoves().goTo(address);
    context.ui().frame = frame;
}

}  // namespace se::view
