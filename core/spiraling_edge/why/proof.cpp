/// Two passes forward through the run fork at the decisions to invert. The first makes the pivot of
/// each: an inversion that shows there is the likely one, and where triangles stay to the end it
/// needs no more. The second makes the runs to their ends.
#include "spiraling_edge/why/proof.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/run/event_text.h"
#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/cause_inversion.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se {
namespace {

/// The result of a search for the decision that an answer rests on.
struct Proof {
    /// Position in Ledger::lines of a decision without which the answer is another; nothing if none
    /// was found.
    std::optional<std::size_t> line;
    std::optional<WhatIf> inverse;  ///< The what-if that inverts it.
    std::size_t tried = 0;          ///< Inversions that were run, this one among them.
};

/// A decision that can be inverted.
struct Invertible {
    std::size_t line;
    WhatIf inverse;
    bool showsAtOnce = false;  ///< The inversion changes the answer at its own pivot.
};

bool holdsSubject(const Triangle& t, const Subject& subject) {
    const auto points = subject.points();
    return std::all_of(points.begin(), points.end(),
                       [&](Index p) { return p == t.a || p == t.b || p == t.c; });
}

bool isAmong(std::span<const Triangle> triangles, const Subject& subject) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](const Triangle& t) { return holdsSubject(t, subject); });
}

/// Adds the tests that made the triangles in the place of an absent subject. False if cancelled.
bool addRivals(const PointSet& points, const Params& params, Ledger& ledger,
               const Progress& progress) {
    if (ledger.rivals.empty()) return true;
    std::vector<Question<Ledger>> asked;
    for (const Triangle& t : ledger.rivals)
        asked.push_back(whyQuestion(points, params, Subject::triangle(t.a, t.b, t.c)).value());
    const auto end = sweep(
        points, params,
        [&](const SweptPivot& pivot) {
            for (const Question<Ledger>& each : asked) each.visit(pivot);
        },
        progress);
    if (!end) return false;
    const LedgerLine cause = ledger.lines[ledger.cause];
    const auto known = [&](const LedgerLine& line) {
        return std::any_of(ledger.lines.begin(), ledger.lines.end(), [&](const LedgerLine& each) {
            return each.event.address == line.event.address;
        });
    };
    for (const Question<Ledger>& each : asked) {
        const Result<Ledger> made = each.answer(*end);
        if (!made) continue;
        const std::vector<LedgerLine>& lines = made.value().lines;
        const auto emit = std::find_if(lines.begin(), lines.end(), [](const LedgerLine& line) {
            return line.role == LineRole::Made;
        });
        if (emit == lines.end()) continue;
        for (LedgerLine line : lines) {
            const bool decided = line.role == LineRole::Taken || line.role == LineRole::Indirect;
            if (!decided || line.event.address.pivot != emit->event.address.pivot || known(line))
                continue;
            line.role = LineRole::Indirect;
            ledger.lines.push_back(line);
        }
    }
    std::stable_sort(ledger.lines.begin(), ledger.lines.end(),
                     [](const LedgerLine& a, const LedgerLine& b) {
                         return isBefore(a.event.address, b.event.address);
                     });
    ledger.cause = 0;
    while (ledger.lines[ledger.cause].event.address != cause.event.address) ++ledger.cause;
    return true;
}

class Prover {
  public:
    Prover(const PointSet& points, const Params& params, const Ledger& ledger,
           const ProofLimits& limits, const Progress& progress)
        : points_(points),
          params_(params),
          ledger_(ledger),
          limits_(limits),
          progress_(progress),
          all_(invertibleOf(points, ledger)) {}

    Result<Proof> run() {
        if (all_.empty()) return Proof{};
        if (!lookAtPivots()) return Error{"Cancelled."};
        std::vector<Invertible> order = inOrder();
        // Triangles stay, unless steps after the last pivot edit the mesh.
        if (!ledger_.present && !ledger_.edited && !order.empty() && order.front().showsAtOnce)
            return Proof{order.front().line, order.front().inverse, 1};
        return runToEnds(std::move(order));
    }

