// All sizes are multiples of the em, so that the layout follows the size of the text. Rows are cut
// off from top and bottom and columns from the side, with limits for narrow and low windows; the
// view gets the rest.
#include "panel_rects.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace se::view {

namespace {

constexpr float kMenu = 1.56F;
constexpr float kRail = 2.75F;
/// Width of the column: the least, from which width of the window it grows, and the most.
constexpr float kLeastColumn = 14.75F;
constexpr float kGrowsFrom = 64.0F;
constexpr float kGrows = 0.25F;
constexpr float kMostColumn = 26.0F;
/// Limits for the user.
constexpr float kNarrowestColumn = 12.0F;
constexpr float kWidestShare = 0.45F;

/// Heights of the rows of the strip.
constexpr float kTransport = 2.9F;
constexpr float kLanes = 4.1F;
constexpr float kStage = 2.4F;
/// Widths of the parts of its first row, and the room from which each is there.
constexpr float kButtons = 28.8F;
constexpr float kButtonsAlone = 16.6F;
constexpr float kWideFrom = 58.0F;
constexpr float kFigures = 16.5F;
constexpr float kFiguresFrom = 46.0F;
/// Below this height the strip is folded.
constexpr float kLowBelow = 32.0F;

/// Narrower and higher than wide: a phone's shape.
constexpr float kPhoneBelow = 36.0F;
constexpr float kPhoneRail = 3.2F;
constexpr float kPhoneButtons = 3.8F;
constexpr float kPhoneCaption = 4.8F;
/// Share of the height between menu and buttons that the sheet takes.
constexpr float kSheet = 0.58F;

/// Present: height of the narration, two lines of a wide view, three of one narrower than
/// kWideView.
constexpr float kNarration = 3.6F;
constexpr float kNarrationNarrow = 4.7F;
constexpr float kWideView = 40.0F;
/// In a low window the view comes first: a large caption gets this share of the height at most.
constexpr float kMaxNarration = 0.5F;
/// Share of the height that the text of a lesson has until it is measured.
constexpr float kLessonShare = 0.34F;
constexpr float kAddressLine = 1.4F;
constexpr float kPresentLanes = 3.5F;
/// Audiences read the caption first.
constexpr float kLargeCaption = 1.5F;

/// A page with a form: its column, and the controls below the view, wide and narrow.
constexpr float kPageColumn = 17.0F;
constexpr float kPageColumnWide = 26.0F;
constexpr float kPageBar = 5.4F;
constexpr float kPageBarNarrow = 8.6F;

/// Divides the view into two, each with its title.
void splitView(PanelRects& l, float title) {
    const Rect both = l.view;
    const glm::vec2 half = glm::floor(0.5F * both.size);
    const bool beside = std::min(half.x, both.size.y) >= std::min(both.size.x, half.y);
    Rect first{both.min, beside ? glm::vec2(half.x, both.size.y) : glm::vec2(both.size.x, half.y)};
    Rect second{
        beside ? glm::vec2(first.max().x, both.min.y) : glm::vec2(both.min.x, first.max().y),
        beside ? glm::vec2(both.size.x - half.x, both.size.y)
               : glm::vec2(both.size.x, both.size.y - half.y)};
    const auto cutTitle = [title](Rect& view) {
        const Rect bar{view.min, {view.size.x, std::min(title, view.size.y)}};
        view.min.y += bar.size.y;
        view.size.y -= bar.size.y;
        return bar;
    };
    l.title = cutTitle(first);
    l.otherTitle = cutTitle(second);
    l.view = first;
    l.otherView = second;
}

/// Lengths in pixels, and what is left of the window while areas are cut from it.
class Cutter {
  public:
    Cutter(glm::vec2 size, float em) : em_(em), rest_{{0.0F, 0.0F}, size} {}

    float px(float ems) const { return std::round(ems * em_); }
    const Rect& rest() const { return rest_; }
    Rect top(float height) {
        Rect r = rest_;
        r.size.y = std::min(height, rest_.size.y);
        rest_.min.y += r.size.y;
        rest_.size.y -= r.size.y;
        return r;
    }
    Rect bottom(float height) {
        Rect r = rest_;
        r.size.y = std::min(height, rest_.size.y);
        r.min.y = rest_.max().y - r.size.y;
        rest_.size.y -= r.size.y;
        return r;
    }
    Rect right(float width) {
        Rect r = rest_;
        r.size.x = std::min(width, rest_.size.x);
        r.min.x = rest_.max().x - r.size.x;
        rest_.size.x -= r.size.x;
        return r;
    }

