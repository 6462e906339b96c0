/// Trials one after the other. Points keep their numbers in all of them, since those that a change
/// drops are set aside; so every mesh is measured against the same points and the same openings:
/// the rims of the points as they are prepared without a change.
#include "spiraling_edge/why/trial.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/why/other_preparations.h"

namespace se {
namespace {

constexpr std::size_t kMaxTriedDrops = 3;  ///< Findings of the doctor that are tried.
constexpr std::size_t kMaxTriedPairs = 3;  ///< Pairs of the best changes.
constexpr std::string_view kSwitchedOff[] = {"fill=off", "shelve=off"};
constexpr std::size_t kUsualChanges = kPreparationChanges + std::size(kSwitchedOff);
static_assert(1 + 2 + kMaxTriedDrops + kUsualChanges + kMaxTriedPairs <= kMaxTrials);

/// Changes of the rules alone, in the order in which they are tried.
std::vector<SpecChange> setsOfRules() {
    return {specChange({{"rules", "robust"}}), specChange({{"rules", "corrected"}})};
}

/// Changes of any input. Points that the doctor would drop come after them, since detail goes with
/// those.
std::vector<SpecChange> usualChanges() {
    std::vector<SpecChange> changes = preparationChanges();
    for (const std::string_view off : kSwitchedOff)
        changes.push_back(specChange({{"switches", off}}));
    for (SpecChange& each : changes) each = *bothOf(specChange({{"rules", "robust"}}), each);
    return changes;
}

/// True for a mesh that no change can improve.
bool isPerfect(const MeshVerdict& verdict) {
    const std::span<const VerdictCount> counts = verdictCounts();
    return verdict.isSound() && std::all_of(counts.begin(), counts.end(), [&](const auto& count) {
               return count.of(verdict) == 0;
           });
}

/// Pivots, and changes made by the repair.
std::uint64_t workOf(const State& state) {
    const RepairNumbers& made = state.repair;
    return std::uint64_t{state.counters.pivots} + made.reinserted + made.takenOut + made.flipped +
           made.droppedPatches + made.closedHoles + made.remeshed;
}

/// The run to the end; nothing if cancelled.
std::optional<Reconstruction> reconstructed(const PointSet& points, const Params& params,
                                            const Progress& progress) {
    bool cancelled = false;
    // A run takes about as many pivots as there are points.
    const double pivots = static_cast<double>(std::max<std::size_t>(points.size(), 1));
    Reconstruction made = reconstruct(points, params, [&](const State& state) {
        const std::uint32_t done = state.counters.pivots;
        if (!progress || done % kPivotsPerReport != 0) return false;
        cancelled = !progress(std::min(1.0, done / pivots));
        return cancelled;
    });
    return cancelled ? std::nullopt : std::optional(std::move(made));
}

/// The trials of one file.
class TrialRuns {
  public:
    TrialRuns(const PointFile& file, const RunSpec& present, const Progress& progress)
        : file_(file), present_(present), progress_(progress) {}

    /// Changes of the set of rules alone.
    std::vector<SpecChange> sets() const {
        std::vector<SpecChange> changes;
        for (const SpecChange& each : setsOfRules()) addTo(changes, each);
        return changes;
    }

    /// Changes of one thing besides the set of rules. Some may be without effect on this input, and
    /// so be one of sets().
    Result<std::vector<SpecChange>> singleChanges() {
        if (const Status examined = diagnose(); !examined) return examined.error();
        std::vector<SpecChange> changes = sets();
        const auto known = static_cast<std::ptrdiff_t>(changes.size());
        for (const SpecChange& each : usualChanges()) addTo(changes, each);
        std::size_t drops = 0;
        for (const Finding& finding : diagnosis_->findings) {
            const bool tried =
                finding.check->fix == Fix::Drop && finding.isProblem() && !finding.dropsAll();
            if (!tried || ++drops > kMaxTriedDrops) continue;
            addTo(changes, specChange({{"doctor", finding.check->name}, {"rules", "robust"}}));
        }
        changes.erase(changes.begin(), changes.begin() + known);
        return changes;
    }

