#include "paint/svg_text.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Pixels have at most one digit after the point") {
    const auto pixels = [](float value) {
        std::string text;
        appendPixels(text, value);
        return text;
    };
    CHECK(pixels(12.0F) == "12");
    CHECK(pixels(12.34F) == "12.3");
    CHECK(pixels(-0.26F) == "-0.3");
    CHECK(pixels(-0.01F) == "0");
    CHECK(pixels(9.96F) == "10");
}

TEST_CASE("Text of the user is no part of the markup") {
    CHECK(escapedXml("a<b> & \"c\" 'd'") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    CHECK(escapedXml(std::string("a\x01z\n")) == "az\n");
}

TEST_CASE("The name of a layer's group is its title in small letters") {
    CHECK(nameOfTitle("Edge ring") == "edge-ring");
    CHECK(nameOfTitle("Flips, points put in or out") == "flips-points-put-in-or-out");
}

TEST_CASE("Colors of the palette have classes of their meaning, in one theme or in both") {
    const Palette& dark = paletteOf(Theme::Dark);
    const Palette& light = paletteOf(Theme::Light);
    SvgClasses classes(Theme::Dark, true);
    CHECK(classes.fill({dark.used, light.used}) == "used");
    CHECK(classes.line({dark.used, light.used}) == "used-line");
    CHECK(classes.fill({dark.used, light.used}) == "used");
    const std::string mixed = classes.fill({fromHex(0x123456), fromHex(0x654321)});
    CHECK(classes.sheet() ==
          ".used{fill:#56b4e9}.used-line{stroke:#56b4e9}." + mixed + "{fill:#123456}");
    CHECK(classes.sheet(true) ==
          ".used{fill:#2a7fc0}.used-line{stroke:#2a7fc0}." + mixed + "{fill:#654321}");
}

TEST_CASE("The point and other attributes of a shape do not replace each other") {
    SvgClasses classes(Theme::Dark, false);
    SvgPainter painter(Theme::Dark, 16.0F, classes, "f-");
    const Ink area(fromHex(0xFF0000));
    const Ink edge = Ink(fromHex(0x00FF00)).withAlpha(0.5F).line(1.0F);
    painter.setPoint(4);
    painter.setMore(" stroke-dasharray=\"2\"");
    CHECK(painter.attributesOf(area).find(" data-point=\"4\" stroke-dasharray=\"2\" class=") == 0);
    const std::string both = painter.attributesOf(area, edge);
    CHECK(both ==
          " data-point=\"4\" stroke-dasharray=\"2\" class=\"l1 f0\" stroke-width=\"1\" "
          "stroke-opacity=\"0.5\"");
    painter.setMore({});
    CHECK(painter.attributesOf(area).find(" data-point=\"4\" class=") == 0);
}
