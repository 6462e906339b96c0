#include "labels.h"

#include "layout/overlays.h"
#include "text_cut.h"

namespace se::view {

namespace {

/// Distances in a title bar, in em: of letter, name and note from its ends; room for a name.
constexpr float kLetterAt = 0.8F;
constexpr float kNameAt = 2.2F;
constexpr float kNoteAt = 0.7F;
constexpr float kLeastName = 6.0F;

/// Opacity of a plate, and opacity and width in em of the line that leads to it.
constexpr float kPlateAlpha = 0.78F;
constexpr float kLeaderAlpha = 0.7F;
constexpr float kLeaderEms = 0.06F;

}  // namespace

void drawLabels(Painter& painter, std::span<const DrawnLabel> labels, const DrawList& list,
                const DrawList* other) {
    const auto inkOf = [&](const DrawnLabel& each) {
        const Color& color = list.labels[each.index].color;
        return Ink(color, other != nullptr ? other->labels[each.index].color : color);
    };
    for (const DrawnLabel& each : labels) {
        if (each.leader)
            painter.line(each.at, nearestIn(each.plate, each.at),
                         inkOf(each).withAlpha(kLeaderAlpha).line(painter.px(kLeaderEms)));
    }
    for (const DrawnLabel& each : labels) {
        painter.box(each.plate, painter.ink(&Palette::background, kPlateAlpha),
                    0.2F * painter.em());
        painter.text(each.text, list.labels[each.index].text, inkOf(each), each.type);
    }
}

void drawTitleBar(Painter& painter, const Rect& bar, const ComparedTitle& title) {
    const float em = painter.em();
    const Ink mark = painter.ink(title.color);
    painter.box(bar, painter.ink(&Palette::panelRaised));
    painter.box({bar.min, {0.3F * em, bar.size.y}}, mark);
    const float y = bar.min.y + 0.5F * (bar.size.y - em);
    painter.text({bar.min.x + kLetterAt * em, y}, title.letter, mark, {em, Typeface::Strong});
    const auto widthOf = [&](const std::string& text) { return painter.textSize(text, {em}).x; };
    const float room = bar.size.x - (kNameAt + kNoteAt) * em;
    const float noteWidth = title.note.empty() ? 0.0F : widthOf(title.note);
    const bool both = noteWidth + kLeastName * em <= room;
    painter.text({bar.min.x + kNameAt * em, y},
                 withoutMiddle(title.name, both ? room - noteWidth - em : room, widthOf),
                 painter.ink(&Palette::text), {em});
    if (both)
        painter.text({bar.max().x - kNoteAt * em, y}, title.note, mark,
                     {em, Typeface::Text, Align::Right});
}

}  // namespace se::view
