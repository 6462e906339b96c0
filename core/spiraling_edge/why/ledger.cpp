/// The ledger by re-running: one run with a log of one pivot at a time, none of pivots that can
/// name no point of the subject. Only the lines about the subject are kept: tests between its
/// points, tests that end a fan it would have been in, and facts about its points. For this the
/// points of the subject that may still become spokes of the current fan are tracked. O(run), with
/// memory for the answer alone.
#include "spiraling_edge/why/ledger.h"

#include <algorithm>
#include <bitset>
#include <functional>
#include <memory>
#include <utility>

#include "spiraling_edge/base/overloaded.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/prepare/neighbor_search.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/run/sweep.h"
#include "spiraling_edge/stepper/event.h"
#include "spiraling_edge/stepper/robust/repair_sides.h"
#include "spiraling_edge/why/origin_decisions.h"

namespace se {

std::size_t Subject::find(Index p) const {
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(size_);
    return static_cast<std::size_t>(std::find(points_.begin(), end, p) - points_.begin());
}

std::string nameOf(const Subject& subject) {
    const auto name = [&](std::size_t i) { return std::to_string(subject[i]); };
    if (subject.size() == 1) return "point " + name(0);
    if (subject.size() == 2) return "edge " + name(0) + "-" + name(1);
    return "triangle (" + name(0) + ", " + name(1) + ", " + name(2) + ")";
}

namespace {

std::size_t countIn(const Subject& subject, std::initializer_list<Index> points) {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](Index p) { return subject.has(p); }));
}

bool holds(const Triangle& t, const Subject& subject) {
    return countIn(subject, {t.a, t.b, t.c}) == subject.size();
}

}  // namespace

bool isInMesh(std::span<const Triangle> mesh, const Subject& subject) {
    return std::any_of(mesh.begin(), mesh.end(),
                       [&](const Triangle& t) { return holds(t, subject); });
}

namespace {

/// True if the mesh under repair has the subject; called after each step. O(triangles at a point),
/// O(triangles) at a pinched one.
bool isInMesh(const RepairState& repair, const Subject& subject) {
    const Index p = subject[0];
    const std::vector<Triangle>& triangles = repair.triangles;
    if (repair.pinched[p]) return isInMesh(triangles, subject);
    bool found = false;
    forEachSideOf(repair, p,
                  [&](HalfEdge side) { found = found || holds(triangles[side / 3], subject); });
    return found;
}

constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

/// The cause for which a subject is not in the mesh.
struct Cause {
    std::size_t line = kNoLine;
    std::string words = {};  ///< One sentence, without the address.
    ProvedBy provedBy = ProvedBy::Nothing;
};

class CauseFinder {
  public:
    CauseFinder(const PointSet& points, const Subject& subject, const Ledger& ledger,
                const State& end)
        : points_(points), subject_(subject), ledger_(ledger), end_(end) {}

    Cause find() const {
        const std::size_t undone =
            last([](const LedgerLine& line) { return line.role == LineRole::Undone; });
        if (ledger_.present) {
            std::size_t made = undone == kNoLine ? 0 : undone + 1;
            while (ledger_.lines[made].role != LineRole::Made) ++made;
            const bool byStep = editsMesh(ledger_.lines[made].event);
            return causeAt(made, byStep ? ProvedBy::Step : ProvedBy::Nothing);
        }
        if (undone != kNoLine) return causeAt(undone, ProvedBy::Step);
        if (subject_.size() == 3) return ofTriangle();
        return ofPoints(subject_);
    }

  private:
    using Test = std::function<bool(const LedgerLine&)>;

    std::size_t last(const Test& test) const {
        for (std::size_t i = ledger_.lines.size(); i-- > 0;) {
            if (test(ledger_.lines[i])) return i;
        }
        return kNoLine;
    }
    Cause causeAt(std::size_t line, ProvedBy by = ProvedBy::Nothing) const {
        return {line, describe(ledger_.lines[line].event), by};
    }

