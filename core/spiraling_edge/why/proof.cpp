/// Forks of the run at the decisions to invert. One pass forward leaves out the inversions that are
/// refused, and finds those that show at their own pivot: these are the likely ones. Each run to an
/// end is made from the start.
#include "spiraling_edge/why/proof.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/cause_inversion.h"
#include "spiraling_edge/why/origin_decisions.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se {
namespace {

/// A decision that can be inverted.
struct Invertible {
    std::size_t line;
    WhatIf inverse;
    /// Nothing is inverted, but this point is listed by WhatIf::point; else kNone.
    Index listed = kNone;
    /// The subject is absent, and the pivot makes it with the inversion.
    bool showsAtOnce = false;
};

/// The result of a search for the decision that an answer rests on.
struct Proof {
    std::optional<Invertible> found;
    std::size_t tried = 0;  ///< Inversions that were run, this one among them.
    bool complete = true;   ///< Not one was left out for the limits.
};

bool lists(const PointSet& points, Index p, Index q) {
    const auto list = points.neighbors[p];
    return std::find(list.begin(), list.end(), q) != list.end();
}

/// True if the way from `at` to p leads into the triangle, between its two other points. `turn` is
/// 1 for triangles that run counterclockwise about the normal, else -1.
bool isInSector(const PointSet& points, double turn, const Triangle& t, Index at, Index p) {
    const Index x = at == t.a ? t.b : at == t.b ? t.c : t.a;
    const Index y = at == t.a ? t.c : at == t.b ? t.a : t.b;
    const auto to = [&](Index q) { return points.position[q] - points.position[at]; };
    const Vec3 n = turn * points.normal[at];
    return x != p && y != p && glm::dot(glm::cross(to(x), to(p)), n) > 0.0 &&
           glm::dot(glm::cross(to(p), to(y)), n) > 0.0;
}

/// Triangles in the place of an absent subject, the latest: made at a corner of it, across the
/// direction to another corner; of one point, across the direction to it from a near neighbor.
/// O(triangles).
std::vector<Triangle> rivalsOf(const PointSet& points, const Params& params, const Subject& subject,
                               std::span<const Triangle> made) {
    const double turn = params.paper.turn == TurnRule::Clockwise ? -1.0 : 1.0;
    constexpr std::size_t kNearby = 6;
    constexpr std::size_t kMostRivals = 8;
    std::vector<std::pair<Index, Index>> ways;
    for (const Index p : subject.points()) {
        for (const Index q : subject.points()) {
            if (p != q) ways.emplace_back(p, q);
        }
        const auto list = points.neighbors[p];
        if (subject.size() > 1) continue;
        for (const Index q : list.first(std::min(list.size(), kNearby))) ways.emplace_back(q, p);
    }
    std::vector<Triangle> rivals;
    for (std::size_t i = made.size(); i-- > 0 && rivals.size() < kMostRivals;) {
        const Triangle& t = made[i];
        const bool inTheWay = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
            return hasCorner(t, way.first) && isInSector(points, turn, t, way.first, way.second);
        });
        if (inTheWay) rivals.push_back(t);
    }
    return rivals;
}

/// Of the pivot that made the subject of `made`, the tests that took its points or made way for it,
/// as lines about other points.
void addMaking(const Ledger& made, Ledger& ledger) {
    const auto emit = std::find_if(made.lines.begin(), made.lines.end(),
                                   [](const auto& line) { return line.role == LineRole::Made; });
    if (emit == made.lines.end()) return;
    for (LedgerLine line : made.lines) {
        const bool decided = line.role == LineRole::Taken || line.role == LineRole::Indirect;
        const bool known = std::any_of(
            ledger.lines.begin(), ledger.lines.end(),
            [&](const LedgerLine& each) { return each.event.address == line.event.address; });
        if (!decided || known || line.event.address.pivot != emit->event.address.pivot) continue;
        line.role = LineRole::Indirect;
        ledger.lines.push_back(line);
    }
}