  private:
    float em_;
    Rect rest_;
};

/// Divides the first row of the strip: transport, the cells of the pivot or the line of the run,
/// figures.
void layOutRow(PanelRects& l, const Cutter& cut, const Rect& row, bool finished) {
    const float ems = row.size.x / cut.px(1.0F);
    const float buttons = cut.px(ems >= kWideFrom ? kButtons : kButtonsAlone);
    const float figures = ems >= kFiguresFrom ? cut.px(kFigures) : 0.0F;
    l.transport = {row.min, {std::min(buttons, row.size.x), row.size.y}};
    l.figures = {{row.max().x - figures, row.min.y}, {figures, row.size.y}};
    const Rect between{{l.transport.max().x, row.min.y},
                       {std::max(0.0F, row.size.x - l.transport.size.x - figures), row.size.y}};
    if (l.stripFolded && finished) {
        l.runStrip = between;
    } else {
        l.pivotStrip = between;
    }
}

void layOutStrip(PanelRects& l, Cutter& cut, const WindowState& state, float emsHigh) {
    const bool low = emsHigh < kLowBelow;
    l.stripFolded = state.strip == StripChoice::Folded ||
                    (state.strip == StripChoice::Auto && (state.finished || low));
    const bool open = state.strip == StripChoice::Open && !low;
    const Rect stage = cut.bottom(open ? cut.px(kStage) : 0.0F);
    const Rect lanes = cut.bottom(l.stripFolded ? 0.0F : cut.px(kLanes));
    const Rect row = cut.bottom(cut.px(kTransport));
    l.strip = {row.min, {row.size.x, row.size.y + lanes.size.y + stage.size.y}};
    layOutRow(l, cut, row, state.finished);
    if (!l.stripFolded) l.runStrip = lanes;
    if (open) l.stageStrip = stage;
}

float columnWidth(const PanelSizes& sizes, float ems) {
    const float automatic =
        std::clamp(kLeastColumn + kGrows * (ems - kGrowsFrom), kLeastColumn, kMostColumn);
    const float wanted = sizes.column > 0.0F ? sizes.column : automatic;
    return std::clamp(wanted, kNarrowestColumn, std::max(kNarrowestColumn, kWidestShare * ems));
}

void layOutColumn(PanelRects& l, Cutter& cut, const WindowState& state, float ems) {
    l.rail = cut.right(cut.px(kRail));
    if (state.sizes.folded) return;
    l.column = cut.right(cut.px(columnWidth(state.sizes, ems)));
    const float half = cut.px(0.25F);
    l.splitter = {{l.column.min.x - half, l.column.min.y}, {2.0F * half, l.column.size.y}};
}

/// One column: view, sentence, large buttons, tasks; the sheet, above the buttons, takes half of
/// it. With a question, the sheet reaches to the lower edge.
void layOutPhone(PanelRects& l, Cutter& cut, const WindowState& state) {
    l.phone = true;
    l.stripFolded = true;
    l.rail = cut.bottom(cut.px(kPhoneRail));
    l.strip = l.transport = cut.bottom(cut.px(kPhoneButtons));
    const float caption = cut.px(kPhoneCaption);
    if (state.sheet || state.asks)
        l.column = cut.bottom(std::round(kSheet * (cut.rest().size.y - caption)));
    l.narration = cut.bottom(caption);
    if (!state.asks) return;
    l.column.size.y += l.strip.size.y + l.rail.size.y;
    l.rail = l.strip = l.transport = {};
}

/// View, caption and lanes; with a lesson, its text is the caption.
void layOutPresent(PanelRects& l, Cutter& cut, const WindowState& state, glm::vec2 size) {
    l.caption = kLargeCaption;
    l.stripFolded = true;
    l.addressLine = state.lesson ? 0.0F : cut.px(kAddressLine);
    l.strip = l.runStrip = cut.bottom(state.lesson ? 0.0F : cut.px(kPresentLanes));
    if (state.lesson) {
        const float text =
            state.captionEms > 0.0F ? cut.px(state.captionEms) : kLessonShare * size.y;
        l.narration = cut.bottom(std::round(std::min(text, kLargestLessonShare * size.y)));
        return;
    }
    const bool wide = size.x >= cut.px(kWideView);
    const float wanted = l.addressLine + cut.px((wide ? kNarration : kNarrationNarrow) * l.caption);
    const float most =
        std::max(l.addressLine + cut.px(kNarration), std::round(kMaxNarration * cut.rest().size.y));
    l.narration = cut.bottom(std::min(wanted, most));
}

}  // namespace

PanelRects viewAlone(glm::vec2 size, const BesideView& beside) {
    PanelRects rects;
    rects.window = size;
    rects.view.size = size - glm::vec2(beside.dial, beside.narration);
    rects.narration = {{0.0F, rects.view.size.y}, {size.x, beside.narration}};
    rects.dial = {{rects.view.size.x, 0.0F}, {beside.dial, rects.view.size.y}};
    if (beside.title <= 0.0F) return rects;
    rects.layoutPreset = LayoutPreset::Compare;
    splitView(rects, beside.title);
    return rects;
}

PanelRects computePageRects(glm::vec2 size, float em) {
    const glm::vec2 ems = size / em;
    const auto px = [em](float length) { return std::round(length * em); };
    PanelRects l;
    l.window = size;
    const float top = px(kMenu);
    const float column = px(std::clamp(0.3F * ems.x, kPageColumn, kPageColumnWide));
    const float left = std::min(column, 0.5F * size.x);
    const float bar = px(ems.x - left / em >= kWideView ? kPageBar : kPageBarNarrow);
    const float middle = std::max(0.0F, size.y - top);
    const float width = std::max(0.0F, size.x - left);
    l.menu = {{0.0F, 0.0F}, {size.x, top}};
    l.left = {{0.0F, top}, {left, middle}};
    l.view = {{left, top}, {width, std::max(0.0F, middle - bar)}};
    l.narration = {{left, top + l.view.size.y}, {width, std::min(bar, middle)}};
    return l;
}

PanelRects computePanelRects(glm::vec2 size, float em, const WindowState& state) {
    const glm::vec2 ems = size / em;
    PanelRects l;
    l.window = size;
    l.layoutPreset = state.layoutPreset;
    Cutter cut(size, em);
    const bool present = state.layoutPreset == LayoutPreset::Present;
    const bool compare = state.layoutPreset == LayoutPreset::Compare;
    if (present) {
        layOutPresent(l, cut, state, size);
    } else if (ems.x < kPhoneBelow && ems.y > ems.x) {
        l.menu = cut.top(cut.px(kFinger));
        layOutPhone(l, cut, state);
    } else {
        l.menu = cut.top(cut.px(kMenu));
        layOutStrip(l, cut, state, ems.y);
        layOutColumn(l, cut, state, ems.x);
    }
    l.view = cut.rest();
    if (compare || (present && state.beside)) splitView(l, cut.px(kViewTitle));
    return l;
}

}  // namespace se::view
