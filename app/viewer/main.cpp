#include <cstdio>
#include <exception>

#include "application.h"
#include "offscreen.h"
#include "options.h"
#include "settings.h"
#include "window.h"

namespace {

using namespace se::view;

int fail(int code, const std::string& message) {
    std::fprintf(stderr, "spiraling-edge-viewer: %s\n", message.c_str());
    return code;
}

ViewSettings settingsFor(const Options& options) {
    ViewSettings settings;
    if (!options.noConfig && options.screenshot.empty()) {
        const se::Result<ViewSettings> read = readSettings(settingsPath());
        if (read) settings = read.value();
    }
    if (options.size) {
        settings.width = options.size->x;
        settings.height = options.size->y;
    }
    if (options.theme) settings.theme = *options.theme;
    if (options.uiScale > 0.0) settings.uiScale = options.uiScale;
    return settings;
}

/// What was given on the command line holds for this once.
ViewSettings settingsToKeep(const Options& options, const Application& application) {
    ViewSettings keep = application.settings();
    const se::Result<ViewSettings> read = readSettings(settingsPath());
    const ViewSettings before = read ? read.value() : ViewSettings{};
    if (options.theme) keep.theme = before.theme;
    if (options.uiScale > 0.0) keep.uiScale = before.uiScale;
    if (options.size) keep.width = before.width;
    if (options.size) keep.height = before.height;
    return keep;
}

int runPicture(const Options& options) {
    const ViewSettings settings = settingsFor(options);
    const auto offscreen = Offscreen::create({settings.width, settings.height});
    if (!offscreen) return fail(kExitNoDisplay, offscreen.error().message);
    Application application(options, settings);
    if (const auto status = application.start(1.0F); !status) {
        return fail(kExitNoDisplay, status.error().message);
    }
    if (const auto status = application.settle(); !status) {
        return fail(application.inputFailed() ? kExitInput : kExitUsage, status.error().message);
    }
    // The first frames only find out how large things are.
    const int frames = options.frames > 0 ? options.frames : 4;
    for (int i = 0; i < frames; ++i) {
        offscreen.value()->beginFrame();
        application.frame({settings.width, settings.height}, 1.0 / 60.0);
    }
    const auto status = offscreen.value()->save(options.screenshot);
    return status ? kExitGood : fail(kExitInput, status.error().message);
}

int runWindow(const Options& options) {
    ViewSettings settings = settingsFor(options);
    const auto window = Window::create({settings.width, settings.height});
    if (!window) return fail(kExitNoDisplay, window.error().message);
    Application application(options, settings);
    if (const auto status = application.start(window.value()->contentScale()); !status) {
        return fail(kExitNoDisplay, status.error().message);
    }
    window.value()->run(application, options.frames);
    if (!options.noConfig) {
        const auto written = writeSettings(settingsPath(), settingsToKeep(options, application));
        if (!written) fail(kExitGood, written.error().message);
    }
    return kExitGood;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const ParsedOptions parsed = parseOptions(argc, argv);
        if (!parsed.options) return parsed.exitCode;
        return parsed.options->screenshot.empty() ? runWindow(*parsed.options)
                                                  : runPicture(*parsed.options);
    } catch (const std::exception& e) {
        return fail(kExitInternal, std::string("internal error: ") + e.what());
    }
}
