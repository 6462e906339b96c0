/// Trials one after the other. Points keep their numbers in all of them, since those that a change
/// drops are set aside; so every mesh is measured against the same points and the same openings:
/// the rims of the points as they are prepared without a change.
#include "spiraling_edge/explain/trial.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <tuple>
#include <utility>

#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/doctor/doctor.h"
#include "spiraling_edge/geometry/loop_shape.h"
#include "spiraling_edge/points/usable_points.h"
#include "spiraling_edge/prepare/judge.h"
#include "spiraling_edge/prepare/rim.h"
#include "spiraling_edge/replay/reconstruct.h"

namespace se {
namespace {

using Chains = std::vector<std::vector<Index>>;

/// Losing more than one point in this many is no gain, whatever the faults.
constexpr std::size_t kPointsPerLost = 200;

/// Changes of any input, in the order in which they are tried. Points that the doctor would drop
/// come after them, since detail goes with those.
constexpr std::array kSets{SettingsChange{.rules = "robust"}, SettingsChange{.rules = "corrected"}};
constexpr std::array kChanges{
    SettingsChange{.rules = "robust", .normals = NormalSource::Oriented},
    SettingsChange{.rules = "robust", .rim = true},
    SettingsChange{.rules = "robust", .nearest = 10},
    SettingsChange{.rules = "robust", .nearest = 16},
    SettingsChange{.rules = "robust", .nearest = 8},
    SettingsChange{.rules = "robust", .nearest = 12},
    SettingsChange{.rules = "robust", .nearest = 20},
    SettingsChange{.rules = "robust", .normals = NormalSource::Derived},
    SettingsChange{.rules = "robust", .symmetric = true},
    SettingsChange{.rules = "robust", .ruleOff = "fill"},
    SettingsChange{.rules = "robust", .ruleOff = "shelve"},
};
/// True if a change leaves given normals alone that are right: those that do not fit are derived,
/// those of which some are flipped turned.
bool respects(const MeshJudge& judge, const SettingsChange& change) {
    if (!change.normals) return true;
    return *change.normals == NormalSource::Oriented ? judge.fit && !judge.areRight() : !judge.fit;
}

constexpr std::size_t kMaxTriedDrops = 3;  ///< Findings of the doctor that are tried.
constexpr std::size_t kMaxTriedPairs = 3;  ///< Pairs of the best changes.
static_assert(1 + kSets.size() + kMaxTriedDrops + kChanges.size() + kMaxTriedPairs <= kMaxTrials);

std::size_t totalOf(const std::vector<ClassTotal>& totals, std::string_view name) {
    return totals[static_cast<std::size_t>(findFailureClass(name) - failureClasses().data())].total;
}

/// True if the user wants an opening of this size closed.
bool isToClose(const PointSet& points, const Params& params, const std::vector<Index>& chain) {
    if (!params.limitsHoles()) return false;
    const LoopShape shape = shapeOfLoop(points.position, points.normal, chain);
    return params.isWithinHoleLimits(shape.width(), chain.size());
}

/// The number of chains that the mesh covers: most of their points in triangles are on no loop.
std::size_t closedChains(const Chains& chains, const MeshInspection& found,
                         const std::vector<bool>& used) {
    std::vector<bool> onLoop(used.size(), false);
    for (const MeshFailure& each : found.failures) {
        if (!isLoop(each)) continue;
        for (const Index p : each.points) onLoop[p] = true;
    }
    const auto isClosed = [&](const std::vector<Index>& chain) {
        std::ptrdiff_t inside = 0;
        for (const Index p : chain) {
            if (used[p]) inside += onLoop[p] ? -1 : 1;
        }
        return inside > 0;
    };
    return static_cast<std::size_t>(std::count_if(chains.begin(), chains.end(), isClosed));
}

/// True for a mesh that could only be better with fewer points set aside.
bool isGood(const MeshNumbers& numbers) {
    return isSound(numbers) && numbers.lost == 0 && numbers.closed == 0;
}

/// Order of meshes, the best first.
auto rankOf(const MeshNumbers& n) {
    return std::tuple(n.capped || n.triangles == 0, faultCount(n.totals), n.setAside, n.lost,
                      n.closed, n.fidelity.greatestDistance, n.fidelity.meanDistance);
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
    TrialRuns(const PointFile& file, const RunSettings& present, const Progress& progress)
        : file_(file), present_(present), progress_(progress) {}

    /// Changes of the set of rules alone.
    std::vector<SettingsChange> sets() const {
        std::vector<SettingsChange> changes;
        for (const SettingsChange& each : kSets) addTo(changes, each);
        return changes;
    }

    /// Changes of one thing besides the set of rules. Some may be without effect on this input, and
    /// so be one of sets().
    Result<std::vector<SettingsChange>> singleChanges() {
        if (const Status examined = diagnose(); !examined) return examined.error();
        std::vector<SettingsChange> changes = sets();
        const auto known = static_cast<std::ptrdiff_t>(changes.size());
        for (const SettingsChange& each : kChanges) addTo(changes, each);
        std::size_t drops = 0;
        for (const Finding& finding : diagnosis_->findings) {
            const bool tried =
                finding.check->fix == Fix::Drop && finding.isProblem() && !finding.dropsAll();
            if (!tried || ++drops > kMaxTriedDrops) continue;
            addTo(changes, {.rules = "robust", .drop = finding.check->name});
        }
        changes.erase(changes.begin(), changes.begin() + known);
        return changes;
    }

    /// Pairs of the best single changes: of those that are better than none.
    static std::vector<SettingsChange> pairs(const Trials& trials) {
        const std::vector<Trial>& tried = trials.tried;
        const MeshNumbers& present = tried.front().numbers;
        std::vector<Trial> single;
        std::copy_if(tried.begin() + 1, tried.end(), std::back_inserter(single),
                     [&](const Trial& each) {
                         return each.change != SettingsChange{.rules = each.change.rules} &&
                                isBetter(each.numbers, present, present);
                     });
        std::stable_sort(single.begin(), single.end(), [](const Trial& a, const Trial& b) {
            return rankOf(a.numbers) < rankOf(b.numbers);
        });
        std::vector<SettingsChange> pairs;
        for (std::size_t i = 1; i < single.size(); ++i) {
            for (std::size_t j = 0; j < i && pairs.size() < kMaxTriedPairs; ++j) {
                if (const auto both = bothOf(single[j].change, single[i].change))
                    pairs.push_back(*both);
            }
        }
        return pairs;
    }

    /// Runs with a change, which covers the shares `from` to `to` of the whole.
    Result<Trial> run(const SettingsChange& change, double from, double to) {
        const Progress part = partOf(progress_, from, to);
        done_ = from;
        const RunSettings settings = changed(present_, change);
        const Result<Params> params = paramsOf(settings);
        if (!params) return params.error();
        PrepareOptions options = prepareOptionsFor(settings.prepare, params.value());
        if (const Status dropped = leaveOutDropped(settings, options); !dropped)
            return dropped.error();
        const Result<Prepared> prepared = prepareWith(options, params.value(), part);
        if (!prepared) return prepared.error();
        const auto made =
            reconstructed(prepared.value().points, params.value(), partOf(part, 0.3, 0.8));
        if (!made || (part && !part(0.8))) return Error{"Cancelled."};
        Trial trial{change, std::move(options.leaveOut), measure(prepared.value(), *made)};
        if (part && !part(1.0)) return Error{"Cancelled."};
        done_ = to;
        return trial;
    }

  private:
    void addTo(std::vector<SettingsChange>& changes, const SettingsChange& change) const {
        const SettingsChange left = withoutPresent(change, present_, file_);
        if (!respects(judge_, left)) return;
        const bool known = std::find(changes.begin(), changes.end(), left) != changes.end();
        if (left != SettingsChange{} && !known) changes.push_back(left);
    }

    /// The doctor's examination, once.
    Status diagnose() {
        if (diagnosis_) return success();
        Result<Diagnosis> found = examine(file_, partOf(progress_, done_, done_));
        if (!found) return found.error();
        diagnosis_ = std::move(found.value());
        return success();
    }

    Status leaveOutDropped(const RunSettings& settings, PrepareOptions& options) {
        if (settings.drops.empty()) return success();
        if (const Status examined = diagnose(); !examined) return examined.error();
        const std::vector<Index> kept = std::exchange(options.leaveOut, {});
        const std::vector<Index> drop = proposedDrop(*diagnosis_, settings.drops).points;
        std::set_union(kept.begin(), kept.end(), drop.begin(), drop.end(),
                       std::back_inserter(options.leaveOut));
        return success();
    }

    /// Prepares; the first time, also finds the judge of all meshes, and the openings of the scan.
    Result<Prepared> prepareWith(const PrepareOptions& options, const Params& params,
                                 const Progress& part) {
        Result<Prepared> prepared = prepare(file_, options, partOf(part, 0.0, 0.2));
        if (!prepared) return prepared;
        PointSet& points = prepared.value().points;
        if (!judge_.points) {
            Result<MeshJudge> judge = judgeFor(file_, options, points, partOf(part, 0.2, 0.3));
            if (!judge) return judge.error();
            judge_ = std::move(judge.value());
        }
        points.judge = judge_.forRun(points, options.leaveOut);
        if (openings_) return prepared;
        Result<Rim> rim = findRim(points.position, points.normal, points.neighbors, points.type,
                                  options.neighbors.threads);
        if (!rim) return rim.error();
        openings_ = std::move(rim.value().chains);
        std::erase_if(*openings_, [&](const std::vector<Index>& chain) {
            return isToClose(points, params, chain);
        });
        return prepared;
    }

    MeshNumbers measure(const Prepared& prepared, const Reconstruction& made) const {
        assert(openings_);
        const PointSet& points = prepared.points;
        const std::vector<Triangle>& mesh = made.state.mesh();
        MeshInspection found = inspectWithTotals(points, mesh);
        MeshNumbers numbers;
        numbers.points = points.size();
        numbers.lost =
            totalOf(found.totals, "unused_points") + totalOf(found.totals, "isolated_points");
        numbers.dropped = prepared.report.leftOut;
        numbers.setAside = prepared.report.noisyPoints + numbers.dropped;
        numbers.openings = openings_->size();
        numbers.closed = closedChains(*openings_, found, usedPoints(points.size(), mesh));
        numbers.fidelity = fidelityOf(points, mesh);
        numbers.totals = std::move(found.totals);
        numbers.triangles = mesh.size();
        numbers.capped = made.reason == StopReason::Capped;
        return numbers;
    }

    const PointFile& file_;
    const RunSettings& present_;
    const Progress& progress_;
    double done_ = 0.0;  ///< Share of the whole before the work in progress.
    std::optional<Chains> openings_;
    std::optional<Diagnosis> diagnosis_;
    MeshJudge judge_;  ///< Of the points as given, for every trial.
};

/// The search in progress.
class TrialSearch {
  public:
    using Visit = std::function<void(const Trials&, const SettingsChange&)>;