    /// Pairs of the best single changes: of those that are better than none.
    static std::vector<SpecChange> pairs(const Trials& trials) {
        const std::vector<Trial>& tried = trials.tried;
        std::vector<std::size_t> single;
        for (std::size_t i = 1; i < tried.size(); ++i) {
            const SpecChange& change = tried[i].change;
            const bool ofRules = change.size() == 1 && change.front().field->key == "rules";
            if (!ofRules && isBetter(tried[i].verdict, tried[0].verdict)) single.push_back(i);
        }
        std::stable_sort(single.begin(), single.end(), [&](std::size_t a, std::size_t b) {
            return isBetter(tried[a].verdict, tried[b].verdict);
        });
        std::vector<SpecChange> pairs;
        for (std::size_t i = 1; i < single.size(); ++i) {
            for (std::size_t j = 0; j < i && pairs.size() < kMaxTriedPairs; ++j) {
                if (const auto both = bothOf(tried[single[j]].change, tried[single[i]].change))
                    pairs.push_back(*both);
            }
        }
        return pairs;
    }

    /// Runs with a change, which covers the shares `from` to `to` of the whole.
    Result<Trial> run(const SpecChange& change, double from, double to) {
        const Progress part = partOf(progress_, from, to);
        done_ = from;
        const RunSpec spec = changed(present_, change);
        const Result<Params> params = paramsOf(spec);
        if (!params) return params.error();
        const Result<PrepareOptions> plain = prepareOptionsOf(spec, params.value(), file_);
        if (!plain) return plain.error();
        PrepareOptions options = plain.value();
        if (const Status dropped = leaveOutDropped(spec, options); !dropped) return dropped.error();
        const Result<Prepared> prepared = prepareWith(options, params.value(), part);
        if (!prepared) return prepared.error();
        const auto made =
            reconstructed(prepared.value().points, params.value(), partOf(part, 0.3, 0.8));
        if (!made || (part && !part(0.8))) return Error{"Cancelled."};
        auto mesh = std::make_shared<const std::vector<Triangle>>(made->state.mesh());
        Trial trial{change, std::move(options.leaveOut),
                    judgeMesh(prepared.value().points, *mesh).verdict, workOf(made->state), mesh};
        trial.verdict.stopped = made->reason == StopReason::Capped;
        if (part && !part(1.0)) return Error{"Cancelled."};
        done_ = to;
        return trial;
    }

  private:
    void addTo(std::vector<SpecChange>& changes, const SpecChange& change) const {
        const SpecChange left = withoutPresent(change, present_, file_);
        if (judge_ && !respects(*judge_, left)) return;
        const bool known = std::find(changes.begin(), changes.end(), left) != changes.end();
        if (!left.empty() && !known) changes.push_back(left);
    }

    /// The doctor's examination, once.
    Status diagnose() {
        if (diagnosis_) return success();
        Result<Diagnosis> found = examine(file_, partOf(progress_, done_, done_));
        if (!found) return found.error();
        diagnosis_ = std::move(found.value());
        return success();
    }

    Status leaveOutDropped(const RunSpec& spec, PrepareOptions& options) {
        if (spec.fixes.empty()) return success();
        if (const Status examined = diagnose(); !examined) return examined.error();
        options.leaveOut = proposedDrop(*diagnosis_, spec.fixes).points;
        return success();
    }

    /// Prepares; the first time, also finds the judge of all meshes.
    Result<Prepared> prepareWith(const PrepareOptions& options, const Params& params,
                                 const Progress& part) {
        Result<Prepared> prepared = prepare(file_, options, partOf(part, 0.0, 0.2));
        if (!prepared) return prepared;
        PointSet& points = prepared.value().points;
        if (!judge_) {
            const auto judge = judgeOfRun(file_, options, params, points, partOf(part, 0.2, 0.3));
            if (!judge) return judge.error();
            judge_ = judge.value();
        }
        points.judge = judge_;
        return prepared;
    }

    const PointFile& file_;
    const RunSpec& present_;
    const Progress& progress_;
    double done_ = 0.0;  ///< Share of the whole before the work in progress.
    std::optional<Diagnosis> diagnosis_;
    std::shared_ptr<const MeshJudge> judge_;  ///< Of the points as given, for every trial.
};

/// The search in progress.
class TrialSearch {
  public:
    using Visit = std::function<void(const Trials&, const SpecChange&)>;

    TrialSearch(TrialRuns& runs, const Visit& visit) : runs_(runs), visit_(visit) {}

