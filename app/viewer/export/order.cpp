#include "order.h"

#include <algorithm>
#include <set>
#include <variant>

#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/run/run_cursor.h"
#include "spiraling_edge/stepper/event.h"
#include "teach/lesson_runs.h"

namespace se::view {

namespace {

/// Adds the numbers of "4" or "4-6".
bool addSteps(std::string_view part, std::size_t count, std::vector<std::size_t>& steps) {
    const std::size_t dash = part.find('-');
    const auto first = numberIn<std::size_t>(part.substr(0, dash));
    const auto last =
        dash == std::string_view::npos ? first : numberIn<std::size_t>(part.substr(dash + 1));
    if (!first || !last || *first < 1 || *last < *first || *last > count) return false;
    for (std::size_t step = *first; step <= *last; ++step) steps.push_back(step);
    return true;
}

}  // namespace

Status checkViewerAddress(const std::string& address) {
    const std::string scheme = address.substr(0, address.find_first_of(":/"));
    const bool known = scheme == "http" || scheme == "https" || scheme == "file";
    const bool relative = scheme.size() == address.size() || address[scheme.size()] == '/';
    const bool plain = std::all_of(address.begin(), address.end(), [](char sign) {
        return sign > ' ' && sign != '\x7f' &&
               std::string_view("\"'<>#").find(sign) == std::string_view::npos;
    });
    if (plain && (known || relative)) return success();
    return Error{address +
                 ": expected the address of a page by http, https or file, or a path relative to "
                 "the new page, without spaces, quotes, < > and #"};
}

std::optional<glm::ivec2> pictureSize(const std::string& text) {
    glm::ivec2 size(0);
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest) != 2) return std::nullopt;
    if (size.x < 320 || size.y < 240 || std::max(size.x, size.y) > kMostPixels) return std::nullopt;
    if (static_cast<double>(size.x) * size.y > kMostArea) return std::nullopt;
    return size;
}

Result<FrameRange> rangeAround(const std::string& address) {
    const auto at = addressFromString(address);
    if (!at) return Error{address + ": expected a pivot or an address such as 9.sphere.2"};
    const std::string pivot = std::to_string(at->pivot);
    return FrameRange{pivot, pivot, PlayUnit::SubStep};
}

Result<std::vector<std::size_t>> stepsFromText(std::string_view text, std::size_t count) {
    std::vector<std::size_t> steps;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        if (!addSteps(text.substr(at, comma - at), count, steps)) {
            return Error{std::string(text) + ": expected steps from 1 to " + std::to_string(count) +
                         ", such as 2,4-6"};
        }
        at = comma + 1;
    }
    sortUnique(steps);
    return steps;
}

namespace {

/// Whether the frame of this event is one of the range.
bool isFrame(const RunCursor& cursor, PlayUnit unit) {
    const Event* event = cursor.event();
    if (event == nullptr || unit == PlayUnit::SubStep) return true;
    if (unit == PlayUnit::Pivot) return event == &cursor.pivot().events.back();
    const Stage stage = event->address.stage;
    return stage == Stage::Seed || stage == Stage::Split || stage == Stage::Join ||
           std::holds_alternative<AlertEvidence>(event->evidence);
}

/// A position without a stage ends with its pivot.
Status goToLast(RunCursor& cursor, const std::string& place) {
    const Status moved = teach::goToPlace(cursor, place);
    if (moved && place.find_first_not_of("0123456789") == std::string::npos && place != "0")
        cursor.goTo(cursor.pivot().events.back().address);
    return moved;
}

/// Adds the points that a decision is about.
void addPointsOf(const DecisionState& state, std::set<Index>& points) {
    points.insert({state.pivot, state.first, state.last, state.start, state.end, state.nextPivot,
                   state.underTest});
    for (const CandidateMark& each : state.candidates) points.insert(each.point);
    for (const Triangle& t : state.newTriangles) points.insert({t.a, t.b, t.c});
}

}  // namespace

Result<FramePlan> planFrames(const Model& model, const FrameRange& range) {
    RunCursor cursor(model.points, model.params);
    if (const Status moved = goToLast(cursor, range.to); !moved) return moved.error();
    const bool toStart = cursor.event() == nullptr;
    const Address last = toStart ? Address{} : cursor.event()->address;
    if (const Status moved = teach::goToPlace(cursor, range.from); !moved) return moved.error();
    FramePlan plan;
    std::set<Index> points;
    std::set<Index> pivots;
    for (;;) {
        const Event* event = cursor.event();
        if (isFrame(cursor, range.unit)) {
            if (plan.places.size() == kMaxFrames)
                return Error{"over " + std::to_string(kMaxFrames) +
                             " frames; choose a shorter range, or --unit pivot"};
            plan.places.push_back(event != nullptr ? toString(event->address) : "");
            addPointsOf(cursor.state(), points);
            pivots.insert(cursor.state().pivot);
        }
        const bool there = event == nullptr ? toStart : event->address == last;
        if (there) break;
        if (!cursor.forward()) return Error{range.to + " is before " + range.from};
    }
    if (plan.places.empty())
        return Error{"there is no split, join, seed or alert from " + range.from + " to " +
                     range.to};
    for (std::set<Index>* each : {&points, &pivots}) each->erase(kNone);
    plan.points.assign(points.begin(), points.end());
    plan.pivots.assign(pivots.begin(), pivots.end());
    return plan;
}

}  // namespace se::view
