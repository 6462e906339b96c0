#include "view_position.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "run/strings.h"
#include "spiraling_edge/stepper/event.h"
#include "teach/json_text.h"

namespace se::view {

namespace {

using nlohmann::json;

/// Throws json::exception if the value is no number that a float can hold.
float floatFrom(const json& value) {
    const double number = value.get<double>();
    if (!(std::abs(number) <= std::numeric_limits<float>::max()))
        throw json::out_of_range::create(406, "exceeds the range of a float", &value);
    return static_cast<float>(number);
}

std::optional<CameraPose> poseFrom(const json& object) {
    CameraPose pose;
    try {
        const json& target = object.at("target");
        for (int i = 0; i < 3; ++i)
            pose.target[i] = floatFrom(target.at(static_cast<std::size_t>(i)));
        pose.distance = floatFrom(object.at("distance"));
        pose.yawDegrees = floatFrom(object.at("yaw"));
        pose.pitchDegrees = floatFrom(object.at("pitch"));
        pose.orthographic = object.value("orthographic", false);
        // Positions written before the choice existed have none: they had z up.
        const auto up = upAxisFromName(object.value("up", "z"));
        if (!up) return std::nullopt;
        pose.up = *up;
    } catch (const json::exception&) {
        return std::nullopt;
    }
    const float sum = pose.target.x + pose.target.y + pose.target.z + pose.distance +
                      pose.yawDegrees + pose.pitchDegrees;
    if (!std::isfinite(sum) || pose.distance <= 0.0F) return std::nullopt;
    return pose;
}

}  // namespace

std::string toText(const ViewPosition& place) {
    json object{{"address", place.address}};
    if (place.camera) {
        const CameraPose& c = *place.camera;
        object["camera"] = {{"target", {c.target.x, c.target.y, c.target.z}},
                            {"distance", c.distance},
                            {"yaw", c.yawDegrees},
                            {"pitch", c.pitchDegrees},
                            {"orthographic", c.orthographic},
                            {"up", upAxisName(c.up)}};
    }
    return object.dump();
}

Result<ViewPosition> viewPositionFromText(std::string_view text) {
    const Error unknown{
        "Not a position. Expected an address such as 137.sphere.3, or a link copied by Ctrl+C."};
    const Result<json> read = teach::jsonFromText<json>(text, "The position");
    if (!read && text.find('{') != std::string_view::npos) return read.error();
    if (!read || !read.value().is_object()) {
        const std::string address = trimmed(text, kBlanks);
        if (!addressFromString(address)) return unknown;
        return ViewPosition{address, std::nullopt};
    }
    const json& object = read.value();
    const auto address = object.find("address");
    if (address == object.end() || !address->is_string()) return unknown;
    ViewPosition place{address->get<std::string>(), std::nullopt};
    if (!place.address.empty() && !addressFromString(place.address)) return unknown;
    if (const auto camera = object.find("camera"); camera != object.end()) {
        place.camera = poseFrom(*camera);
        if (!place.camera) return Error{"The camera of this position cannot be read."};
    }
    return place;
}

std::optional<std::size_t> LinePosition::step(int direction, std::size_t count) const {
    if (direction < 0) return before > 0 ? std::optional(before - 1) : std::nullopt;
    const std::size_t next = before + (here ? 1 : 0);
    return next < count ? std::optional(next) : std::nullopt;
}

LinePosition positionAmong(std::span<const LedgerLine> lines, const Session& session) {
    assert(session.ready());
    const PivotRecord& record = session.record();
    // Within a pivot the stages do not always come in one order, so its events are searched.
    const auto isBefore = [&](const LedgerLine& line) {
        const Address& address = line.event.address;
        if (address.pivot != record.pivot) return address.pivot < record.pivot;
        const auto place = record.find(address);
        return session.event() != nullptr && place && *place < session.cursor();
    };
    LinePosition place;
    const auto first = std::partition_point(lines.begin(), lines.end(), isBefore);
    place.before = static_cast<std::size_t>(first - lines.begin());
    const bool here = first != lines.end() && session.event() != nullptr &&
                      first->event.address == session.address();
    if (here) place.here = place.before;
    return place;
}

}  // namespace se::view