    /// True if another entry of the point passed the reciprocal test: then the refused one is no
    /// cause.
    bool hasOtherEntry(const LedgerLine& refused) const {
        if (refused.event.address.stage != Stage::Reciprocal) return false;
        return std::any_of(ledger_.lines.begin(), ledger_.lines.end(), [&](const LedgerLine& line) {
            return line.role == LineRole::Taken &&
                   line.event.address.pivot == refused.event.address.pivot &&
                   line.event.address.stage == Stage::Reciprocal &&
                   testedPoint(line.event) == testedPoint(refused.event);
        });
    }
    Cause ofPoints(const Subject& subject) const {
        const auto refused = [&](const LedgerLine& line) {
            const Index tested = testedPoint(line.event);
            const bool concerned = (tested == kNone || subject.has(tested)) &&
                                   (subject.size() == 1 || subject.has(line.pivot));
            // A limit that does not move refuses nothing.
            return line.role == LineRole::Refused && concerned && !isA<LimitEvidence>(line.event) &&
                   !hasOtherEntry(line);
        };
        std::size_t line = last(
            [&](const LedgerLine& each) { return refused(each) && !wasSettledBefore(each.event); });
        if (line == kNoLine) line = last(refused);
        if (line != kNoLine) return causeAt(line);
        return subject.size() == 1 ? untestedPoint(subject[0]) : untestedEdge(subject);
    }

    bool wasPivot(Index p) const {
        return last([&](const LedgerLine& line) {
                   const auto* pivot = as<PivotEvidence>(line.event);
                   return pivot != nullptr && pivot->pivot == p;
               }) != kNoLine;
    }
    /// The last line that names one of the points.
    std::size_t lastAbout(const Subject& subject) const {
        const std::size_t about = last([&](const LedgerLine& line) {
            return subject.has(testedPoint(line.event)) || subject.has(line.pivot);
        });
        return about != kNoLine ? about : ledger_.lines.size() - 1;
    }

    Cause untestedPoint(Index p) const {
        if (points_.isAside(p))
            return {lastAbout(subject_), asideText(points_, p), ProvedBy::Preparation};
        std::size_t listing = 0;
        for (std::size_t q = 0; q < points_.size(); ++q) {
            if (points_.neighbors.has(static_cast<Index>(q), p)) ++listing;
        }
        const std::string words =
            listing == 0
                ? "No point lists " + std::to_string(p) +
                      " among its neighbors, so no pivot ever tested it" + oppositionTo(p) + "."
                : "Point " + std::to_string(p) + " is listed by " + std::to_string(listing) +
                      (listing == 1 ? " point" : " points") +
                      ", but none of them was a pivot that looked at it.";
        return {lastAbout(subject_), words,
                listing == 0 ? ProvedBy::Preparation : ProvedBy::Nothing};
    }

