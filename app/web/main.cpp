// The viewer's program in a page: options from its address, then a window whose turns the page
// calls.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "application.h"
#include "document/link.h"
#include "document/link_actions.h"
#include "options.h"
#include "panel_state/settings.h"
#include "run/strings.h"
#include "start_settings.h"
#include "window.h"

namespace {

using namespace se::view;

/// The program of the page: it lives as long as the page does.
struct Program {
    Options options;
    ViewSettings kept;
    std::unique_ptr<Window> window;
    std::unique_ptr<Application> application;
    std::string sentence;  ///< As the page has it.
    std::string title;
};
std::unique_ptr<Program>& theProgram() {
    static std::unique_ptr<Program> program;
    return program;
}

/// What the page is to do after a turn.
enum Turn : int {
    kSleep = 0,  ///< Until there is input.
    kAgain = 1,  ///< In the next frame.
    kLater = 2,  ///< After a while: something ends by the clock.
};

/// Says in the page why there is no program.
int fail(int code, const std::string& sentence) {
    EM_ASM({ Module.failed(UTF8ToString($0)); }, se::printable(sentence).c_str());
    return code;
}

/// Fails with a sentence.
se::Status adoptInputs(Options& options) {
    for (const auto adopt : {adoptLesson, adoptSession, adoptStart})
        if (se::Status status = adopt(options); !status) return status;
    return chooseComparison(options);
}

}  // namespace

extern "C" {

/// One turn of the window's loop; a value of Turn.
EMSCRIPTEN_KEEPALIVE int webTurn() {
    Program& program = *theProgram();
    if (program.window->turn()) return kAgain;
    const Application& application = *program.application;
    if (application.animating()) return kAgain;
    return program.application->session().messages().notice().empty() ? kSleep : kLater;
}

/// Goes to an address, or where a link leads.
EMSCRIPTEN_KEEPALIVE void webGo(const char* text) {
    actions::follow(theProgram()->application->context(), text);
    theProgram()->window->wake();
}

/// Writes the settings, for the page to keep.
EMSCRIPTEN_KEEPALIVE void webKeep() {
    Program& program = *theProgram();
    if (program.options.noConfig) return;
    const ViewSettings now = settingsToKeep(program.options, *program.application, program.kept);
    if (writeSettings(settingsPath(), program.kept, now)) program.kept = now;
}
}

/// Takes the address of the page, and the theme of what is around it.
int main(int, char** argv) {
    try {
        const std::string address = argv[1];
        const std::size_t sign = std::min(address.find('#'), address.size());
        auto options = optionsFromLink(address.substr(sign));
        if (!options) return fail(kExitUsage, options.error().message);
        auto& program = theProgram() = std::make_unique<Program>();
        program->options = std::move(options.value());
        if (const auto status = adoptInputs(program->options); !status)
            return fail(kExitInput, status.error().message);
        program->options.narrate = true;  // for those who cannot see the picture
        program->kept = keptSettings(program->options);
        // Until the reader has chosen a theme, that of the page around.
        std::error_code error;
        if (!std::filesystem::exists(settingsPath(), error))
            program->kept.theme = themeFromName(argv[2]).value_or(Theme::Dark);
        const ViewSettings settings = settingsFor(program->options, program->kept);
        auto window = Window::create({settings.width, settings.height});
        if (!window) return fail(kExitNoDisplay, window.error().message);
        program->window = std::move(window.value());
        program->application = std::make_unique<Application>(program->options, settings);
        program->application->context().ui.hostFiles.pick = [] { EM_ASM({ Module.pick(); }); };
        program->application->context().ui.pageAddress = address.substr(0, sign);
        if (!program->options.noConfig) program->application->keepIn(statePath());
        if (const auto status = program->application->start(program->window->contentScale());
            !status)
            return fail(kExitNoDisplay, status.error().message);
        program->window->attach(*program->application);
        EM_ASM({ Module.begin(); });
        return kExitGood;
    } catch (const std::exception& e) {
        return fail(kExitInternal, std::string("internal error: ") + e.what());
    }
}