  private:
    static std::vector<Invertible> invertibleOf(const PointSet& points, const Ledger& ledger) {
        std::vector<Invertible> all;
        for (std::size_t i = ledger.lines.size(); i-- > 0;) {
            const LedgerLine& line = ledger.lines[i];
            const LineRole direct = ledger.present ? LineRole::Taken : LineRole::Refused;
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

    /// Of an absent edge whose ends do not list each other: each with the other in its list.
    static void addLists(const PointSet& points, const Ledger& ledger,
                         std::vector<Invertible>& all) {
        const Subject& s = ledger.subject;
        if (ledger.present || s.size() != 2) return;
        for (const auto& [p, q] : {std::pair(s[0], s[1]), std::pair(s[1], s[0])}) {
            const auto list = points.neighbors[p];
            if (std::find(list.begin(), list.end(), q) != list.end()) continue;
            WhatIf longer{WhatIfKind::List, 1, Stage::Pivot, p, Vec3(0.0), {}};
            longer.list.assign(list.begin(), list.end());
            longer.list.push_back(q);
            all.push_back({ledger.cause, longer});
        }
    }

    Params with(const WhatIf& inverse) const {
        Params forked = params_;
        forked.whatIf.push_back(inverse);
        return forked;
    }

    /// Makes pivots up to the one before `pivot`.
    static void goBefore(std::uint32_t pivot, Stepper& stepper) {
        while (stepper.state().counters.pivots + 1 < pivot && stepper.stepPivot()) {
        }
    }

    /// Leaves out inversions that are refused, and marks those that show at their pivot. False if
    /// cancelled.
    bool lookAtPivots() {
        std::stable_sort(all_.begin(), all_.end(), [](const Invertible& a, const Invertible& b) {
            return a.inverse.pivot < b.inverse.pivot;
        });
        Stepper stepper(points_, params_);
        std::vector<Invertible> possible;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (progress_ && !progress_(0.3 * double(i) / double(all_.size()))) return false;
            Invertible each = all_[i];
            goBefore(each.inverse.pivot, stepper);
            const Params forked = with(each.inverse);
            if (!checkLastWhatIf(points_, forked, stepper.state())) continue;
            Stepper fork(points_, forked);
            fork.setState(stepper.state());
            const std::size_t before = fork.state().triangles.size();
            fork.stepPivot();
            const std::span made = std::span(fork.state().triangles).subspan(before);
            each.showsAtOnce = isAmong(made, ledger_.subject) != ledger_.present;
            possible.push_back(each);
        }
        all_ = std::move(possible);
        return true;
    }

    /// Those that show at once first; of equals that of the cause, then the later.
    std::vector<Invertible> inOrder() const {
        std::vector<Invertible> order = all_;
        const auto rank = [&](const Invertible& each) {
            const Address& cause = ledger_.lines[ledger_.cause].event.address;
            return std::tuple(!each.showsAtOnce, each.line != ledger_.cause,
                              ledger_.present && each.inverse.pivot != cause.pivot);
        };
        std::stable_sort(order.begin(), order.end(), [&](const Invertible& a, const Invertible& b) {
            if (rank(a) != rank(b)) return rank(a) < rank(b);
            return a.line > b.line;
        });
        return order;
    }

    Result<Proof> runToEnds(std::vector<Invertible> order) {
        Proof proof;
        std::uint64_t left = std::max(
            kLeastProofPivots,
            static_cast<std::uint64_t>(limits_.runs * static_cast<double>(ledger_.pivots)));
        for (const Invertible& each : order) {
            if (proof.tried == limits_.inversions || left == 0) break;
            if (progress_ &&
                !progress_(0.3 + 0.7 * double(proof.tried) / double(limits_.inversions)))
                return Error{"Cancelled."};
            ++proof.tried;
            std::uint64_t spent = 0;
            const bool changes = isChangedBy(each.inverse, spent);
            left -= std::min(left, spent);
            if (!changes) continue;
            proof.line = each.line;
            proof.inverse = each.inverse;
            break;
        }
        return proof;
    }

    /// True if the answer is another at the end of the run with this what-if.
    bool isChangedBy(const WhatIf& inverse, std::uint64_t& spent) const {
        Stepper fork(points_, with(inverse));
        while (fork.stepPivot()) {
        }
        spent = fork.state().counters.pivots;
        return isAmong(fork.state().mesh(), ledger_.subject) != ledger_.present;
    }

    const PointSet& points_;
    const Params& params_;
    const Ledger& ledger_;
    const ProofLimits& limits_;
    const Progress& progress_;
    std::vector<Invertible> all_;
};

}  // namespace