/// Adds the tests that made the triangles in the place of an absent subject. False if cancelled.
bool addRivals(const PointSet& points, const Params& params, std::span<const Triangle> rivals,
               Ledger& ledger, const Progress& progress) {
    if (rivals.empty()) return true;
    std::vector<Question<Ledger>> asked;
    asked.reserve(rivals.size());
    for (const Triangle& t : rivals)
        asked.push_back(whyQuestion(points, params, Subject::triangle(t.a, t.b, t.c)).value());
    const auto end = sweep(
        points, params,
        [&](const SweptPivot& pivot) {
            for (const Question<Ledger>& each : asked) each.visit(pivot);
        },
        progress);
    if (!end) return false;
    const Address cause = ledger.lines[ledger.cause].event.address;
    for (const Question<Ledger>& each : asked) {
        const Result<Ledger> made = each.answer(*end);
        if (made) addMaking(made.value(), ledger);
    }
    std::stable_sort(ledger.lines.begin(), ledger.lines.end(), [](const auto& a, const auto& b) {
        return isBefore(a.event.address, b.event.address);
    });
    ledger.cause = 0;
    while (ledger.lines[ledger.cause].event.address != cause) ++ledger.cause;
    return true;
}

/// Of an absent edge whose ends are near and do not list each other: each with the other in its
/// list.
void addLists(const PointSet& points, const Ledger& ledger, std::vector<Invertible>& all) {
    constexpr double kNear = 4.0;  // Of the distance to the last of the list.
    const Subject& s = ledger.subject;
    if (ledger.present || s.size() != 2) return;
    for (const auto& [p, q] : {std::pair(s[0], s[1]), std::pair(s[1], s[0])}) {
        const auto list = points.neighbors[p];
        const auto distance = [&, p = p](Index x) {
            return glm::distance(points.position[p], points.position[x]);
        };
        if (list.empty() || lists(points, p, q) || distance(q) > kNear * distance(list.back()))
            continue;
        WhatIf longer{WhatIfKind::List, 1, Stage::Pivot, p, Vec3(0.0), {}};
        longer.list.assign(list.begin(), list.end());
        longer.list.push_back(q);
        all.push_back({ledger.cause, longer, q});
    }
}

/// The latest decisions of a ledger that can be inverted, and what else can be.
std::vector<Invertible> invertibleOf(const PointSet& points, const Ledger& ledger) {
    constexpr std::size_t kMost = 200;
    std::vector<Invertible> all;
    const LineRole direct = ledger.present ? LineRole::Taken : LineRole::Refused;
    for (std::size_t i = ledger.lines.size(); i-- > 0 && all.size() < kMost;) {
        const LedgerLine& line = ledger.lines[i];
        if (line.role != direct && line.role != LineRole::Indirect) continue;
        const auto inverse = inverseOf(points, line);
        if (!inverse || std::any_of(all.begin(), all.end(), [&](const Invertible& each) {
                return each.inverse == *inverse;
            }))
            continue;
        all.push_back({i, *inverse});
    }
    addLists(points, ledger, all);
    return all;
}

class Prover {
  public:
    /// `steps`: of the run, its pivots and the steps after the last one.
    Prover(const PointSet& points, const Params& params, const Ledger& ledger, std::uint64_t steps,
           const ProofLimits& limits, const Progress& progress)
        : points_(points),
          params_(params),
          ledger_(ledger),
          steps_(steps),
          limits_(limits),
          progress_(progress),
          all_(invertibleOf(points, ledger)) {}

    Result<Proof> run() {
        if (all_.empty()) return Proof{};
        if (!lookAtPivots()) return Error{"Cancelled."};
        sortByPromise();
        return runToEnds();
    }

  private:
    Params with(const WhatIf& inverse) const {
        Params forked = params_;
        forked.whatIf.push_back(inverse);
        return forked;
    }

