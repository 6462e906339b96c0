#include "session_input.h"

#include <algorithm>
#include <utility>

#include "spiraling_edge/stepper/stepper.h"
#include "spiraling_edge/why/what_if_check.h"

namespace se::view {

namespace {

Result<Opened> openInput(const RunSpec& spec, LoadProgress& progress) {
    Result<Loaded> loaded = loadInput(spec, progress);
    if (!loaded) return loaded.error();
    Opened opened{std::move(loaded.value().model), nullptr, std::move(loaded.value().file)};
    opened.given = std::move(loaded.value().given);
    return opened;
}

/// The same points with the params of other rules.
Result<Opened> openAgain(const RunSpec& spec, const Rerun& rerun, LoadProgress& progress) {
    const Result<Params> params = paramsOf(spec);
    if (!params) return params.error();
    if (!preparesAlike(params.value(), rerun.model->params)) return openInput(spec, progress);
    auto model = std::make_shared<Model>(*rerun.model);
    model->params = params.value();
    return Opened{std::move(model), nullptr, nullptr};
}

/// Fails if a what-if is refused that the run did not have before.
Status checkForks(Opened& opened, const std::vector<WhatIf>& known, LoadProgress& progress) {
    const Model& model = *opened.model;
    const auto answers = checkWhatIfs(model.points, model.params,
                                      [&](double) { return !progress.cancelled.load(); });
    if (!answers) return openingCancelled();
    for (std::size_t i = 0; i < answers->size(); ++i) {
        const WhatIf& what = model.params.whatIf[i];
        const bool is = std::find(known.begin(), known.end(), what) != known.end();
        const std::string why = (*answers)[i] ? std::string{} : (*answers)[i].error().message;
        if (!why.empty() && !is) return Error{lineOf(what) + " is refused. " + why};
        opened.whatIfs.push_back(why);
    }
    return success();
}

std::vector<MovedModel> movedModels(const Model& model) {
    std::vector<MovedModel> made;
    for (EditedPoints& each : editedPoints(model.points, model.params)) {
        auto moved = std::make_shared<Model>(model);
        moved->points = std::move(each.points);
        for (const WhatIf& what : model.params.whatIf) {
            if (what.kind != WhatIfKind::Move || what.point >= moved->place.size()) continue;
            moved->place[what.point] = moved->toView(moved->points.position[what.point]);
        }
        made.push_back({each.from, std::move(moved)});
    }
    return made;
}

Result<Opened> openRun(const RunSpec& spec, const std::optional<Rerun>& rerun,
                       LoadProgress& progress) {
    Result<Opened> made = rerun ? openAgain(spec, *rerun, progress) : openInput(spec, progress);
    if (!made) return made;
    Opened& opened = made.value();
    progress.part = LoadPart::Beginning;
    // What-ifs of a session file are opened in any case; those without effect are reported.
    const std::vector<WhatIf>& known = rerun ? rerun->spec.whatIf : spec.whatIf;
    if (const Status good = checkForks(opened, known, progress); !good) return good.error();
    opened.moved = movedModels(*opened.model);
    if (rerun) {
        const Model& before = *rerun->model;
        opened.place = findSamePosition({before.points, before.params}, rerun->cursor,
                                        {opened.model->points, opened.model->params},
                                        [&progress] { return !progress.cancelled.load(); });
        if (!opened.place) return openingCancelled();
    }
    opened.runner = std::make_unique<Runner>(opened.model);
    opened.runner->request(opened.place ? opened.place->pivot : 0);
    while (!opened.runner->waitFor(std::chrono::milliseconds(50))) {
        if (progress.cancelled) return openingCancelled();
    }
    if (const std::string why = opened.runner->complaint(); !why.empty()) return Error{why};
    return made;
}

}  // namespace

void SessionInput::cancel() {
    if (progress_) progress_->cancelled = true;
    query_.cancel();
}

std::optional<Result<Opened>> SessionInput::take() {
    if (!query_.poll()) return std::nullopt;
    if (std::optional<Opened> opened = query_.takeAnswer()) return std::move(*opened);
    return Error{query_.complaint()};
}

const std::string& SessionInput::whatIfProblem(std::size_t i) const {
    static const std::string none;
    return i < whatIfProblems_.size() ? whatIfProblems_[i] : none;
}

double SessionInput::rerunSeconds() const {
    return std::chrono::duration<double>(Clock::now() - rerunSince_).count();
}

void SessionInput::start(RunSpec spec, std::optional<Rerun> rerun) {
    isRerun_ = rerun.has_value();
    opening_ = std::move(spec);
    error_.clear();
    phase_ = SessionPhase::Loading;
    cancel();
    progress_ = std::make_shared<LoadProgress>();
    query_.start([spec = opening_, rerun = std::move(rerun), progress = progress_](
                     const Progress&) { return openRun(spec, rerun, *progress); });
}

void SessionInput::open(RunSpec spec) { start(std::move(spec), std::nullopt); }

void SessionInput::rerun(const RunSpec& rules, std::shared_ptr<const Model> model,
                         CursorPosition cursor) {
    rerunSince_ = Clock::now();
    start(withRulesOf(spec_, rules), Rerun{std::move(model), spec_, cursor});
}

void SessionInput::fail(std::string why) {
    error_ = std::move(why);
    phase_ = SessionPhase::Failed;
}

void SessionInput::adopt(Opened& opened) {
    spec_ = opening_;
    whatIfProblems_ = std::move(opened.whatIfs);
    if (opened.given) file_ = std::move(opened.given);
    phase_ = SessionPhase::Ready;
}

}  // namespace se::view
