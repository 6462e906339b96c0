// The viewer's program: options, then a window, pictures or a measurement.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <thread>
#include <utility>
#include <vector>

#include "application.h"
#include "document/app_page.h"
#include "export_options.h"
#include "export_run.h"
#include "offscreen.h"
#include "options.h"
#include "picture_frames.h"
#include "render/context.h"
#include "run/strings.h"
#include "scene/framing.h"
#include "scene/picking.h"
#include "scene/picture.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/freed_memory.h"
#include "start_settings.h"
#include "window.h"

namespace {

using namespace se::view;

int fail(int code, const std::string& message) {
    printLines(stderr, "spiraling-edge-viewer: " + se::printable(message) + "\n");
    return code;
}

/// Waits until the requested view can be drawn.
int waitUntilDone(Application& application) {
    const auto status = application.waitUntilDone();
    if (status) return kExitGood;
    return fail(application.inputFailed() ? kExitInput : kExitUsage, status.error().message);
}

/// Shows the requested view, without a window.
int prepareOffscreen(Application& application) {
    if (const auto status = application.start(1.0F); !status) {
        return fail(kExitNoDisplay, status.error().message);
    }
    return waitUntilDone(application);
}

int dumpState(Application& application) {
    const auto status = application.writeState();
    return status ? kExitGood : fail(kExitInternal, status.error().message);
}

int runPicture(const Options& options) {
    ViewSettings settings = settingsFor(options, keptSettings(options));
    const glm::ivec2 size = drawnSize(settings, options.picture);
    const auto offscreen = Offscreen::create(size);
    if (!offscreen) return fail(kExitNoDisplay, offscreen.error().message);
    Application application(options, settings);
    if (const int code = prepareOffscreen(application); code != kExitGood) return code;
    Target target(0);
    // The first frames only determine the layout.
    const int frames = options.frames > 0 ? options.frames : 4;
    const Picture picture = drawPicture(application, target, size, frames);
    const auto status = writePicture(options.screenshot, picture);
    if (!status) return fail(kExitInternal, status.error().message);
    return dumpState(application);
}

/// Progress on a terminal, as of the command line.
void showProgress(const ExportRun& run) {
    if (isatty(STDERR_FILENO) == 0 || run.total() < 2) return;
    std::fprintf(stderr, "\r\033[Kframe %zu of %zu", run.made(), run.total());
    if (run.done()) std::fputs("\r\033[K", stderr);
}

int runExport(const Options& options) {
    const ViewSettings settings = settingsFor(options, keptSettings(options));
    const auto offscreen = Offscreen::create({settings.width, settings.height});
    if (!offscreen) return fail(kExitNoDisplay, offscreen.error().message);
    ExportRun run(options, settings);
    while (!run.done()) {
        run.advance(true);
        showProgress(run);
    }
    if (run.failure()) return fail(run.failure()->code, run.failure()->message);
    return run.notice().empty() ? kExitGood : fail(kExitGood, run.notice());
}

/// Writes the program as a page with the order's content inside.
int writeProgram(const Options& options) {
    const auto content = contentOf(options);
    if (!content) return fail(kExitInput, content.error().message);
    std::error_code error;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto path = findPage(self.parent_path());
    if (!path) return fail(kExitNoDisplay, path.error().message);
    const std::array inputs{se::NamedFile{"the program", path.value()}};
    const std::array outputs{se::NamedFile{"-o", options.exported->path}};
    if (const auto kept = se::requireKept(inputs, outputs); !kept && !options.force)
        return fail(kExitUsage, kept.error().message);
    auto empty = se::readBytes(path.value());
    if (!empty) return fail(kExitNoDisplay, empty.error().message);
    const auto page = pageWith(content.value(), std::move(empty.value()));
    if (!page) return fail(kExitNoDisplay, path.value().string() + ": " + page.error().message);
    const auto written = se::writeFileAtomically(options.exported->path, page.value());
    return written ? kExitGood : fail(kExitInternal, written.error().message);
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

/// Cost of one kind of move, frame by frame.
void benchMoves(const Options& options, Offscreen& offscreen, Application& application,
                const char* what, void (*move)(Application&)) {
    constexpr int kWarmUp = 10;
    std::vector<double> own;
    std::vector<double> gl;
    std::vector<double> processor;
    std::vector<double> thread;
    for (int i = -kWarmUp; i < options.benchFrames; ++i) {
        const auto began = std::chrono::steady_clock::now();
        const std::clock_t before = std::clock();
        const double threadBefore = threadSeconds();
        move(application);
        const std::chrono::duration<double> moved = std::chrono::steady_clock::now() - began;
        offscreen.beginFrame();
        application.frame(offscreen.size(), 1.0 / 60.0);
        if (i < 0) continue;
        own.push_back(moved.count() + application.uiSeconds());
        gl.push_back(application.glSeconds());
        thread.push_back(threadSeconds() - threadBefore);
        processor.push_back(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
    std::printf("%d frames, %s\n", options.benchFrames, what);
    printTimes("  our own time", own);
    printTimes("  OpenGL, until it is done", gl);
    printTimes("  processor, this thread", thread);
    printTimes("  processor, all threads", processor);
}

/// Cost of frames in which only the camera moves, and of frames in which only panels differ.
void benchStill(const Options& options, Offscreen& target, Application& application) {
    benchMoves(options, target, application, "the camera turns", [](Application& each) {
        each.camera().orbit({8.0F, 3.0F}, 800.0F);
    });
    benchMoves(options, target, application, "the picture stays, the panels are drawn again",
               [](Application& each) { each.redraw(); });
    benchMoves(options, target, application, "nothing moves: equal frames, not drawn",
               [](Application&) {});
}

/// Cost of frames in which a neighbor of the pivot is dragged, with the pivot made again for each.
void benchDrag(const Options& options, Offscreen& target, Application& application) {
    PointDrag& drag = application.session().drag();
    const se::Index pivot = application.session().picture().pivot;
    const auto& lists = application.session().model().points.neighbors;
    if (!drag.possible(pivot) || lists[pivot].empty()) return;
    drag.begin(lists[pivot][0]);
    benchMoves(options, target, application, "a neighbor of the pivot is dragged",
               [](Application& each) {
                   PointDrag& held = each.session().drag();
                   const Model& model = held.model();
                   held.moveTo(held.to() + se::Vec3(1e-3 * model.spacing / model.scale, 0.0, 0.0));
               });
    drag.takeBack();
}

/// Cost of frames while other settings are tried (trial.h), if the input lasts long enough.
void benchBesideTrials(const Options& options, Offscreen& target, Application& application) {
    application.session().trials().start();
    benchMoves(options, target, application, "one pivot each, while other settings are tried",
               [](Application& each) { each.session().moves().stepPivot(1); });
    if (!application.session().trials().busy()) std::printf("  (the trials ended before)\n");
    application.session().trials().stop();
}

/// Steps through the run and prints the cost of a frame: the move, user interface and scene, and
/// separately that of OpenGL.
int runBench(const Options& options) {
    const ViewSettings settings = settingsFor(options, keptSettings(options));
    const glm::ivec2 size(settings.width, settings.height);
    const auto offscreen = Offscreen::create(size);
    if (!offscreen) return fail(kExitNoDisplay, offscreen.error().message);
    Application application(options, settings);
    if (const auto status = application.start(1.0F); !status) {
        return fail(kExitNoDisplay, status.error().message);
    }
    // As with a window: fonts and the empty panels while the input is being read.
    const auto draw = [&] {
        offscreen.value()->beginFrame();
        application.frame(size, 1.0 / 60.0);
    };
    while (!application.session().ready() && !application.inputFailed()) {
        draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(15));
    }
    draw();
    if (const int code = waitUntilDone(application); code != kExitGood) return code;
    std::printf("%zu points at %dx%d; first frame %.3f s after the start\n",
                application.session().model().points.size(), size.x, size.y,
                application.firstFrameSeconds());
    std::printf(
        "window %.3f s after the start; at most %.0f ms from frame to frame while opening\n",
        application.firstWindowSeconds(), 1e3 * application.longestOpeningSeconds());
    Offscreen& target = *offscreen.value();
    benchMoves(options, target, application, "one sub-step each",
               [](Application& each) { each.session().moves().stepEvent(1); });
    benchMoves(options, target, application, "one pivot each",
               [](Application& each) { each.session().moves().stepPivot(1); });
    benchMoves(options, target, application, "one pivot back each",
               [](Application& each) { each.session().moves().stepPivot(-1); });
    benchMoves(options, target, application, "a click on the middle each", [](Application& each) {
        Session& session = each.session();
        Camera camera;
        frameModel(session.model(), {}, camera);
        const PickScene scene{session.model(), true, session.shownTriangles(),
                              session.picture().repaired ? nullptr : &session.meshIndex(),
                              session.picture().rings};
        session.select(pick(scene, {camera.matrices(1.6F), {1280, 800}, {640, 400}, 9.6F}).what);
    });
    benchStill(options, target, application);
    benchDrag(options, target, application);
    benchBesideTrials(options, target, application);
    return dumpState(application);
}

/// Draws until the user quits, or `frames` frames if that is not 0.
void drawFrames(Window& window, Application& application, int frames) {
    window.attach(application);
    for (int drawn = 0; !application.wantsToQuit() && (frames == 0 || drawn < frames);) {
        // The number of frames is given, whether anything moves or not.
        if (frames > 0) window.wake();
        if (window.turn()) ++drawn;
    }
    window.detach();
}

int runWindow(const Options& options) {
    const ViewSettings kept = keptSettings(options);
    const ViewSettings settings = settingsFor(options, kept);
    const auto window = Window::create({settings.width, settings.height});
    if (!window) return fail(kExitNoDisplay, window.error().message);
    Application application(options, settings);
    if (!options.noConfig) application.keepIn(statePath());
    if (const auto status = application.start(window.value()->contentScale()); !status) {
        return fail(kExitNoDisplay, status.error().message);
    }
    drawFrames(*window.value(), application, options.frames);
    if (!options.noConfig) {
        const auto written =
            writeSettings(settingsPath(), kept, settingsToKeep(options, application, kept));
        if (!written) fail(kExitGood, written.error().message);
    }
    return dumpState(application);
}

}  // namespace

int main(int argc, char** argv) {
    se::returnFreedMemory();
    se::removeUnfinishedFilesAtSignals(
        "\nspiraling-edge-viewer: interrupted; no file is left half written\n");
    try {
        ParsedOptions parsed = parseOptions(argc, argv);
        if (!parsed.options) return parsed.exitCode;
        Options& options = *parsed.options;
        for (const auto adopt : {adoptLesson, adoptSession, adoptStart, adoptStandardInput}) {
            if (const auto status = adopt(options); !status)
                return fail(kExitInput, status.error().message);
        }
        int code = kExitUsage;
        if (const auto status = adoptLesson(options, code); !status)
            return fail(code, status.error().message);
        if (const auto status = chooseComparison(options); !status) {
            return fail(kExitUsage, status.error().message);
        }
        if (const auto status = requireInputsKept(options); !status)
            return fail(kExitUsage, status.error().message);
        if (options.benchFrames > 0) return runBench(options);
        if (options.exported && options.exported->program) return writeProgram(options);
        if (options.exported) return runExport(options);
        return options.screenshot.empty() ? runWindow(options) : runPicture(options);
    } catch (const std::exception& e) {
        return fail(kExitInternal, std::string("internal error: ") + e.what());
    }
}
