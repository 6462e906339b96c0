// All sizes are multiples of the em, so that the layout follows the size of the text. Rows are cut
// off from top and bottom and columns from the sides, with limits for narrow and low windows; the
// view gets the rest.
#include "panel_rects.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace se::view {

namespace {

constexpr float kMenu = 1.56F;
constexpr float kTransport = 2.7F;
constexpr float kStatus = 1.7F;
/// Height of the narration: two lines of a wide view, three of one narrower than kWideView.
constexpr float kNarration = 3.6F;
constexpr float kNarrationNarrow = 4.7F;
/// Narration below half of a view: sentences take three lines there.
constexpr float kNarrationHalf = 5.6F;
/// ... but no more than this share of the height: titles take some of it as well.
constexpr float kMaxHalf = 0.42F;
constexpr float kWideView = 40.0F;
/// In a low window the view comes first: a large caption gets this share of the height at most.
constexpr float kMaxNarration = 0.5F;
/// Share of the height that the text of a lesson has in Present.
constexpr float kLessonShare = 0.34F;
/// The most, where a question needs more.
constexpr float kQuestionShare = 0.5F;
/// Line above it, where nothing else shows the address.
constexpr float kAddressLine = 1.4F;
/// Heights of the strips: RUN in a folded drawer, in an open one, in an open one of a high window.
constexpr float kRunFolded = 3.0F;
constexpr float kRunOpen = 4.9F;
constexpr float kRunHigh = 6.4F;
constexpr float kPivotStrip = 2.9F;
constexpr float kStageStrip = 2.3F;
/// Limits below which the window is narrow, or low.
constexpr float kNarrowBelow = 58.0F;
constexpr float kLowBelow = 43.75F;
constexpr float kHighFrom = 54.0F;
/// No drawer is opened below this height: no room would be left for the view.
constexpr float kDrawerFrom = 30.0F;
/// Height from which the dial has an area of its own: below, the panels under it would be too
/// short.
constexpr float kDialRoom = 22.0F;
constexpr float kLearnDialRoom = 30.0F;
/// Heights of Find and Change: tabs alone, tabs and one line.
constexpr float kTabsAlone = 2.9F;
constexpr float kTabsAndLine = 4.6F;
/// The height that the view keeps above Find and Change, at least and as a share of the height
/// between bars and strips; and the least height of theirs.
constexpr float kLeastView = 12.0F;
constexpr float kViewShare = 0.32F;
constexpr float kLeastLower = 6.0F;
/// Height of the left column from which the rings have a part of it.
constexpr float kRingsRoom = 17.0F;
constexpr float kSplitter = 0.5F;
/// Learners and audiences read the caption first.
constexpr float kLargeCaption = 1.5F;

/// A page with a form: its column, and the controls below the view, wide and narrow.
constexpr float kPageColumn = 17.0F;
constexpr float kPageColumnWide = 26.0F;
constexpr float kPageBar = 5.4F;
constexpr float kPageBarNarrow = 8.6F;

/// Widths of the side columns, in em.
struct Columns {
    float left = 0.0F;
    float right = 0.0F;
};

Columns columnsFor(LayoutPreset layoutPreset, float width, bool narrow, const PanelSizes& sizes) {
    if (layoutPreset == LayoutPreset::Present) return {};
    if (layoutPreset == LayoutPreset::Learn)
        return {sizes.within(Splitter::LearnColumn, std::clamp(0.32F * width, 14.0F, 28.0F), 14.0F,
                             0.6F * width),
                0.0F};
    if (layoutPreset == LayoutPreset::Compare)
        return {std::clamp(0.28F * width, 13.0F, 24.0F), 0.0F};
    if (narrow) return {0.0F, std::clamp(0.48F * width, 12.0F, 20.0F)};
    Columns columns{sizes.within(Splitter::Left, std::clamp(0.225F * width, 15.0F, 22.0F), 10.0F,
                                 0.35F * width),
                    sizes.within(Splitter::Right, std::clamp(0.24F * width, 19.0F, 26.0F), 14.0F,
                                 0.45F * width)};
    // The view keeps its share.
    const float over = (columns.left + columns.right) / (0.6F * width);
    if (over > 1.0F) columns = {columns.left / over, columns.right / over};
    return columns;
}

/// `opened`: a panel of Find or Change is open below the view, which the drawer leaves its room to.
bool isFolded(float emsHigh, DrawerChoice choice, bool opened) {
    if (emsHigh < kDrawerFrom || choice == DrawerChoice::Folded) return true;
    return choice == DrawerChoice::Auto && emsHigh < (opened ? kHighFrom : kLowBelow);
}

/// Divides the drawer into its strips, which are `run` and `pivot` high; the rest is the stage's.
void layOutStrips(PanelRects& l, float run, float pivot) {
    const Rect& d = l.drawer;
    const auto part = [&](float from, float to) {
        return Rect{{d.min.x, d.min.y + from}, {d.size.x, std::max(0.0F, to - from)}};
    };
    l.runStrip = part(0.0F, std::min(run, d.size.y));
    if (l.drawerFolded) return;
    l.pivotStrip = part(run, run + pivot);
    l.stageStrip = part(run + pivot, d.size.y);
}

/// A splitter on the lower or right edge of `part`, or with `sign` -1 on its upper or left edge.
void addSplitter(PanelRects& l, Splitter splitter, const Rect& part, bool sideways, float sign,
                 float em) {
    const float half = std::round(0.5F * kSplitter * em);
    const bool grows = sign > 0.0F;
    SplitterPlace& place = l.splitters[static_cast<std::size_t>(splitter)];
    place.sideways = sideways;
    place.sign = sign;
    if (sideways) {
        const float x = grows ? part.max().x : part.min.x;
        place.from = grows ? part.min.x : part.max().x;
        place.handle = {{x - half, part.min.y}, {2.0F * half, part.size.y}};
    } else {
        const float y = grows ? part.max().y : part.min.y;
        place.from = grows ? part.min.y : part.max().y;
        place.handle = {{part.min.x, y - half}, {part.size.x, 2.0F * half}};
    }
}

/// Height of Find and Change; 0: there is no room for them below the view.
float lowerHeight(float middle, float narration, const PanelSizes& sizes) {
    const float most = middle - narration - std::max(kLeastView, kViewShare * middle);
    if (most < kLeastLower) return 0.0F;
    if (sizes.folded) return kTabsAlone;
    if (sizes.quiet) return kTabsAndLine;
    return sizes.within(Splitter::Lower, std::clamp(0.36F * middle, 9.0F, 20.0F), kLeastLower,
                        most);
}

/// Cuts the areas of Find and Change from the bottom of what is left of the right column.
void layOutLower(PanelRects& l, float height, float em, const PanelSizes& sizes) {
    l.groupsApart = height > 0.0F;
    if (!l.groupsApart) return;
    const float width = l.right.min.x;
    const float bottom = l.right.max().y;
    const float find = std::round(
        em * sizes.within(Splitter::Find, 0.58F * width / em, 14.0F, width / em - 14.0F));
    l.find = {{0.0F, bottom - height}, {find, height}};
    l.change = {{find, bottom - height}, {width - find, height}};
    addSplitter(l, Splitter::Find, l.find, true, 1.0F, em);
    if (!sizes.quiet || sizes.folded)
        addSplitter(l, Splitter::Lower, {l.find.min, {width, height}}, false, -1.0F, em);
}

/// Divides the side columns: rings below the steps, the dial above the groups, or in Learn below.
void layOutColumns(PanelRects& l, float em, const PanelSizes& sizes) {
    const bool learn = l.layoutPreset == LayoutPreset::Learn;
    const bool debug = l.layoutPreset == LayoutPreset::Debug;
    if (debug && !l.narrow) addSplitter(l, Splitter::Left, l.left, true, 1.0F, em);
    if (debug && !l.narrow) addSplitter(l, Splitter::Right, l.right, true, -1.0F, em);
    if (learn) addSplitter(l, Splitter::LearnColumn, l.left, true, 1.0F, em);
    Rect& column = learn ? l.left : l.right;
    const float high = column.size.y / em;
    const Splitter splitter = learn ? Splitter::LearnDial : Splitter::Dial;
    l.dialApart = (debug && !l.narrow && high >= kDialRoom) ||
                  (learn && high >= kLearnDialRoom && sizes.of(splitter) >= 0.0F);
    if (l.dialApart) {
        const float automatic = std::min(column.size.x / em + 1.0F, 0.45F * high);
        const float dial = std::round(em * sizes.within(splitter, automatic, 8.0F, high - 10.0F));
        const float top = learn ? column.max().y - dial : column.min.y;
        l.dial = {{column.min.x, top}, {column.size.x, dial}};
        column.size.y -= dial;
        if (!learn) column.min.y += dial;
        addSplitter(l, splitter, l.dial, false, learn ? -1.0F : 1.0F, em);
    }
    const float left = l.left.size.y / em;
    if (!debug || l.narrow || left < kRingsRoom) return;
    const float rings = std::round(
        em * sizes.within(Splitter::Rings, std::max(9.0F, 0.34F * left), 4.0F, left - 8.0F));
    l.rings = {{l.left.min.x, l.left.max().y - rings}, {l.left.size.x, rings}};
    addSplitter(l, Splitter::Rings, l.rings, false, -1.0F, em);
}

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

/// Divides view and narration into two.
void splitInTwo(PanelRects& l, float title) {
    const float half = std::floor(0.5F * l.view.size.x);
    splitView(l, title);
    l.otherNarration = l.narration;
    l.narration.size.x = half;
    l.otherNarration.min.x += half;
    l.otherNarration.size.x -= half;
}

}  // namespace