    /// The reason for an empty list, as the end of a sentence; empty if there is none.
    std::string oppositionTo(Index p) const {
        constexpr std::size_t kNearby = 160;
        if (!points_.neighbors[p].empty() || points_.normal.empty()) return {};
        std::vector<std::pair<double, Index>> near;
        for (Index q = 0; q < points_.size(); ++q) {
            if (q == p || points_.isAside(q)) continue;
            const Vec3 way = points_.position[q] - points_.position[p];
            near.emplace_back(glm::dot(way, way), q);
        }
        const std::size_t count = std::min(near.size(), kNearby);
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count),
                          near.end());
        const bool opposed = std::all_of(
            near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), [&](const auto& each) {
                return normalsOppose(points_.normal[p], points_.normal[each.second], kRightAngle);
            });
        if (count == 0 || !opposed) return {};
        return ": its normal opposes those of the " + std::to_string(count) +
               " points nearest to it";
    }

    /// The cause where neither end ever tested the other.
    Cause untestedEdge(const Subject& edge) const {
        const std::size_t line = lastAbout(edge);
        for (const Index end : edge.points()) {
            if (points_.isAside(end))
                return {lastAbout(Subject::point(end)), asideText(points_, end),
                        ProvedBy::Preparation};
        }
        const std::string a = std::to_string(edge[0]);
        const std::string b = std::to_string(edge[1]);
        const bool ab = points_.neighbors.has(edge[0], edge[1]);
        const bool ba = points_.neighbors.has(edge[1], edge[0]);
        if (!ab && !ba) {
            return {line, "Neither of " + a + " and " + b +
                              " lists the other among its neighbors, so no pivot ever tested them "
                              "together."};
        }
        std::string words;
        const auto add = [&](Index from, const std::string& name, const std::string& other) {
            words += name + " lists " + other + ", but " +
                     (wasPivot(from) ? "looked at no neighbor when it was the pivot"
                                     : "was never a pivot") +
                     ". ";
        };
        if (ab) add(edge[0], a, b);
        if (ba) add(edge[1], b, a);
        words.pop_back();
        return {line, words};
    }

    Cause ofTriangle() const {
        const Subject& s = subject_;
        Cause latest;
        for (std::size_t i = 0; i < 3; ++i) {
            const Subject edge = Subject::edge(s[i], s[(i + 1) % 3]);
            if (isInMesh(end_.mesh(), edge)) continue;
            const Cause cause = ofPoints(edge);
            const bool prepared = cause.provedBy == ProvedBy::Preparation;
            if (!prepared && latest.line != kNoLine && cause.line <= latest.line) continue;
            latest = {cause.line, "Its " + nameOf(edge) + " is not in the mesh: " + cause.words,
                      cause.provedBy};
            if (prepared) break;
        }
        return latest.line != kNoLine ? latest : allEdgesTaken();
    }

    /// The cause where all three edges are in the mesh: the other triangles at them came first.
    Cause allEdgesTaken() const {
        const std::size_t emit =
            last([](const LedgerLine& line) { return isA<EmitEvidence>(line.event); });
        if (emit == kNoLine)
            return {lastAbout(subject_), "Its three edges came into the mesh one by one."};
        return {emit,
                "Its three edges are in the mesh, each in other triangles; the last of them: " +
                    describe(ledger_.lines[emit].event)};
    }

    const PointSet& points_;
    const Subject& subject_;
    const Ledger& ledger_;
    const State& end_;
};

/// The gaps of a neighbor ring that the triangles with the subject fill, by the angles at the
/// pivot: candidates in them were removed, or the triangles would be others.
class FilledGaps {
  public:
    /// `events`: of one pivot.
    FilledGaps(std::span<const Event> events, const Subject& subject) {
        if (subject.size() == 1) return;
        const bool fills = std::any_of(events.begin(), events.end(), [&](const Event& event) {
            const auto* emit = as<EmitEvidence>(event);
            return emit != nullptr && holds(emit->corners, subject);
        });
        if (!fills) return;
        for (const Event& event : events) {
            const auto* pivot = as<PivotEvidence>(event);
            const auto* sort = as<SortEvidence>(event);
            const auto* emit = as<EmitEvidence>(event);
            const auto* insert = as<InsertEvidence>(event);
            if (pivot != nullptr) {
                angles_ = {{pivot->last, pivot->sectorDegrees}, {pivot->first, 0.0}};
            } else if (insert != nullptr) {
                angles_.front().second = insert->sectorDegrees;
                if (insert->third != kNone)
                    angles_[insert->verdict == Verdict::Before ? 1 : 0].first = insert->third;
            } else if (sort != nullptr && !wasSettledBefore(event)) {
                angles_.emplace_back(sort->point, sort->degrees);
            } else if (emit != nullptr && holds(emit->corners, subject)) {
                addGap(emit->corners);
            }
        }
    }

    /// True for a test that removed a candidate in a gap, or let first and last make the triangle
    /// alone (§6.4).
    bool isClearedBy(const Event& event) const {
        if (gaps_.empty()) return false;
        if (isA<TwoPointEvidence>(event)) return outcomeOf(event) == Outcome::Taken;
        if (!isAgainst(outcomeOf(event)) || isA<LimitEvidence>(event)) return false;
        const auto angles = anglesOf(testedPoint(event));
        return !angles.empty() && std::any_of(gaps_.begin(), gaps_.end(), [&](const auto& gap) {
            return gap.first < angles.front() && angles.front() < gap.second;
        });
    }

