#include "spiraling_edge/why/tried_fixes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/base/parallel.h"
#include "spiraling_edge/prepare/piece.h"
#include "spiraling_edge/why/trial.h"

namespace se {
namespace {

/// The values that isSounder() compares: "sound", "no triangle", "stopped", "4 points amiss".
std::string endOf(const MeshVerdict& verdict) {
    if (verdict.triangles == 0) return "no triangle";
    if (verdict.stopped) return "stopped";
    if (verdict.isSound()) return "sound";
    return counted(verdict.amiss, "point") + " amiss";
}

/// The cost of a trial, in the unit of kWorkOfFixes.
std::uint64_t costOf(const Trial& trial) {
    constexpr std::uint64_t kMostFaults = 4;  // A point; more take no longer.
    const std::uint64_t points = trial.verdict.points;
    return std::max(trial.work, points) +
           std::min<std::uint64_t>(faultCount(trial.verdict.totals), kMostFaults * points);
}

/// The meshes of one file, by `paper` and by `robust`.
struct BothMeshes {
    MeshVerdict paper;
    MeshVerdict robust;
};

/// The fixes of one file.
class FixTrials {
  public:
    FixTrials(const PointFile& file, std::uint64_t work, const Progress& progress)
        : file_(file), work_(work), progress_(progress) {}

    /// The number of steps of progress that follow.
    void expect(std::size_t steps) { steps_ = std::max<std::size_t>(steps, 1); }

    /// Nothing where that would take too much work.
    Result<std::optional<TriedFix>> tried(const Finding& finding) {
        if (finding.scale) return triedOn(scaled(file_, *finding.scale), {});
        switch (finding.check->fix) {
            case Fix::None:
                return triedBest();
            case Fix::Repair:
                return triedRepair();
            case Fix::Drop:
                return triedOn(applyFixes(file_, finding.toDrop(), finding.dropReason).file, {});
            default:
                return triedOn(file_, changeOf(finding.check->fix));
        }
    }

  private:
    Progress nextStep() {
        const double from = static_cast<double>(step_) / static_cast<double>(steps_);
        step_ = std::min(step_ + 1, steps_);
        return partOf(progress_, from, static_cast<double>(step_) / static_cast<double>(steps_));
    }

    Result<MeshVerdict> meshOf(const PointFile& file, const SpecChange& change,
                               std::string_view rules, const Progress& progress) {
        RunSpec spec = changed({}, specChange({{"rules", rules}}));
        Result<Trial> trial = trialOfRun(file, changed(std::move(spec), change), progress);
        if (!trial) return trial.error();
        spent_ += costOf(trial.value());
        return std::move(trial.value().verdict);
    }
    Result<BothMeshes> meshesOf(const PointFile& file, const SpecChange& change) {
        const Progress progress = nextStep();
        Result<MeshVerdict> paper = meshOf(file, change, "paper", partOf(progress, 0.0, 0.5));
        if (!paper) return paper.error();
        Result<MeshVerdict> robust = meshOf(file, change, "robust", partOf(progress, 0.5, 1.0));
        if (!robust) return robust.error();
        return BothMeshes{std::move(paper.value()), std::move(robust.value())};
    }

    Result<std::optional<TriedFix>> triedOn(const PointFile& file, const SpecChange& change) {
        if (spent_ > work_) return std::optional<TriedFix>{};
        if (!before_) {
            Result<BothMeshes> made = meshesOf(file_, {});
            if (!made) return made.error();
            before_ = std::move(made.value());
        }
        const Result<BothMeshes> after = meshesOf(file, change);
        if (!after) return after.error();
        TriedFix tried;
        bool helps = false;
        bool harms = false;
        const auto compare = [&](std::string_view rules, const MeshVerdict& now,
                                 const MeshVerdict& then) {
            helps = helps || isSounder(now, then);
            harms = harms || isSounder(then, now);
            tried.text += (tried.text.empty() ? "by " : ", by ") + std::string(rules) + " " +
                          endOf(now) + " (before " + endOf(then) + ")";
        };
        compare("paper", after.value().paper, before_->paper);
        compare("robust", after.value().robust, before_->robust);
        const auto anySound = [](const BothMeshes& meshes) {
            return meshes.paper.isSound() || meshes.robust.isSound();
        };
        tried.helps = (helps && !harms) || (anySound(after.value()) && !anySound(*before_));
        return std::optional(std::move(tried));
    }

    /// Repairs without a guess: every run makes them.
    std::optional<TriedFix> triedRepair() const {
        const std::size_t left = applyFixes(file_).file.position.size();
        return TriedFix{left > 0, "writes " + counted(left, "point") +
                                      ", without those that every run sets aside"};
    }

    Result<std::optional<TriedFix>> triedBest() {
        std::uint64_t spent = spent_;
        const auto count = [&](const Trials& trials, const SpecChange&) {
            if (!trials.tried.empty()) spent += costOf(trials.tried.back());
        };
        const Progress own = nextStep();
        const auto go = [&](double share) { return spent <= work_ && (!own || own(share)); };
        const Result<Trials> trials = tryChanges(file_, {}, count, go);
        if (!trials && spent > work_) return std::optional<TriedFix>{};
        if (!trials) return trials.error();
        const std::vector<Trial>& tried = trials.value().tried;
        const std::string before = endOf(tried.front().verdict);
        const Trial& best = tried[trials.value().best];
        if (trials.value().best == 0) {
            const std::size_t changes = tried.size() - 1;
            return std::optional(TriedFix{
                false,
                before + " as given" +
                    (changes == 0 ? ""
                                  : "; none of " + counted(changes, "change") + " is better")});
        }
        return std::optional(TriedFix{true, endOf(best.verdict) + " with " + wordsOf(best.change) +
                                                " (before " + before + ")"});
    }

    const PointFile& file_;
    std::uint64_t work_;
    std::uint64_t spent_ = 0;
    const Progress& progress_;
    std::optional<BothMeshes> before_;
    std::size_t steps_ = 1;
    std::size_t step_ = 0;
};

}  // namespace

Status tryFixes(const PointFile& file, Diagnosis& diagnosis, const Progress& progress,
                std::uint64_t work) {
    FixTrials trials(file, work, progress);
    const auto hasRemedy = [](const Finding& finding) { return finding.hasRemedy(); };
    trials.expect(2 + static_cast<std::size_t>(std::count_if(diagnosis.findings.begin(),
                                                             diagnosis.findings.end(), hasRemedy)));
    // --best takes up to twenty runs.
    std::vector<const Finding*> dearestLast;
    for (const Finding& finding : diagnosis.findings) {
        if (finding.hasRemedy()) dearestLast.push_back(&finding);
    }
    std::stable_partition(dearestLast.begin(), dearestLast.end(), [](const Finding* finding) {
        return finding->scale || finding->check->fix != Fix::None;
    });
    const auto commandFor = [](const Finding& finding) { return commandOf(finding, "IN"); };
    std::map<std::string, std::optional<TriedFix>> effects;  // by command
    for (const Finding* finding : dearestLast) {
        const std::string command = commandFor(*finding);
        if (effects.contains(command)) continue;
        Result<std::optional<TriedFix>> tried = trials.tried(*finding);
        if (!tried) return tried.error();
        effects[command] = std::move(tried.value());
    }
    if (progress && !progress(1.0)) return Error{"Cancelled."};
    for (Finding& finding : diagnosis.findings) {
        if (finding.hasRemedy()) finding.tried = effects[commandFor(finding)];
    }
    return success();
}

}  // namespace se
