// The steps of a lesson: input, position, looks, camera and second run of each.
#include "export_run.h"
#include "jobs/open_lesson.h"
#include "lesson/lesson_frames.h"
#include "scene/decision_view.h"

namespace se::view {

namespace {

bool hasOwnView(const teach::LessonStep& step) {
    return !step.frame.empty() || !step.camera.empty() || !step.view.empty();
}

}  // namespace

/// Opens the input of a step, if the one before had another.
Status ExportRun::openStep(std::size_t step) {
    const LessonFile& file = *order_.lesson;
    Result<RunSpec> input = inputOfStep(file, step);
    if (!input) return Error{stepPlace(file, step, "rules") + input.error().message};
    const bool fresh = !(input.value() == opened_);
    opened_ = input.value();
    if (fresh) {
        session().open(opened_);
        session().waitUntilDone();
        if (application_->inputFailed())
            return Error{stepPlace(file, step, "") + session().input().error()};
        draw(1);
    }
    const teach::StepSetting setting = teach::settingOf(file.lesson, step);
    const Status moved = goTo(setting.at == "0" ? "" : setting.at);
    if (!moved) return Error{stepPlace(file, step, "at") + moved.error().message};
    ui().settings.layers = layersOfStep(settings_.layers, file.lesson.steps[step]);
    session().select(selectionOfStep(file.lesson.steps[step], setting.names));
    names_ = setting.names;
    pointNames_ = teach::pointNames(names_);
    session().giveNames(pointNames_);
    const bool split = ui().layoutPreset == LayoutPreset::Compare;
    const bool asks = file.lesson.steps[step].question.has_value();
    if (const Status compared =
            compareStep(step, asks ? std::vector<std::string>{} : file.lesson.steps[step].compare);
        !compared)
        return compared;
    const bool resized = split != (ui().layoutPreset == LayoutPreset::Compare);
    const bool own = hasOwnView(file.lesson.steps[step]);
    const FollowedDecision here{session().generation(), session().picture().pivot,
                                viewWayOf(session().shown(), session().picture())};
    // Steps of one decision have one camera.
    const bool before = std::exchange(ownView_, own);
    if (std::exchange(aimed_, here) == here && !resized && !own && !before) return success();
    const Status aimed = aimAtStep(application_->context(), file.lesson.steps[step], setting);
    return aimed ? aimed : Error{stepPlace(file, step, "camera") + aimed.error().message};
}

/// Opens the second run of a step beside the first one; without words there is none.
Status ExportRun::compareStep(std::size_t step, const std::vector<std::string>& words) {
    const LessonFile& file = *order_.lesson;
    const bool compares = ui().layoutPreset == LayoutPreset::Compare;
    if (words.empty() && !compares) return success();
    ui().layoutPreset = words.empty() ? LayoutPreset::Debug : LayoutPreset::Compare;
    if (words.empty()) {
        application_->context().compare.stop();
    } else {
        const Result<RunSpec> other = comparedInput(opened_, words);
        if (!other) return Error{stepPlace(file, step, "compare") + other.error().message};
        application_->context().compare.begin(CompareWith::otherRun(other.value()));
    }
    draw(1);
    if (const Status done = application_->waitUntilDone(); !done)
        return Error{stepPlace(file, step, "compare") + done.error().message};
    draw(1);
    return success();
}

/// The frame of a step; on a page, that of the answer to its question as well.
Status ExportRun::addStep(std::size_t step) {
    const LessonFile& file = *order_.lesson;
    FrameStep of{file.lesson, step, teach::settingOf(file.lesson, step).names, file.folder};
    const bool asks =
        file.lesson.steps[step].question && format_->content == FrameContent::BothThemes;
    if (!asks) return addFrame(&of, false);
    const Result<teach::RightAnswer> right = teach::rightAnswer(file.lesson, step, runs_);
    if (!right) {
        fail(kExitInput, stepPlace(file, step, "") + "answer: " + right.error().message);
        return right.error();
    }
    of.right = &right.value();
    if (const Status added = addFrame(&of, false); !added) return added;
    goToAnswer(step);
    const Status compared = compareStep(step, file.lesson.steps[step].compare);
    return compared ? addFrame(&of, true) : compared;
}

/// Goes to where the question of a step is answered: to the end of the pivot, without a position.
void ExportRun::goToAnswer(std::size_t step) {
    const std::string place = teach::settingOf(order_.lesson->lesson, step).answerPlace;
    if (!place.empty() && goTo(place)) return;
    session().moves().finishPivot();
    session().waitUntilDone();
}

}  // namespace se::view
