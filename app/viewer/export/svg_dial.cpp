// The dial of the pivot as elements of SVG: the disc of the panel Dial, with its sectors, neighbors
// and names. A second disc is left out: the drawing beside it shows the other point.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layout/dial.h"
#include "layout/overlays.h"
#include "rows/dial_looks.h"
#include "svg_canvas.h"

namespace se::view {

namespace {

/// Sizes in em: names, their letters, their distance from the rim; what is left free around all.
constexpr float kRimSize = 0.8F;
constexpr float kRimLetter = 0.56F;
constexpr float kRimGap = 0.45F;
constexpr float kDialMargin = 0.7F;
/// Height of the heading, and of the caption.
constexpr float kHeading = 2.4F;
constexpr float kDialCaption = 2.0F;
constexpr float kSvgDegree = 3.14159265F / 180.0F;

class SvgDialDrawer {
  public:
    SvgDialDrawer(SvgCanvas& canvas, const FrameDial& frame)
        : canvas_(canvas), frame_(frame), em_(canvas.em()) {
        for (const DialTick& tick : frame_.dial.ticks) addText(tick);
        for (const DialMark& mark : frame_.dial.marks)
            add(mark.degrees, mark.text, &Palette::textDim);
        for (const DialSlot& slot : frame_.dial.slots) add(slot.degrees, slot.text, &Palette::test);
        const Rect& area = frame_.area;
        room_ = {area.min + glm::vec2(kDialMargin, kHeading) * em_,
                 area.size - glm::vec2(2.0F * kDialMargin, kHeading + kDialCaption) * em_};
        room_.size.y = std::min(room_.size.y, 1.1F * room_.size.x);
        disc_ = fitDial(room_, names_, kRimGap * em_, 0.35F * em_);
    }

    void draw() {
        canvas_.beginGroup("dial");
        const Rect& area = frame_.area;
        canvas_.add(
            fmt::format("<rect{} x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                        fillOf(canvas_, color(&Palette::panel), 1.0F), area.min.x, area.min.y,
                        area.size.x, area.size.y));
        circle(fillOf(canvas_, color(&Palette::background), 1.0F));
        for (const DialArc& arc : frame_.dial.arcs) drawArc(arc);
        if (frame_.dial.chord)
            line(at(frame_.dial.chord->from, 1.0F), at(frame_.dial.chord->to, 1.0F),
                 &Palette::rejected, 1.0F, 0.14F);
        circle(" fill=\"none\"" + strokeOf(canvas_, color(&Palette::border), 1.0F, px(0.08F)));
        for (const DialTick& tick : frame_.dial.ticks) drawTick(tick);
        for (const DialMark& mark : frame_.dial.marks)
            line(at(mark.degrees, 0.86F), at(mark.degrees, 1.05F), &Palette::textDim, 1.0F, 0.14F);
        drawSvgShape(canvas_, Shape::RingedDisc, disc_.center, 0.57F * em_, color(&Palette::pivot),
                     frame_.dial.pivot);
        drawNames();
        drawTexts();
        canvas_.endGroup();
    }

  private:
    ColorPair color(Color Palette::*which) const { return bothThemes(canvas_.in(), which); }
    float px(float width) const { return std::max(1.0F, width * em_); }
    glm::vec2 at(double degrees, float reach) const {
        const float a = static_cast<float>(degrees) * kSvgDegree;
        return disc_.center + reach * disc_.radius * glm::vec2(std::cos(a), -std::sin(a));
    }
    void add(double degrees, std::string text, Color Palette::*color) {
        const float wide = kRimLetter * kRimSize * em_ * static_cast<float>(text.size());
        names_.push_back({degrees, {wide, kRimSize * em_}});
        texts_.emplace_back(std::move(text), color);
    }
    /// Points in the list alone have no name.
    void addText(const DialTick& tick) {
        if (isFaint(tick) && !tick.underTest) return;
        add(tick.degrees, labelOf(tick, frame_.names),
            tick.underTest ? &Palette::text : lookOf(tick.role).color);
    }

