#include "scene/camera.h"

#include <doctest/doctest.h>

using namespace se::view;

TEST_CASE("Marks on the mesh fade as points come close together on the screen") {
    CHECK(markStrength(3.0F) == 0.0F);
    CHECK(markStrength(40.0F) == 1.0F);
    float before = 0.0F;
    for (float pixels = 1.0F; pixels < 30.0F; pixels += 0.5F) {
        CHECK(markStrength(pixels) >= before);
        before = markStrength(pixels);
        // Dots of DONE points would cover a mesh that is shown beside solid dots.
        if (drawnSolid(pixels)) CHECK(markStrength(pixels) == 0.0F);
    }
}

TEST_CASE("The distance of points in pixels grows with the view and as the camera comes closer") {
    Camera camera;
    const float far = spacingInPixels(camera.matrices(1.0F), 600.0F, 0.01F);
    CHECK(spacingInPixels(camera.matrices(1.0F), 1200.0F, 0.01F) == doctest::Approx(2.0F * far));
    camera.zoomAt(3.0F, {0.0F, 0.0F}, 1.0F);
    CHECK(spacingInPixels(camera.matrices(1.0F), 600.0F, 0.01F) > far);
}