namespace {

/// The proof that needs no inversion: a step after the last pivot made or removed the subject, or
/// preparation did not let it take part.
ProvedBy provedAlready(const PointSet& points, const Ledger& ledger) {
    const LedgerLine& cause = ledger.lines[ledger.cause];
    if (cause.role == LineRole::Undone || (ledger.present && editsMesh(cause.event)))
        return ProvedBy::Step;
    const auto members = ledger.subject.points();
    const bool aside =
        std::any_of(members.begin(), members.end(), [&](Index p) { return points.isAside(p); });
    return aside ? ProvedBy::Preparation : ProvedBy::Nothing;
}

/// The words between the subject and the cause.
std::string linkTo(const Ledger& ledger, const Proof& proof) {
    switch (ledger.provedBy) {
        case ProvedBy::Inversion:
            if (proof.inverse->kind == WhatIfKind::List)
                return ", and would be with one more neighbor in a list: ";
            return std::string(", and would ") + (ledger.present ? "not be" : "be") +
                   " with this decision inverted: ";
        case ProvedBy::Step:
            return std::string(", since a step after the last pivot ") +
                   (ledger.present ? "made" : "removed") + " it: ";
        case ProvedBy::Preparation:
            return ". ";
        case ProvedBy::Nothing:
            break;
    }
    if (proof.tried == 0) return ". Not proved, since no decision about it can be inverted: ";
    return ". Not proved, since " + counted(proof.tried, "inversion") +
           (proof.tried == 1 ? " changes" : " change") + " nothing: ";
}

void settle(Ledger& ledger, const Proof& proof) {
    if (proof.line) {
        if (*proof.line != ledger.cause) ledger.words = describe(ledger.lines[*proof.line].event);
        ledger.cause = *proof.line;
        ledger.provedBy = ProvedBy::Inversion;
        ledger.inverse = proof.inverse;
    }
    ledger.answer = nameOf(ledger.subject) +
                    (ledger.present ? " is in the mesh" : " is not in the mesh") +
                    linkTo(ledger, proof) + ledger.words + " (" +
                    toString(ledger.lines[ledger.cause].event.address) + ")";
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
    Result<Ledger> ledger = why(points, params, subject, partOf(progress, 0.0, kLedgerShare));
    if (!ledger) return ledger;
    ledger.value().provedBy = provedAlready(points, ledger.value());
    Proof proof;
    if (ledger.value().provedBy == ProvedBy::Nothing) {
        if (!addRivals(points, params, ledger.value(),
                       partOf(progress, kLedgerShare, 2.0 * kLedgerShare)))
            return Error{"Cancelled."};
        const Progress rest = partOf(progress, 2.0 * kLedgerShare, 1.0);
        const Result<Proof> found = Prover(points, params, ledger.value(), limits, rest).run();
        if (!found) return found.error();
        proof = found.value();
    }
    settle(ledger.value(), proof);
    return ledger;
}

}  // namespace se