    void circle(const std::string& attributes) {
        canvas_.add(fmt::format("<circle{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>", attributes,
                                disc_.center.x, disc_.center.y, disc_.radius));
    }
    void line(glm::vec2 from, glm::vec2 to, Color Palette::*which, float alpha, float width) {
        std::string data = "M";
        appendPlace(data, from);
        data += 'L';
        appendPlace(data, to);
        canvas_.addPath(strokeOf(canvas_, color(which), alpha, px(width)), data);
    }
    /// The line of an arc from its start.
    std::string arcData(const DialArc& arc, float reach) const {
        const double to = std::min(arc.to, arc.from + 359.9);
        std::string data;
        appendPlace(data, at(arc.from, reach));
        data += fmt::format("A{0:.1f} {0:.1f} 0 {1} 0 ", reach * disc_.radius,
                            to - arc.from > 180.0 ? 1 : 0);
        appendPlace(data, at(to, reach));
        return data;
    }
    void stroke(const DialArc& arc, float reach, Color Palette::*which, float width) {
        canvas_.addPath(" fill=\"none\"" + strokeOf(canvas_, color(which), 1.0F, px(width)),
                        "M" + arcData(arc, reach));
    }
    void fillSector(const DialArc& arc, float reach, Color Palette::*which, float alpha) {
        std::string data = "M";
        appendPlace(data, disc_.center);
        canvas_.addPath(fillOf(canvas_, color(which), alpha),
                        data + "L" + arcData(arc, reach) + "z");
    }
    void drawArc(const DialArc& each) {
        const DialArcLook& look = lookOf(each.kind);
        if (look.fill > 0.0F) fillSector(each, look.reach, look.color, look.fill);
        if (look.width > 0.0F) stroke(each, look.reach, look.color, look.width);
    }

    void drawTick(const DialTick& tick) {
        Color Palette::*which = colorOf(tick);
        const glm::vec2 tip = at(tick.degrees, 0.92F * std::max(0.12F, tick.reach));
        const float alpha = tick.role == DialRole::Rejected ? 0.45F : 0.9F;
        if (!isFaint(tick)) line(disc_.center, tip, which, alpha, tick.underTest ? 0.14F : 0.08F);
        const float top =
            std::clamp(tip.y - tick.height * disc_.radius, room_.min.y, room_.max().y);
        if (std::abs(top - tip.y) > 0.2F * em_) line(tip, {tip.x, top}, which, 0.8F, 0.07F);
        drawSvgShape(canvas_, lookOf(tick.role).shape, tip, 0.5F * sizeOf(tick) * em_, color(which),
                     tick.point);
        if (tick.underTest)
            drawSvgShape(canvas_, Shape::Circle, tip, 0.7F * em_, color(&Palette::test),
                         tick.point);
    }

    void text(glm::vec2 place, float size, Color Palette::*which, const char* more,
              const std::string& words) {
        canvas_.add(
            fmt::format("<text{}{} x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\">{}</text>",
                        fillOf(canvas_, color(which), 1.0F), more, place.x, place.y, 0.826F * size,
                        escapedXml(words)));
    }
    void drawNames() {
        const NameRoom around{room_, {}, kRimGap * em_, 1.15F * kRimSize * em_};
        for (const PlacedName& each : placeNames(disc_, around, names_)) {
            const auto& [words, which] = texts_[each.name];
            const glm::vec2 rim = at(names_[each.name].degrees, 1.0F);
            if (each.leader) line(rim, nearestIn(each.rect, rim), which, 0.7F, 0.05F);
            text({each.rect.min.x + 0.5F * each.rect.size.x,
                  each.rect.min.y + 0.8F * each.rect.size.y},
                 kRimSize * em_, which, " text-anchor=\"middle\"", words);
        }
    }
    /// Heading and caption.
    void drawTexts() {
        const Rect& area = frame_.area;
        text(area.min + glm::vec2(kDialMargin, 1.3F) * em_, em_, &Palette::textDim, "",
             "Tangent plane at " + nameOf(frame_.dial.pivot, frame_.names));
        text({area.min.x + 0.5F * area.size.x, room_.max().y + 1.4F * em_}, em_, &Palette::text,
             " text-anchor=\"middle\"", frame_.dial.caption);
    }

    SvgCanvas& canvas_;
    const FrameDial& frame_;
    float em_;
    std::vector<DialName> names_;
    std::vector<std::pair<std::string, Color Palette::*>> texts_;  ///< Of `names_`.
    Rect room_;
    DialCircle disc_;
};

}  // namespace

void drawSvgDial(SvgCanvas& canvas, const FrameDial& dial) {
    if (!dial.dial.empty()) SvgDialDrawer(canvas, dial).draw();
}

}  // namespace se::view