  private:
    /// The angles of a point: two on a ring of two, where first and last are one point.
    std::vector<double> anglesOf(Index p) const {
        std::vector<double> found;
        for (const auto& [point, angle] : angles_) {
            if (point == p) found.push_back(angle);
        }
        return found;
    }
    /// Adds the narrowest gap between two corners.
    void addGap(const Triangle& made) {
        std::optional<std::pair<double, double>> least;
        for (const auto& [p, q] :
             {std::pair(made.a, made.b), std::pair(made.b, made.c), std::pair(made.c, made.a)}) {
            for (const double a : anglesOf(p)) {
                for (const double b : anglesOf(q)) {
                    const auto gap = std::minmax(a, b);
                    if (!least || gap.second - gap.first < least->second - least->first)
                        least = std::pair(gap.first, gap.second);
                }
            }
        }
        if (least) gaps_.push_back(*least);
    }

    std::vector<std::pair<Index, double>> angles_;
    std::vector<std::pair<double, double>> gaps_;
};

/// Collects, pivot by pivot, the lines of a ledger; then finds the deciding one.
class LedgerBuilder {
  public:
    LedgerBuilder(const PointSet& points, const Params& params, const Subject& subject)
        : points_(points),
          params_(params),
          subject_(subject),
          ledger_{nameOf(subject)},
          gaps_({}, subject) {}

    void add(const SweptPivot& pivot) {
        alive_.reset();
        reciprocal_ = kNone;
        moves_.clear();
        gaps_ = FilledGaps(pivot.events, subject_);
        for (const Event& event : pivot.events) {
            follow(event);
            addEvent(pivot, event);
        }
    }
    const std::vector<LedgerLine>& lines() const { return ledger_.lines; }
    /// The reason why there is no deciding line: the subject is one of a given start.
    std::optional<Error> withoutDecision(const State& end) const {
        const auto isMade = [](const LedgerLine& line) { return line.role == LineRole::Made; };
        const auto& lines = ledger_.lines;
        const bool made = std::any_of(lines.begin(), lines.end(), isMade);
        if (!lines.empty() && (made || !isInMesh(end.mesh(), subject_))) return {};
        return Error{capitalized(nameOf(subject_)) +
                     (isInMesh(params_.start.triangles, subject_)
                          ? " is in the mesh that the run begins with: no decision made it."
                          : " is in no decision of the run, which begins with a given mesh.")};
    }
    /// Finds the deciding line. Call it after the last pivot was added, with the state there.
    Ledger finish(const State& end) {
        ledger_.present = isInMesh(end.mesh(), subject_);
        const Cause cause = CauseFinder(points_, subject_, ledger_, end).find();
        ledger_.cause = cause.line;
        ledger_.words = cause.words;
        ledger_.provedBy = cause.provedBy;
        ledger_.answer = answerText(ledger_);
        return ledger_;
    }

  private:
    /// Tracks the points of the subject that are still in the neighbor ring of this pivot.
    void follow(const Event& event) {
        const auto set = [&](Index p, bool on) {
            if (const std::size_t i = subject_.find(p); i < subject_.size()) alive_.set(i, on);
        };
        if (const auto* pivot = as<PivotEvidence>(event)) {
            set(pivot->first, true);
            set(pivot->last, true);
            return;
        }
        const Index tested = testedPoint(event);
        if (!subject_.has(tested)) return;
        // Points that limits move past stay spokes, and so do first and last, which are no
        // candidates.
        const bool stays = isA<LimitEvidence>(event) || verdictOf(event) == Verdict::OnRingEnd;
        const Outcome outcome = outcomeOf(event);
        if (stays || outcome == Outcome::None) return;
        if (event.address.stage == Stage::Reciprocal) {
            // One entry of the point whose test passes is enough (§6.1, Fig. 6).
            if (isAgainst(outcome) && reciprocal_ == tested) return;
            if (outcome == Outcome::Taken) reciprocal_ = tested;
        }
        set(tested, outcome == Outcome::Taken);
    }

