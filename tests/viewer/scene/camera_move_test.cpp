#include "scene/motion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace se::view;

namespace {

CameraPose poseAt(float yaw, float pitch, float distance) {
    CameraPose pose;
    pose.yawDegrees = yaw;
    pose.pitchDegrees = pitch;
    pose.distance = distance;
    return pose;
}

}  // namespace

TEST_CASE("A move begins and ends at its poses, and turns the shorter way") {
    const CameraPose from = poseAt(170.0F, 10.0F, 1.0F);
    const CameraPose to = poseAt(-170.0F, 30.0F, 4.0F);
    CHECK(poseBetween(from, to, 0.0).yawDegrees == doctest::Approx(170.0F));
    CHECK(poseBetween(from, to, 1.0) == to);
    const CameraPose middle = poseBetween(from, to, 0.5);
    CHECK(middle.yawDegrees == doctest::Approx(180.0F));
    CHECK(middle.pitchDegrees == doctest::Approx(20.0F));
    CHECK(middle.distance == doctest::Approx(2.0F));
}

TEST_CASE("A swing is 20 degrees wide and ends where it began") {
    for (const float pitch : {10.0F, 85.0F, -88.0F}) {
        CAPTURE(pitch);
        const CameraPose pose = poseAt(40.0F, pitch, 1.0F);
        CHECK(swungPose(pose, 0.0) == pose);
        CHECK(swungPose(pose, 1.0) == pose);
        float low = 0.0F;
        float high = 0.0F;
        for (double share = 0.0; share < 1.0; share += 0.01) {
            const CameraPose swung = swungPose(pose, share);
            const float turn =
                swung.yawDegrees - pose.yawDegrees + swung.pitchDegrees - pose.pitchDegrees;
            low = std::min(low, turn);
            high = std::max(high, turn);
            CHECK(std::abs(swung.pitchDegrees) <= 90.0F);
        }
        CHECK(high - low == doctest::Approx(20.0F).epsilon(0.01));
    }
}

TEST_CASE("A move begins with its first frame and ends after its time") {
    Camera camera;
    const CameraPose from = camera.pose();
    CameraPose to = from;
    to.distance = 0.5F;
    CameraMove move;
    move.begin(camera, to, CameraMove::Kind::Requested);
    CHECK(move.active());
    // However long the window stood still before.
    move.apply(camera, 1000.0);
    CHECK(camera.pose().distance == doctest::Approx(from.distance));
    move.apply(camera, 1000.0 + 0.5 * kMoveSeconds);
    CHECK(camera.pose().distance < from.distance);
    CHECK(camera.pose().distance > to.distance);
    move.apply(camera, 1000.01 + kMoveSeconds);
    CHECK(camera.pose() == to);
    CHECK_FALSE(move.active());
}

TEST_CASE("A camera that is moved by something else ends the move and stays") {
    Camera camera;
    CameraPose to = camera.pose();
    to.distance = 0.5F;
    CameraMove move;
    move.begin(camera, to, CameraMove::Kind::Followed);
    move.apply(camera, 0.0);
    camera.orbit({10.0F, 0.0F}, 100.0F);
    const CameraPose turned = camera.pose();
    move.apply(camera, 0.2);
    CHECK_FALSE(move.active());
    CHECK(camera.pose() == turned);
}

TEST_CASE("A second request stops a swing where it began") {
    Camera camera;
    const CameraPose pose = camera.pose();
    CameraMove move;
    move.swing(camera);
    move.apply(camera, 0.0);
    move.apply(camera, 0.4);
    CHECK_FALSE(camera.pose() == pose);
    move.swing(camera);
    CHECK_FALSE(move.active());
    CHECK(camera.pose() == pose);
}
