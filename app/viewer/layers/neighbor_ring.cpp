#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "layer.h"

namespace se::view {

namespace {

/// The frame of §6.1 at the pivot, in view space: angle 0 toward first, counterclockwise.
struct PivotFrame {
    glm::vec3 origin{0.0F};
    glm::vec3 normal{0.0F};
    glm::vec3 zero{0.0F};
    glm::vec3 quarter{0.0F};

    glm::vec3 at(float degrees, float radius) const {
        const float angle = glm::radians(degrees);
        return origin + radius * (std::cos(angle) * zero + std::sin(angle) * quarter);
    }
};

std::optional<PivotFrame> frameOf(const LayerInput& in) {
    if (in.picture.pivot == kNone || in.picture.first == kNone) return std::nullopt;
    PivotFrame frame;
    frame.origin = in.at(in.picture.pivot);
    frame.normal = in.model.normal[in.picture.pivot];
    const glm::vec3 toFirst = in.at(in.picture.first) - frame.origin;
    const glm::vec3 flat = toFirst - frame.normal * glm::dot(toFirst, frame.normal);
    if (glm::length(flat) < 1e-9F) return std::nullopt;
    frame.zero = glm::normalize(flat);
    frame.quarter = glm::cross(frame.normal, frame.zero);
    return frame;
}

void addSpoke(const LayerInput& in, const CandidateMark& mark, DrawList& out) {
    const bool rejected = mark.state == CandidateState::Rejected;
    Line line;
    line.from = in.at(in.picture.pivot);
    line.to = in.at(mark.point);
    line.color = rejected ? in.palette.rejected.withAlpha(0.75F) : in.palette.used;
    line.width = rejected ? 0.06F : 0.09F;
    line.dash = rejected ? 0.3F : 0.0F;
    line.depth = Depth::OnTop;
    if (mark.point == in.picture.underTest) line.width = 0.16F;
    if (mark.point == in.picture.underTest && !rejected) line.color = in.palette.test;
    out.lines.push_back(line);
}

void addMark(const LayerInput& in, Index point, Shape shape, const Color& color, float size,
             DrawList& out) {
    if (point == kNone) return;
    out.sprites.push_back({in.at(point), {color, size, shape}});
}

void addCandidates(const LayerInput& in, DrawList& out) {
    for (const CandidateMark& mark : in.picture.candidates) {
        addSpoke(in, mark, out);
        const bool rejected = mark.state == CandidateState::Rejected;
        addMark(in, mark.point, rejected ? Shape::Cross : Shape::Disc,
                rejected ? in.palette.rejected : in.palette.used, rejected ? 0.72F : 0.62F, out);
    }
}

void addEnds(const LayerInput& in, DrawList& out) {
    const Picture& p = in.picture;
    const auto spoke = [&](Index point, const Color& color, float width) {
        if (point != kNone) {
            out.line(in.at(p.pivot), in.at(point), color, width, Depth::OnTop);
        }
    };
    spoke(p.first, in.palette.first, 0.12F);
    if (p.last != p.first) spoke(p.last, in.palette.last, 0.12F);
    if (p.start != p.first) spoke(p.start, in.palette.first, 0.12F);
    if (p.end != p.last) spoke(p.end, in.palette.last, 0.12F);
    if (p.start != p.first) addMark(in, p.first, Shape::Forward, in.palette.first, 0.7F, out);
    if (p.end != p.last) addMark(in, p.last, Shape::Back, in.palette.last, 0.7F, out);
    addMark(in, p.end, Shape::Back, in.palette.last, 1.0F, out);
    addMark(in, p.start, Shape::Forward, in.palette.first, 1.0F, out);
}

void addNext(const LayerInput& in, DrawList& out) {
    const Picture& p = in.picture;
    if (p.nextPivot == kNone || p.nextPivot == p.pivot) return;
    Line line;
    line.from = in.at(p.pivot);
    line.to = in.at(p.nextPivot);
    line.color = in.palette.pivot;
    line.width = 0.1F;
    line.arrow = 0.7F;
    line.depth = Depth::OnTop;
    out.lines.push_back(line);
}

}  // namespace

void addSector(const LayerInput& in, DrawList& out) {
    const std::optional<PivotFrame> frame = frameOf(in);
    if (!frame) return;
    const float radius = 0.62F * in.model.spacing;
    const auto from = static_cast<float>(in.picture.startDegrees);
    const auto to = static_cast<float>(std::max(in.picture.endDegrees, in.picture.startDegrees));
    const int parts = std::max(1, static_cast<int>((to - from) / 8.0F));
    for (int i = 0; i < parts; ++i) {
        const float a = from + (to - from) * static_cast<float>(i) / static_cast<float>(parts);
        const float b = from + (to - from) * static_cast<float>(i + 1) / static_cast<float>(parts);
        out.sheets.push_back({{frame->origin, frame->at(a, radius), frame->at(b, radius)},
                              in.palette.pivot.withAlpha(0.16F),
                              false});
        out.line(frame->at(a, radius), frame->at(b, radius), in.palette.pivot.withAlpha(0.8F),
                 0.06F, Depth::OnTop);
    }
    out.line(frame->origin, frame->origin + frame->normal * in.model.spacing,
             in.palette.pivot.withAlpha(0.8F), 0.08F, Depth::XRay);
}

void addNeighborRing(const LayerInput& in, DrawList& out) {
    const Picture& p = in.picture;
    if (p.pivot == kNone) {
        // Mended, or stranded.
        const bool mended = p.mended != nullptr;
        addMark(in, p.underTest, mended ? Shape::RingedDisc : Shape::Cross,
                mended ? in.palette.test : in.palette.rejected, 0.9F, out);
        return;
    }
    // Once the pivot is complete its tests are history: only the result stays.
    if (!p.complete) addCandidates(in, out);
    if (!p.complete) addEnds(in, out);
    if (p.complete) addNext(in, out);
    if (!p.complete && p.underTest != p.pivot) {
        addMark(in, p.underTest, Shape::RingedDisc, in.palette.test, 1.0F, out);
    }
    for (const CandidateMark& mark : p.candidates) {
        const bool rejected = mark.state == CandidateState::Rejected;
        if (p.complete || mark.point != p.underTest || !rejected) continue;
        addMark(in, mark.point, Shape::Cross, in.palette.rejected, 1.0F, out);
    }
    addMark(in, p.pivot, Shape::RingedDisc, in.palette.pivot, 1.15F, out);
}

}  // namespace se::view