    void addEvent(const SweptPivot& pivot, const Event& event) {
        std::optional<LineRole> role = roleOf(pivot.point, event);
        if (editsMesh(event)) {
            if (!inMesh_) inMesh_ = isInMesh(pivot.after.triangles, subject_);
            const bool now = isInMesh(pivot.after.repair, subject_);
            if (now != *inMesh_) role = now ? LineRole::Made : LineRole::Undone;
            inMesh_ = now;
        }
        const auto* limit = as<LimitEvidence>(event);
        if (limit != nullptr && limit->moves() && !role)
            moves_.push_back({event, ledger_.lines.size()});
        if (!role) return;
        addMoveOver(pivot.point, event);
        ledger_.lines.push_back(lineOf(pivot.point, event, *role));
    }
    LedgerLine lineOf(Index pivot, const Event& event, LineRole role) const {
        return {event, pivot, role, readingOf(event, {points_, params_, pivot})};
    }

    /// A move of start or end, and its place among the lines.
    struct Move {
        Event event;
        std::size_t place;
        bool isAdded = false;
    };
    /// Adds the first move of start or end past a candidate that it left outside (§6.1, Fig. 4).
    void addMoveOver(Index pivot, const Event& event) {
        const DropEvidence* drop = passedBy(event);
        if (drop == nullptr) return;
        const auto found = std::find_if(moves_.begin(), moves_.end(), [&](const Move& each) {
            return passes(each.event, *drop);
        });
        if (found == moves_.end() || found->isAdded) return;
        found->isAdded = true;
        ledger_.lines.insert(ledger_.lines.begin() + static_cast<std::ptrdiff_t>(found->place),
                             lineOf(pivot, found->event, LineRole::Indirect));
        for (auto later = found + 1; later != moves_.end(); ++later) ++later->place;
    }

    std::optional<LineRole> roleOf(Index pivot, const Event& event) const {
        const auto* emit = as<EmitEvidence>(event);
        if (emit != nullptr && holds(emit->corners, subject_)) return LineRole::Made;
        if (const auto role = roleOfTest(pivot, event)) return role;
        if (gaps_.isClearedBy(event)) return LineRole::Indirect;
        return isFact(event) ? std::optional(LineRole::Fact) : std::nullopt;
    }

    /// The role of a test between two points of the subject, or of its one point, or of a test that
    /// ends their fan.
    std::optional<LineRole> roleOfTest(Index pivot, const Event& event) const {
        const Outcome outcome = outcomeOf(event);
        if (outcome == Outcome::None) return {};
        const LineRole role = outcome == Outcome::Taken ? LineRole::Taken : LineRole::Refused;
        const Index tested = testedPoint(event);
        const bool single = subject_.size() == 1;
        if (subject_.has(tested) && (single || (subject_.has(pivot) && tested != pivot)))
            return role;
        // The fan as a whole, which would have held the subject.
        const bool wholeFan =
            tested == kNone && rowOf(event.address.stage).tests == StageTests::OfFans;
        const bool concerned = alive_.any() && (single || subject_.has(pivot));
        return wholeFan && isAgainst(outcome) && concerned ? std::optional(role) : std::nullopt;
    }

    bool isFact(const Event& event) const {
        const auto any = [&](std::initializer_list<Index> points) {
            return countIn(subject_, points) > 0;
        };
        return std::visit(Overloaded{[&](const SeedEvidence& e) {
                                         return any({e.first, e.second});
                                     },
                                     [&](const CloseEvidence& e) {
                                         return any({e.a, e.b});
                                     },
                                     [&](const FlipEvidence& e) {
                                         return any({e.u, e.v, e.x, e.y});
                                     },
                                     [&](const CloseHoleEvidence& e) {
                                         return any({e.first, e.second});
                                     },
                                     [&](const RemeshEvidence& e) {
                                         return any({e.faulty.a, e.faulty.b, e.faulty.c});
                                     },
                                     [&](const EmitEvidence& e) {
                                         return countIn(subject_,
                                                        {e.corners.a, e.corners.b, e.corners.c}) >=
                                                std::min<std::size_t>(2, subject_.size());
                                     },
                                     [](const AlertEvidence&) { return false; },
                                     [&](const auto& e) {
                                         // Events that name their pivot, the test of a third
                                         // point (§7) among them.
                                         if constexpr (requires { e.pivot; }) return any({e.pivot});
                                         // A test is no fact.
                                         if constexpr (requires { e.verdict; }) return false;
                                         if constexpr (requires { e.point; }) return any({e.point});
                                         return false;
                                     }},
                          event.evidence);
    }