PanelRects viewAlone(glm::vec2 size, const BesideView& beside) {
    PanelRects rects;
    rects.view.size = size - glm::vec2(beside.dial, beside.narration);
    rects.narration = {{0.0F, rects.view.size.y}, {size.x, beside.narration}};
    rects.dial = {{rects.view.size.x, 0.0F}, {beside.dial, rects.view.size.y}};
    rects.dialApart = beside.dial > 0.0F;
    if (beside.title <= 0.0F) return rects;
    rects.layoutPreset = LayoutPreset::Compare;
    splitInTwo(rects, beside.title);
    return rects;
}

PanelRects computePageRects(glm::vec2 size, float em) {
    const glm::vec2 ems = size / em;
    const auto px = [em](float length) { return std::round(length * em); };
    PanelRects l;
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
    l.status = {{0.0F, size.y}, {size.x, 0.0F}};
    return l;
}

PanelRects computePanelRects(glm::vec2 size, float em, LayoutPreset layoutPreset,
                             DrawerChoice choice, const PanelSizes& sizes) {
    const glm::vec2 ems = size / em;
    const bool present = layoutPreset == LayoutPreset::Present;
    const bool debug = layoutPreset == LayoutPreset::Debug;
    const bool compare = layoutPreset == LayoutPreset::Compare;
    if (compare && choice == DrawerChoice::Auto) choice = DrawerChoice::Folded;
    PanelRects l;
    l.layoutPreset = layoutPreset;
    l.caption = debug || compare ? 1.0F : kLargeCaption;
    l.narrow = debug && ems.x < kNarrowBelow;
    const bool opened = debug && !l.narrow && !sizes.quiet && !sizes.folded;
    l.drawerFolded = present || isFolded(ems.y, choice, opened);
    const auto px = [em](float length) { return std::round(length * em); };
    const Columns columns = columnsFor(layoutPreset, ems.x, l.narrow, sizes);
    const float left = px(columns.left);
    const float right = px(columns.right);
    const bool lesson = present && sizes.lesson;
    const float run = px(lesson              ? 0.0F
                         : l.drawerFolded    ? kRunFolded
                         : ems.y < kHighFrom ? kRunOpen
                                             : kRunHigh);
    const float drawer = run + (l.drawerFolded ? 0.0F : px(kPivotStrip) + px(kStageStrip));
    const float shown = size.x - left - right;
    const bool wide = (compare ? 0.5F * shown : shown) >= px(kWideView);
    l.addressLine = present && !lesson ? px(kAddressLine) : 0.0F;
    const float text =
        std::clamp(px(sizes.caption), kLessonShare * size.y, kQuestionShare * size.y);
    const float wanted = lesson ? std::round(text)
                                : l.addressLine + px((wide      ? kNarration
                                                      : compare ? kNarrationHalf
                                                                : kNarrationNarrow) *
                                                     l.caption);
    float y = 0.0F;
    const auto row = [&](float height) {
        const Rect r{{0.0F, y}, {size.x, height}};
        y += height;
        return r;
    };
    l.menu = row(present ? 0.0F : px(kMenu));
    l.transport = row(present ? 0.0F : px(kTransport));
    const float status = present ? 0.0F : px(kStatus);
    const float bottom = size.y - status - drawer;
    const float middle = std::max(0.0F, bottom - y);
    const float most = std::max(l.addressLine + px(kNarration),
                                std::round((compare ? kMaxHalf : kMaxNarration) * middle));
    const float narration = lesson ? wanted : std::min(wanted, most);
    const float lower =
        debug && !l.narrow ? px(lowerHeight(middle / em, narration / em, sizes)) : 0.0F;
    const float upper = middle - lower;
    l.left = {{0.0F, y}, {left, upper}};
    l.right = {{size.x - right, y}, {right, middle}};
    layOutLower(l, lower, em, sizes);
    layOutColumns(l, em, sizes);
    const float viewWidth = std::max(0.0F, size.x - left - right);
    l.view = {{left, y}, {viewWidth, std::max(0.0F, upper - narration)}};
    l.narration = {{left, y + l.view.size.y}, {viewWidth, std::min(narration, upper)}};
    if (compare) splitInTwo(l, px(kViewTitle));
    if (present && sizes.beside) splitView(l, px(kViewTitle));
    y = bottom;
    l.drawer = row(drawer);
    layOutStrips(l, run, px(kPivotStrip));
    l.status = row(status);
    return l;
}

}  // namespace se::view
