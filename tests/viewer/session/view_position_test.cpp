#include "session/view_position.h"

#include <doctest/doctest.h>

#include "open_session.h"

using namespace se;
using namespace se::view;

TEST_CASE("A position is read back from its text") {
    Camera camera;
    camera.orbit({120.0F, -40.0F}, 600.0F);
    camera.toggleOrthographic();
    const ViewPosition place{"137.sphere.3", camera.pose()};
    const Result<ViewPosition> read = viewPositionFromText(toText(place));
    REQUIRE(read.ok());
    CHECK(read.value().address == place.address);
    CHECK(read.value().camera == place.camera);
    Camera other;
    other.setPose(*read.value().camera);
    CHECK(other.pose() == camera.pose());
    CHECK(other.matrices(1.5F).viewProjection() == camera.matrices(1.5F).viewProjection());
}

TEST_CASE("A bare address is a position without a camera, and anything else is refused") {
    const Result<ViewPosition> bare = viewPositionFromText("  20.sort.4\n");
    REQUIRE(bare.ok());
    CHECK(bare.value().address == "20.sort.4");
    CHECK_FALSE(bare.value().camera.has_value());
    for (
        const char* wrong :
        {"", "   ", "hello", "{}", "[1, 2]", R"({"address": 3})", R"({"address": "hello"})",
         R"({"address": "1", "camera": {}})",
         R"({"address": "1", "camera": {"target": [0, 0], "distance": 1, "yaw": 0, "pitch": 0}})",
         R"({"address": "1", "camera": {"target": [0, 0, 0], "distance": -1, "yaw": 0, "pitch": 0}})"}) {
        CAPTURE(std::string(wrong));
        CHECK_FALSE(viewPositionFromText(wrong).ok());
    }
}

TEST_CASE("A position with deep lists or a number beyond double is refused with its place") {
    const std::string deep = "{\"camera\": " + std::string(100000, '[');
    CHECK(viewPositionFromText(deep).error().message ==
          "The position: line 1, column 75: expected at most 64 levels of lists and objects");
    const Result<ViewPosition> huge = viewPositionFromText(
        R"({"address": "1", "camera": {"target": [0, 0, 1e400], "distance": 1}})");
    REQUIRE(!huge);
    CHECK(huge.error().message.starts_with("The position: line 1, column 46: \"camera.target\": "));
}

TEST_CASE("A session goes back to where a jump began, and forward again") {
    test::OpenSession open;
    open.session.moves().stepPivot(3);
    const std::string first = open.place();
    open.session.moves().goTo({40, Stage::Sphere, 2});
    const std::string second = open.place();
    open.session.moves().toEnd();
    open.place();
    open.session.moves().goBack();
    CHECK(open.place() == second);
    open.session.moves().goBack();
    CHECK(open.place() == first);
    open.session.moves().goForward();
    CHECK(open.place() == second);
}

TEST_CASE("A session goes from mark to mark, there and back the same ones") {
    test::OpenSession open("scene:linked-tori");
    open.place();
    const auto goToMark = [&](int direction) {
        const std::optional<Address> mark = open.session.nextMark(direction);
        if (mark) open.session.moves().goTo(*mark);
        return mark.has_value();
    };
    std::vector<std::string> there;
    while (goToMark(1)) {
        there.push_back(open.place());
        REQUIRE(there.size() < 1000);
        const Stage stage = open.session.address().stage;
        const bool isMark = stage == Stage::Seed || stage == Stage::Split || stage == Stage::Join ||
                            stage == Stage::Done;
        CHECK(isMark);
    }
    REQUIRE(there.size() > 3);
    for (std::size_t i = there.size() - 1; i > 0; --i) {
        REQUIRE(goToMark(-1));
        CHECK(open.place() == there[i - 1]);
    }
    CHECK_FALSE(goToMark(-1));
}

TEST_CASE("A jump to an alert lands on the alert, and not on an earlier event of its stage") {
    for (const char* scene : {"scene:torus", "scene:coarse-torus"}) {
        test::OpenSession open(scene);
        open.session.open(withSet({scene}, "printed"));
        open.session.waitUntilDone();
        std::size_t alerts = 0;
        for (const RunMark& mark : open.session.overview().marks) {
            if (mark.kind != MarkKind::Alert) continue;
            ++alerts;
            open.session.moves().goTo({mark.pivot, stageOf(mark.kind), mark.n});
            open.place();
            REQUIRE(open.session.event() != nullptr);
            CHECK(std::holds_alternative<AlertEvidence>(open.session.event()->evidence));
        }
        CHECK(alerts > 0);
    }
}

TEST_CASE("The axis that is up is part of a position, a position without it has z up") {
    Camera camera;
    camera.setUp(UpAxis::Y);
    const auto read = viewPositionFromText(toText(ViewPosition{"1", camera.pose()}));
    REQUIRE(read.ok());
    CHECK(read.value().camera->up == UpAxis::Y);
    const std::string old =
        R"({"address": "1", "camera": {"target": [0, 0, 0], "distance": 1, "yaw": 0, "pitch": 0)";
    const auto before = viewPositionFromText(old + "}}");
    REQUIRE(before.ok());
    CHECK(before.value().camera->up == UpAxis::Z);
    CHECK_FALSE(viewPositionFromText(old + R"(, "up": "w"}})").ok());
    CHECK_FALSE(viewPositionFromText(old + R"(, "up": 1}})").ok());
}