    TrialSearch(TrialRuns& runs, const Visit& visit) : runs_(runs), visit_(visit) {}

    /// Tries changes until a mesh is good.
    Status tryAll(const std::vector<SettingsChange>& changes) {
        for (const SettingsChange& change : changes) {
            if (isDone()) break;
            if (visit_) visit_(trials, change);
            const auto done = static_cast<double>(trials.tried.size());
            Result<Trial> trial = runs_.run(change, done / kTrials, (done + 1.0) / kTrials);
            if (!trial) return trial.error();
            trials.tried.push_back(std::move(trial.value()));
            const MeshNumbers& last = trials.tried.back().numbers;
            const MeshNumbers& best = trials.tried[trials.best].numbers;
            if (isBetter(last, best, trials.tried.front().numbers))
                trials.best = trials.tried.size() - 1;
        }
        return success();
    }

    /// True if the best mesh is good.
    bool isDone() const {
        return !trials.tried.empty() && isGood(trials.tried[trials.best].numbers);
    }

    Trials trials;

  private:
    static constexpr double kTrials = kMaxTrials;

    TrialRuns& runs_;
    const Visit& visit_;
};

/// "12 faults", "sound", "no triangle".
std::string faultText(const MeshNumbers& numbers) {
    if (numbers.triangles == 0) return "no triangle";
    const std::size_t faults = faultCount(numbers.totals);
    if (faults == 0) return isSound(numbers) ? "sound" : "no fault found";
    return std::string(isExact(numbers.totals) ? "" : "at least ") + std::to_string(faults) +
           (faults == 1 ? " fault" : " faults");
}

}  // namespace

std::string trialText(const SettingsChange& next) {
    return next == SettingsChange{} ? "measuring the run as given" : "trying " + wordsOf(next);
}

std::string describe(const MeshNumbers& numbers) {
    if (numbers.capped) return "stopped: too many triangles";
    std::string text = faultText(numbers) + "; " + std::to_string(numbers.lost) +
                       (numbers.lost == 1 ? " point lost" : " points lost");
    if (numbers.setAside > 0) text += ", " + std::to_string(numbers.setAside) + " set aside";
    if (numbers.openings > 0) {
        text += "; " + std::to_string(numbers.closed) + " of " + std::to_string(numbers.openings) +
                (numbers.openings == 1 ? " opening closed" : " openings closed");
    }
    return text + "; distances up to " + shortNumber(numbers.fidelity.greatestDistance) +
           ", mean " + shortNumber(numbers.fidelity.meanDistance);
}

bool isSound(const MeshNumbers& numbers) {
    return isSound(numbers.totals, numbers.triangles) && !numbers.capped;
}

bool isBetter(const MeshNumbers& trial, const MeshNumbers& best, const MeshNumbers& present) {
    const std::size_t mayLose = present.lost + present.points / kPointsPerLost;
    if (trial.capped || trial.triangles == 0) return false;
    if (trial.closed > present.closed || trial.lost > mayLose + trial.dropped) return false;
    return rankOf(trial) < rankOf(best);
}

Result<Trials> tryChanges(const PointFile& file, const RunSettings& present,
                          const std::function<void(const Trials&, const SettingsChange&)>& visit,
                          const Progress& progress) {
    TrialRuns runs(file, present, progress);
    TrialSearch search(runs, visit);
    if (const Status tried = search.tryAll({SettingsChange{}}); !tried) return tried.error();
    if (const Status tried = search.tryAll(runs.sets()); !tried) return tried.error();
    if (!search.isDone()) {
        const Result<std::vector<SettingsChange>> single = runs.singleChanges();
        if (!single) return single.error();
        if (const Status tried = search.tryAll(single.value()); !tried) return tried.error();
        const std::vector<SettingsChange> pairs = TrialRuns::pairs(search.trials);
        if (const Status tried = search.tryAll(pairs); !tried) return tried.error();
    }
    if (progress && !progress(1.0)) return Error{"Cancelled."};
    return std::move(search.trials);
}

}  // namespace se