    /// Tries changes until a mesh is good.
    Status tryAll(const std::vector<SpecChange>& changes) {
        for (const SpecChange& change : changes) {
            if (isDone()) break;
            if (visit_) visit_(trials, change);
            const auto done = static_cast<double>(trials.tried.size());
            Result<Trial> trial = runs_.run(change, done / kTrials, (done + 1.0) / kTrials);
            if (!trial) return trial.error();
            trials.tried.push_back(std::move(trial.value()));
            chooseBest();
        }
        return success();
    }

    /// True if nothing is left to improve.
    bool isDone() const {
        return !trials.tried.empty() && isPerfect(trials.tried[trials.best].verdict);
    }

    Trials trials;

  private:
    /// Compares the last trial with the best so far; the meshes of others are dropped.
    void chooseBest() {
        std::vector<Trial>& tried = trials.tried;
        const std::size_t last = tried.size() - 1;
        if (isBetter(tried[last].verdict, tried[trials.best].verdict)) {
            if (trials.best > 0) tried[trials.best].mesh.reset();
            trials.best = last;
        } else if (last > 0) {
            tried[last].mesh.reset();
        }
    }

    static constexpr double kTrials = kMaxTrials;

    TrialRuns& runs_;
    const Visit& visit_;
};

}  // namespace

std::string trialText(const SpecChange& next) {
    return next.empty() ? "measuring the run as given" : "trying " + wordsOf(next);
}

std::optional<SpecChange> bothOf(const SpecChange& a, const SpecChange& b) {
    SpecChange both = a;
    for (const FieldValue& each : b) {
        const std::string_view other = textOf(a, each.field->key);
        if (!other.empty() && other != each.text) return std::nullopt;
        if (other.empty()) both.push_back(each);
    }
    std::stable_sort(both.begin(), both.end(),
                     [](const FieldValue& x, const FieldValue& y) { return x.field < y.field; });
    return both;
}

std::string lossesText(const MeshVerdict& mesh, const MeshVerdict& before) {
    std::string text;
    for (const VerdictCount& each : verdictCounts()) {
        const std::size_t now = each.of(mesh);
        const std::size_t then = each.of(before);
        if (now <= then) continue;
        text += (text.empty() ? "more " : ", ") + std::string(each.plural) + " (" +
                std::to_string(now) + ", before " + std::to_string(then) + ")";
    }
    return text;
}

std::string describe(const MeshVerdict& verdict) {
    std::string text = headlineOf(verdict);
    if (verdict.stopped) return text;
    if (verdict.amiss > 0) text += "; " + counted(verdict.amiss, "point") + " amiss";
    for (const auto& [count, what] : {std::pair(verdict.strays, " far from all others"),
                                      std::pair(verdict.noise, " set aside as noise")}) {
        if (count > 0) text += "; " + std::to_string(count) + what;
    }
    if (verdict.openings > 0) {
        text += "; " + std::to_string(verdict.closed) + " of " + std::to_string(verdict.openings) +
                (verdict.openings == 1 ? " opening closed" : " openings closed");
    }
    return text + "; distances up to " + shortNumber(verdict.fidelity.greatestDistance) +
           ", mean " + shortNumber(verdict.fidelity.meanDistance);
}

std::string noneBetterText(const Trials& trials) {
    assert(!trials.tried.empty());
    const std::size_t changes = trials.tried.size() - 1;
    return "No better settings among " + std::to_string(changes) +
           (changes == 1 ? " change" : " changes") + " tried.";
}

Result<Trial> trialOfRun(const PointFile& file, const RunSpec& spec, const Progress& progress) {
    return TrialRuns(file, spec, progress).run({}, 0.0, 1.0);
}

Result<Trials> tryChanges(const PointFile& file, const RunSpec& present,
                          const std::function<void(const Trials&, const SpecChange&)>& visit,
                          const Progress& progress) {
    TrialRuns runs(file, present, progress);
    TrialSearch search(runs, visit);
    if (const Status tried = search.tryAll({SpecChange{}}); !tried) return tried.error();
    if (const Status tried = search.tryAll(runs.sets()); !tried) return tried.error();
    if (!search.isDone()) {
        const Result<std::vector<SpecChange>> single = runs.singleChanges();
        if (!single) return single.error();
        if (const Status tried = search.tryAll(single.value()); !tried) return tried.error();
        const std::vector<SpecChange> pairs = TrialRuns::pairs(search.trials);
        if (const Status tried = search.tryAll(pairs); !tried) return tried.error();
    }
    if (progress && !progress(1.0)) return Error{"Cancelled."};
    return std::move(search.trials);
}

}  // namespace se
