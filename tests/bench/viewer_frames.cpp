// The cost of the viewer's frames, without a window: the move, user interface and scene, and
// separately that of OpenGL. viewer_bench FRAMES [FILE] [OPTION...]; options are the viewer's.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "../viewer/opening_times.h"
#include "application.h"
#include "offscreen.h"
#include "options.h"
#include "render/context.h"
#include "scene/framing.h"
#include "scene/picking.h"
#include "spiraling_edge/scenes/scenes.h"

namespace {

using namespace se::view;

int fail(int code, const std::string& message) {
    std::fprintf(stderr, "viewer_bench: %s\n", message.c_str());
    return code;
}

void printTimes(const char* what, std::vector<double> seconds) {
    std::sort(seconds.begin(), seconds.end());
    std::printf("%-28s median %7.3f ms   99 %% %7.3f ms   worst %7.3f ms\n", what,
                1e3 * seconds[seconds.size() / 2], 1e3 * seconds[seconds.size() * 99 / 100],
                1e3 * seconds.back());
}

/// Processor time of this thread so far, in seconds.
double threadSeconds() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsOf(void (*call)()) {
    const auto began = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Cost of one kind of move, frame by frame.
void benchMoves(int frames, Offscreen& offscreen, Application& application, const char* what,
                void (*move)(Application&)) {
    constexpr int kWarmUp = 10;
    std::vector<double> own;
    std::vector<double> gl;
    std::vector<double> processor;
    std::vector<double> thread;
    for (int i = -kWarmUp; i < frames; ++i) {
        const auto began = std::chrono::steady_clock::now();
        const std::clock_t before = std::clock();
        const double threadBefore = threadSeconds();
        move(application);
        application.poll();
        const std::chrono::duration<double> moved = std::chrono::steady_clock::now() - began;
        offscreen.beginFrame();
        application.frame(offscreen.size(), 1.0 / 60.0);
        const double drawn = secondsOf(finishGl);
        if (i < 0) continue;
        own.push_back(moved.count() + application.uiSeconds());
        gl.push_back(application.glSeconds() + drawn);
        thread.push_back(threadSeconds() - threadBefore);
        processor.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    std::printf("%d frames, %s\n", frames, what);
    printTimes("  our own time", own);
    printTimes("  OpenGL, until it is done", gl);
    printTimes("  processor, this thread", thread);
    printTimes("  processor, all threads", processor);
}

/// Cost of frames in which only the camera moves, and of frames in which only panels differ.
void benchStill(int frames, Offscreen& target, Application& application) {
    benchMoves(frames, target, application, "the camera turns", [](Application& each) {
        each.camera().orbit({8.0F, 3.0F}, 800.0F);
    });
    benchMoves(frames, target, application, "the picture stays, the panels are drawn again",
               [](Application& each) { each.redraw(); });
    benchMoves(frames, target, application, "nothing moves: equal frames, not drawn",
               [](Application&) {});
}

/// Cost of frames in which a neighbor of the pivot is dragged, with the pivot made again for each.
void benchDrag(int frames, Offscreen& target, Application& application) {
    PointDrag& drag = application.session().drag();
    const se::Index pivot = application.session().picture().pivot;
    const auto& lists = application.session().model().points.neighbors;
    if (!drag.possible(pivot) || lists[pivot].empty()) return;
    drag.begin(lists[pivot][0]);
    benchMoves(frames, target, application, "a neighbor of the pivot is dragged",
               [](Application& each) {
                   PointDrag& held = each.session().drag();
                   const Model& model = held.model();
                   held.moveTo(held.to() + se::Vec3(1e-3 * model.spacing / model.scale, 0.0, 0.0));
               });
    drag.takeBack();
}

/// Cost of frames while other settings are tried (trial.h), if the input lasts long enough.
void benchBesideTrials(int frames, Offscreen& target, Application& application) {
    application.session().trials().start();
    benchMoves(frames, target, application, "one pivot each, while other settings are tried",
               [](Application& each) { each.session().moves().stepPivot(1); });
    if (!application.session().trials().busy()) std::printf("  (the trials ended before)\n");
    application.session().trials().stop();
}

/// Cost of steps through the run, and of a click.
void benchSteps(int frames, Offscreen& target, Application& application) {
    benchMoves(frames, target, application, "one sub-step each",
               [](Application& each) { each.session().moves().stepEvent(1); });
    benchMoves(frames, target, application, "one pivot each",
               [](Application& each) { each.session().moves().stepPivot(1); });
    benchMoves(frames, target, application, "one pivot back each",
               [](Application& each) { each.session().moves().stepPivot(-1); });
    benchMoves(frames, target, application, "a click on the middle each", [](Application& each) {
        Session& session = each.session();
        Camera camera;
        frameModel(session.model(), {}, camera);
        const PickScene scene{session.model(), true, session.shownTriangles(),
                              session.picture().repaired ? nullptr : &session.meshIndex(),
                              session.picture().rings};
        session.select(pick(scene, {camera.matrices(1.6F), {1280, 800}, {640, 400}, 9.6F}).what);
    });
}

/// Opens the input as a window does: fonts and the empty panels are drawn while it is being read.
int open(Offscreen& target, Application& application, test::OpeningTimes& times) {
    if (const auto status = application.start(1.0F); !status)
        return fail(kExitNoDisplay, status.error().message);
    // Nothing else runs beside the frames.
    application.session().alerts().setFollows(false);
    const auto draw = [&] {
        target.beginFrame();
        application.poll();
        application.frame(target.size(), 1.0 / 60.0);
        times.noteFrame(application);
    };
    while (!application.session().ready() && !application.inputFailed()) {
        draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(15));
    }
    draw();
    const auto status = application.waitUntilDone();
    if (status) return kExitGood;
    return fail(application.inputFailed() ? kExitInput : kExitUsage, status.error().message);
}

int run(int frames, Options options) {
    test::OpeningTimes times(test::OpeningTimes::Clock::now());
    options.noConfig = true;
    if (options.input.source.empty()) options.input.source = sceneSource(se::scenes().front().id);
    // A scene would open at its decision.
    const bool whole = options.goTo.empty() && !options.camera;
    if (whole) options.goTo = "0";
    const ViewSettings settings = settingsFor(options, keptSettings(options));
    const auto offscreen = Offscreen::create({settings.width, settings.height});
    if (!offscreen) return fail(kExitNoDisplay, offscreen.error().message);
    Offscreen& target = *offscreen.value();
    Application application(options, settings);
    if (const int code = open(target, application, times); code != kExitGood) return code;
    const Model& model = application.session().model();
    if (whole) frameModel(model, application.context().ui.viewPart(), application.camera());
    std::printf("%zu points at %dx%d; first frame %.3f s after the start\n", model.points.size(),
                target.size().x, target.size().y, times.firstFrame());
    std::printf(
        "window %.3f s after the start; at most %.0f ms from frame to frame while opening\n",
        times.firstWindow(), 1e3 * times.longest());
    benchSteps(frames, target, application);
    benchStill(frames, target, application);
    benchDrag(frames, target, application);
    benchBesideTrials(frames, target, application);
    return kExitGood;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int frames = argc > 1 ? std::atoi(argv[1]) : 0;
        if (frames < 1)
            return fail(kExitUsage, "expected a number of frames, then a file and options");
        ParsedOptions parsed = parseOptions(argc - 1, argv + 1);
        if (!parsed.options) return parsed.exitCode;
        for (const auto adopt : {adoptSession, adoptStart}) {
            if (const auto status = adopt(*parsed.options); !status)
                return fail(kExitInput, status.error().message);
        }
        return run(frames, std::move(*parsed.options));
    } catch (const std::exception& e) {
        return fail(kExitInternal, e.what());
    }
}
