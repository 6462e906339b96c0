/// What-ifs in the stepper: overrides of single decisions by the user (what_if.h).
#include <algorithm>

#include "spiraling_edge/stepper/step_context.h"

namespace se {
namespace {

/// Sorts the lists with a moved point, and its own, nearest first.
void sortLists(PointSet& points, Index moved) {
    for (Index p = 0; p < points.size(); ++p) {
        const auto begin = points.neighbors.ids.begin();
        const auto from = begin + points.neighbors.offset[p];
        const auto to = begin + points.neighbors.offset[p + 1];
        if (p != moved && std::find(from, to, moved) == to) continue;
        const auto distance = [&](Index q) {
            const Vec3 d = points.position[q] - points.position[p];
            return glm::dot(d, d);
        };
        std::stable_sort(from, to, [&](Index a, Index b) { return distance(a) < distance(b); });
    }
}

void replaceList(PointSet& points, Index p, const std::vector<Index>& list) {
    NeighborLists made;
    made.offset.reserve(points.neighbors.offset.size());
    for (Index q = 0; q < points.size(); ++q) {
        made.append(q == p ? std::span<const Index>(list) : points.neighbors[q]);
    }
    points.neighbors = std::move(made);
    sortLists(points, p);
}

/// True if a what-if can edit the points. Others are skipped; checkWhatIfs() reports them.
bool edits(const WhatIf& what, std::size_t count) {
    if (what.point >= count) return false;
    if (what.kind == WhatIfKind::Move) return true;
    return what.kind == WhatIfKind::List &&
           std::all_of(what.list.begin(), what.list.end(),
                       [&](Index q) { return q < count && q != what.point; });
}

}  // namespace

std::optional<bool> findWhatIfOverride(const StepContext& context, Stage stage, Index point) {
    for (const WhatIf& each : context.params.whatIf) {
        const bool here = each.pivot == context.state.counters.pivots && each.stage == stage;
        if (!here || each.point != point) continue;
        if (each.kind == WhatIfKind::Keep) return true;
        if (each.kind == WhatIfKind::Drop) return false;
    }
    return std::nullopt;
}

void redirect(LoggedContext& context) {
    State& s = context.state;
    if (s.phase != Phase::Pivot) return;
    for (const WhatIf& each : context.params.whatIf) {
        if (each.kind != WhatIfKind::Pivot || each.pivot != s.counters.pivots) continue;
        if (each.point >= s.status.size()) continue;
        const Index entry = s.rings.firstInstance(each.point, kNone);
        if (entry == kNone) continue;
        const Index active = s.rings.active();
        const Index ring = s.rings.ringOf(entry);
        if (ring != active) {
            s.rings.activate(ring);
            s.rings.push(active, s.pivot.pivot);
        }
        // A new circuit begins here.
        s.circuit = 0;
        s.retryLevel = 0;
        s.pivot.pivot = entry;
        note(context, Stage::Advance, [&] { return AdvanceEvidence{each.point, 0, false, true}; });
    }
}

std::vector<EditedPoints> editedPoints(const PointSet& points, const Params& params) {
    std::vector<const WhatIf*> list;
    for (const WhatIf& each : params.whatIf) {
        if (edits(each, points.size())) list.push_back(&each);
    }
    std::stable_sort(list.begin(), list.end(),
                     [](const WhatIf* a, const WhatIf* b) { return a->pivot < b->pivot; });
    std::vector<EditedPoints> made;
    for (const WhatIf* each : list) {
        if (made.empty() || made.back().from != each->pivot) {
            EditedPoints next{each->pivot, made.empty() ? points : made.back().points};
            made.push_back(std::move(next));
        }
        PointSet& set = made.back().points;
        if (each->kind == WhatIfKind::Move) {
            set.position[each->point] = each->to;
            sortLists(set, each->point);
        } else {
            replaceList(set, each->point, each->list);
        }
    }
    return made;
}

}  // namespace se