    /// Makes steps until `done`, at most `left` of them, which it lowers. False if cancelled.
    template <typename Done>
    bool advance(Stepper& stepper, std::uint64_t& left, const Done& done) const {
        while (!done() && left > 0 && stepper.stepPivot()) {
            if (--left % kPivotsPerReport == 0 && progress_ && !progress_(share_)) return false;
        }
        return true;
    }

    /// Leaves out inversions that are refused, and marks those that show at their pivot. False if
    /// cancelled.
    bool lookAtPivots() {
        std::stable_sort(all_.begin(), all_.end(), [](const Invertible& a, const Invertible& b) {
            return a.inverse.pivot < b.inverse.pivot;
        });
        Stepper stepper(points_, params_);
        std::uint64_t left = ~std::uint64_t{0};
        std::vector<Invertible> possible;
        for (Invertible& each : all_) {
            const std::uint32_t pivot = each.inverse.pivot;
            const auto isThere = [&] { return stepper.state().counters.pivots + 1 >= pivot; };
            if (!advance(stepper, left, isThere) || (progress_ && !progress_(share_))) return false;
            const Params forked = with(each.inverse);
            if (!checkLastWhatIf(points_, forked, stepper.state())) continue;
            if (!ledger_.present) {
                Stepper fork(points_, forked);
                fork.setState(stepper.state());
                const std::size_t before = fork.state().triangles.size();
                fork.stepPivot();
                each.showsAtOnce =
                    isInMesh(std::span(fork.state().triangles).subspan(before), ledger_.subject);
            }
            possible.push_back(each);
        }
        all_ = std::move(possible);
        return true;
    }

    /// Those that show at once first, then that of the cause, then those of the pivot that made the
    /// subject; of equals the later.
    void sortByPromise() {
        const std::uint32_t making = ledger_.lines[ledger_.cause].event.address.pivot;
        const auto rank = [&](const Invertible& each) {
            return std::tuple(!each.showsAtOnce, each.line != ledger_.cause,
                              ledger_.present && each.inverse.pivot != making);
        };
        std::stable_sort(all_.begin(), all_.end(), [&](const Invertible& a, const Invertible& b) {
            if (rank(a) != rank(b)) return rank(a) < rank(b);
            return a.line > b.line;
        });
    }

    Result<Proof> runToEnds() {
        constexpr double kLookShare = 0.3;
        Proof proof;
        std::uint64_t left =
            std::max(kLeastProofSteps,
                     static_cast<std::uint64_t>(limits_.runs * static_cast<double>(steps_)));
        for (const Invertible& each : all_) {
            share_ = kLookShare + (1.0 - kLookShare) * static_cast<double>(proof.tried) /
                                      static_cast<double>(limits_.inversions);
            if (proof.tried == limits_.inversions || left == 0) {
                proof.complete = false;
                break;
            }
            if (progress_ && !progress_(share_)) return Error{"Cancelled."};
            Stepper fork(points_, with(each.inverse));
            if (!advance(fork, left, [] { return false; })) return Error{"Cancelled."};
            if (!fork.state().finished()) {
                proof.complete = false;
                break;
            }
            ++proof.tried;
            if (isInMesh(fork.state().mesh(), ledger_.subject) == ledger_.present) continue;
            proof.found = each;
            break;
        }
        return proof;
    }

    const PointSet& points_;
    const Params& params_;
    const Ledger& ledger_;
    std::uint64_t steps_;
    const ProofLimits& limits_;
    const Progress& progress_;
    std::vector<Invertible> all_;
    double share_ = 0.0;  ///< Of the work, for the progress.
};

/// The proof that needs no inversion: a step after the last pivot made or removed the subject, or
/// preparation did not let it take part.
ProvedBy provedAlready(const PointSet& points, const Ledger& ledger) {
    const LedgerLine& cause = ledger.lines[ledger.cause];
    if (cause.role == LineRole::Undone || (ledger.present && editsMesh(cause.event)))
        return ProvedBy::Step;
    if (ledger.present) return ProvedBy::Nothing;
    const auto members = ledger.subject.points();
    const bool aside =
        std::any_of(members.begin(), members.end(), [&](Index p) { return points.isAside(p); });
    if (aside) return ProvedBy::Preparation;
    if (members.size() > 1) return ProvedBy::Nothing;
    for (Index q = 0; q < points.size(); ++q) {
        if (lists(points, q, members[0])) return ProvedBy::Nothing;
    }
    return ProvedBy::Preparation;
}

