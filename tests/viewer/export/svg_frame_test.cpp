#include "export/svg_frame.h"

#include <doctest/doctest.h>

#include <cmath>

#include "open_session.h"
#include "scene/camera.h"

using namespace se::view;

namespace {

/// Number of times that `part` stands in `text`.
std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

/// A view from the front on things that a test puts there; x to the right, y away from the eye.
struct FrontView {
    std::shared_ptr<const Model> model = test::sphereModel();
    Camera camera;
    DrawList list;
    std::vector<DrawnLabel> labels;

    FrontView() {
        camera.set(ViewPreset::Front);
        camera.setPose({glm::vec3(0.0F), 4.0633F, -90.0F, 0.0F});
        list.cloudVisible = list.meshVisible = false;
    }
    std::string drawn(const DrawList* other = nullptr) {
        SvgClasses classes(Theme::Dark, other != nullptr);
        const FrameShapes shapes{list,  other, *model, {}, camera.matrices(1.0F), {400.0F, 400.0F},
                                 16.0F, labels};
        return svgFrame(shapes, classes, "f-").value();
    }
    /// A wall before everything on the left half.
    void addWall() {
        const Color color = fromHex(0x808080);
        list.faces.push_back({{glm::vec3(-1, -0.5F, -1), {0, -0.5F, -1}, {0, -0.5F, 1}}, color});
        list.faces.push_back({{glm::vec3(-1, -0.5F, -1), {0, -0.5F, 1}, {-1, -0.5F, 1}}, color});
    }
};

const Color kRed = fromHex(0xFF0000);

}  // namespace

TEST_CASE("A line after a wall is cut where it is tested, faint where it shines through") {
    for (const Depth depth : {Depth::Tested, Depth::XRay, Depth::OnTop}) {
        FrontView view;
        view.addWall();
        view.list.layers = {{"Edge ring"}};
        view.list.line({-0.8F, 0.0F, 0.0F}, {0.8F, 0.0F, 0.0F}, kRed, 0.1F, depth);
        const std::string svg = view.drawn();
        const std::string ring = svg.substr(svg.find("<g id=\"f-edge-ring\">"));
        CHECK(countOf(ring, "M") == (depth == Depth::XRay ? 2 : 1));
        CHECK(countOf(ring, "stroke-opacity=\"0.34\"") == (depth == Depth::XRay ? 1 : 0));
        // From the edge of the wall in the middle, or from the left.
        const double from = std::stod(ring.substr(ring.find('M') + 1));
        if (depth == Depth::Tested) CHECK(std::abs(from - 200.0) < 4.0);
        if (depth != Depth::Tested) CHECK(from < 100.0);
    }
}

TEST_CASE("Triangles are drawn from back to front, hidden ones not at all") {
    FrontView view;
    view.list.faces.push_back({{glm::vec3(-1, 0.5F, -1), {1, 0.5F, -1}, {0, 0.5F, 1}}, kRed});
    view.list.faces.push_back(
        {{glm::vec3(-0.1F, 0.8F, -0.1F), {0.1F, 0.8F, -0.1F}, {0, 0.8F, 0.1F}}, fromHex(0x00FF00)});
    view.list.faces.push_back(
        {{glm::vec3(-0.2F, 0, -0.2F), {0.2F, 0, -0.2F}, {0, 0, 0.2F}}, fromHex(0x0000FF)});
    view.list.meshEdges = false;
    const std::string svg = view.drawn();
    CHECK(countOf(svg, "<path") == 2);
    // The large one, which is the farther one, is the first.
    CHECK(svg.find("\"f0\"") < svg.find("\"f1\""));
}

TEST_CASE("Points that a triangle hides are left out, others have their numbers") {
    FrontView view;
    view.list.cloudVisible = true;
    view.list.cloudStyles.styles[0] = {kRed, 0.5F, se::view::Shape::Disc, false};
    view.list.cloudStyleOf.resize(view.model->place.size());
    const std::size_t all = countOf(view.drawn(), "data-point");
    CHECK(all == view.model->place.size());
    view.list.faces.push_back({{glm::vec3(-9, 1.2F, -9), {9, 1.2F, -9}, {0, 1.2F, 9}}, kRed});
    CHECK(countOf(view.drawn(), "data-point") == all);
    view.list.faces[0].corners = {glm::vec3(-9, 0, -9), {9, 0, -9}, {0, 0, 9}};
    const std::size_t shown = countOf(view.drawn(), "data-point");
    CHECK(shown < 2 * all / 3);
    CHECK(shown > all / 3);
}

TEST_CASE("Labels are text, with the signs of markup escaped, and a mark knows its point") {
    FrontView view;
    view.list.label({0, 0, 0}, "d < r & s", kRed);
    view.labels.push_back({0, {200, 200}, {{210, 190}, {60, 18}}, {213, 190}, {14.0F}, true});
    view.list.layers = {{"Labels"}};
    view.list.mark(view.model->place[7], se::view::Shape::RingedDisc, kRed, 1.0F);
    const std::string svg = view.drawn();
    CHECK(svg.find(">d &lt; r &amp; s</text>") != std::string::npos);
    CHECK(svg.find("data-point=\"7\"") != std::string::npos);
    CHECK(svg.find("<g id=\"f-labels\">") != std::string::npos);
}

TEST_CASE("Equal frames give equal text, and both themes one class for each pair") {
    FrontView view;
    view.list.layers = {{"Edge ring"}};
    view.list.line({-0.8F, 0.0F, 0.0F}, {0.8F, 0.0F, 0.0F}, paletteOf(Theme::Dark).used, 0.1F);
    DrawList light = view.list;
    light.lines[0].color = paletteOf(Theme::Light).used;
    CHECK(view.drawn(&light) == view.drawn(&light));
    CHECK(view.drawn(&light).find("class=\"used-line\"") != std::string::npos);
}

TEST_CASE("Too many shapes are refused with the format to use instead") {
    FrontView view;
    view.list.layers = {{"Edge ring"}};
    for (std::size_t i = 0; i <= kMaxShapes; ++i)
        view.list.line({0, 0, 0}, {0.1F, 0, 0}, kRed, 0.1F, Depth::OnTop);
    SvgClasses classes(Theme::Dark, false);
    const FrameShapes shapes{view.list, nullptr, *view.model, {}, view.camera.matrices(1.0F)};
    CHECK(svgFrame(shapes, classes, "").error().message.ends_with("use .png"));
}
