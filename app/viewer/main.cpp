// The viewer's program: options, then a window or pictures.
#include <array>
#include <cstdio>
#include <exception>

#include "application.h"
#include "document/app_page.h"
#include "export_run.h"
#include "offscreen.h"
#include "options.h"
#include "run/strings.h"
#include "scene/picture.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/operating_system.h"
#include "window.h"

namespace {

using namespace se::view;

int fail(int code, const std::string& message) {
    printLines(stderr, "spiraling-edge-viewer: " + se::printable(message) + "\n");
    return code;
}

/// Shows the requested view, without a window.
int prepareOffscreen(Application& application) {
    if (const auto status = application.start(1.0F); !status)
        return fail(kExitNoDisplay, status.error().message);
    const auto status = application.waitUntilDone();
    if (status) return kExitGood;
    return fail(application.inputFailed() ? kExitInput : kExitUsage, status.error().message);
}

int writeState(Application& application) {
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
    return writeState(application);
}

/// Progress on a terminal, as of the command line.
void showProgress(const ExportRun& run) {
    if (!se::os::isTerminal(se::os::Stream::Error) || run.total() < 2) return;
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
    const auto path = findPage(se::os::programPath().parent_path());
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
    return writeState(application);
}

}  // namespace

int main(int argc, char** argv) {
    se::os::returnFreedMemory();
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
        if (options.exported && options.exported->program) return writeProgram(options);
        if (options.exported) return runExport(options);
        return options.screenshot.empty() ? runWindow(options) : runPicture(options);
    } catch (const std::exception& e) {
        return fail(kExitInternal, std::string("internal error: ") + e.what());
    }
}