/// What the inversion of `found` does: the words after the subject.
std::string wordsOf(const Ledger& ledger, const Invertible& found) {
    if (found.listed != kNone)
        return ", and would be if " + std::to_string(found.inverse.point) + " listed " +
               std::to_string(found.listed) + ": ";
    return std::string(", and would ") + (ledger.present ? "not be" : "be") +
           " with this decision inverted: ";
}

/// The end of an answer that is not proved.
std::string doubtOf(const Proof& proof) {
    if (proof.tried == 0) return " Not proved: no decision about it can be inverted.";
    const std::string count = counted(proof.tried, "inversion");
    return " Not proved: " + (proof.complete ? count : "the first " + count) +
           (proof.tried == 1 ? " does" : " do") + " not change it.";
}

void settle(Ledger& ledger, const Proof& proof) {
    ledger.answer =
        nameOf(ledger.subject) + (ledger.present ? " is in the mesh" : " is not in the mesh");
    if (proof.found) {
        const std::size_t line = proof.found->line;
        if (line != ledger.cause) ledger.words = describe(ledger.lines[line].event);
        ledger.cause = line;
        ledger.provedBy = ProvedBy::Inversion;
        ledger.inverse = proof.found->inverse;
        ledger.answer += wordsOf(ledger, *proof.found);
    } else if (ledger.provedBy == ProvedBy::Step) {
        ledger.answer += std::string(", since a step after the last pivot ") +
                         (ledger.present ? "made" : "removed") + " it: ";
    } else {
        ledger.answer += ". ";
    }
    ledger.answer += ledger.words + " (" + toString(ledger.lines[ledger.cause].event.address) + ")";
    if (ledger.provedBy == ProvedBy::Nothing) ledger.answer += doubtOf(proof);
    ledger.answer[0] = static_cast<char>(ledger.answer[0] - 'a' + 'A');
}

}  // namespace

std::string_view provedByName(ProvedBy by) {
    constexpr std::array<std::string_view, 4> kNames{"nothing", "inversion", "step", "preparation"};
    return kNames[static_cast<std::size_t>(by)];
}

Result<Ledger> provedWhy(const PointSet& points, const Params& params, const Subject& subject,
                         const ProofLimits& limits, const Progress& progress) {
    constexpr double kLedgerShare = 0.3;
    const Result<Question<Ledger>> question = whyQuestion(points, params, subject);
    if (!question) return question.error();
    std::uint64_t steps = 0;
    const auto visit = [&](const SweptPivot& pivot) {
        ++steps;
        question.value().visit(pivot);
    };
    const auto end = sweep(points, params, visit, partOf(progress, 0.0, kLedgerShare));
    if (!end) return Error{"Cancelled."};
    Result<Ledger> ledger = question.value().answer(*end);
    if (!ledger) return ledger;
    ledger.value().provedBy = provedAlready(points, ledger.value());
    Proof proof;
    if (ledger.value().provedBy == ProvedBy::Nothing) {
        std::vector<Triangle> rivals;
        if (!ledger.value().present) rivals = rivalsOf(points, params, subject, end->triangles);
        if (!addRivals(points, params, rivals, ledger.value(),
                       partOf(progress, kLedgerShare, 2.0 * kLedgerShare)))
            return Error{"Cancelled."};
        const Progress rest = partOf(progress, 2.0 * kLedgerShare, 1.0);
        Result<Proof> found = Prover(points, params, ledger.value(), steps, limits, rest).run();
        if (!found) return found.error();
        proof = std::move(found.value());
    }
    settle(ledger.value(), proof);
    return ledger;
}

}  // namespace se