    const PointSet& points_;
    const Params& params_;
    const Subject subject_;
    Ledger ledger_;
    std::bitset<3> alive_;     ///< Points of the subject that may become spokes of the current fan.
    FilledGaps gaps_;          ///< Of this pivot.
    std::vector<Move> moves_;  ///< Of start and end, in this pivot.
    Index reciprocal_ = kNone;  ///< The last point of the subject that passed the reciprocal test.
    std::optional<bool> inMesh_;  ///< During the repair after the last pivot: before this step.
};

/// False if no event of a pivot can name a point of the subject: those of a pivot name it, points
/// on edge rings, neighbors of the pivot and the ends of its gap in a rim.
bool mayName(const PointSet& points, const Params& params, const Subject& subject, Index pivot,
             const State& before) {
    const bool hasOwnList = std::any_of(
        params.whatIf.begin(), params.whatIf.end(),
        [&](const WhatIf& each) { return each.kind == WhatIfKind::List && each.point == pivot; });
    if (hasOwnList) return true;
    const RimGap gap = points.gapAt(pivot);
    const auto isNear = [&](Index p) {
        return p == pivot || before.status[p] > kUnused || p == gap.from || p == gap.to ||
               points.neighbors.has(pivot, p);
    };
    return std::any_of(subject.points().begin(), subject.points().end(), isNear);
}

std::optional<Error> subjectError(const PointSet& points, const Subject& subject) {
    for (std::size_t i = 0; i < subject.size(); ++i) {
        if (subject[i] >= points.size()) {
            return Error{"There is no point " + std::to_string(subject[i]) +
                         ": the points are 0 to " + std::to_string(points.size() - 1) + "."};
        }
        if (subject.find(subject[i]) != i)
            return Error{"The points of the " + nameOf(subject) + " must be different."};
    }
    return {};
}

}  // namespace

std::vector<LedgerLine> linesAt(const PointSet& points, const Params& params,
                                const Subject& subject, const SweptPivot& pivot) {
    LedgerBuilder builder(points, params, subject);
    builder.add(pivot);
    return builder.lines();
}

Result<Question<Ledger>> whyQuestion(const PointSet& points, const Params& params,
                                     const Subject& subject) {
    if (points.size() == 0) return Error{"There are no points."};
    if (auto error = subjectError(points, subject)) return *error;
    const auto builder = std::make_shared<LedgerBuilder>(points, params, subject);
    return Question<Ledger>{[builder](const SweptPivot& pivot) { builder->add(pivot); },
                            [builder](const State& end) -> Result<Ledger> {
                                if (auto error = builder->withoutDecision(end)) return *error;
                                return builder->finish(end);
                            },
                            [&points, &params, subject](Index pivot, const State& before) {
                                return mayName(points, params, subject, pivot, before);
                            }};
}

std::string answerText(const Ledger& ledger, std::string_view between) {
    std::string text = ledger.name + (ledger.present ? " is " : " is not ");
    text.append(ledger.where).append(between).append(ledger.words);
    const Address& cause = ledger.lines[ledger.cause].event.address;
    return capitalized(text + " (" + toString(cause) + ")");
}

Result<Ledger> why(const PointSet& points, const Params& params, const Subject& subject,
                   const Progress& progress) {
    const Result<Question<Ledger>> question = whyQuestion(points, params, subject);
    if (!question) return question.error();
    return ask(points, params, question.value(), progress);
}

}  // namespace se
