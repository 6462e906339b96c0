// The viewer's program in a page: options from its address, then a window whose turns the page
// calls. What these functions throw ends the program with a sentence in the page.
#include <emscripten/emscripten.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <cfloat>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "application.h"
#include "document/document.h"
#include "document/link.h"
#include "document/link_actions.h"
#include "lesson/lesson_walk.h"
#include "options.h"
#include "panel_state/settings.h"
#include "run/strings.h"
#include "session/session.h"
#include "teach/result.h"
#include "window.h"

namespace {

using namespace se::view;

static_assert(sizeof(ImDrawIdx) == 4, "the start page of a large window has over 65,536 corners");

/// The program of the page: it lives as long as the page does.
struct Program {
    Options options;
    ViewSettings kept;
    std::unique_ptr<Window> window;
    std::unique_ptr<Application> application;
    // Values last sent to the page.
    std::string answers;  ///< To the questions of the lesson.
    std::string notice;   ///< Shown beside the sentences of steps.

    UiState& ui() { return application->context().ui; }
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

/// Makes a call, unless the program has not begun. What it throws ends the program.
template <typename Call>
void withProgram(Call call) {
    try {
        if (theProgram() != nullptr) call(*theProgram());
    } catch (const std::exception& e) {
        EM_ASM({ Module.stopped(UTF8ToString($0)); }, e.what());
    }
}

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

/// Sends new answers of the open lesson to the page around.
void sendAnswers(Program& program) {
    const LessonWalk& walk = program.ui().lesson.walk;
    if (!walk.isOpen() || !walk.hasAnswers()) return;
    std::string answers = se::teach::resultJson(walk.result());
    if (answers == program.answers) return;
    program.answers = std::move(answers);
    EM_ASM({ Module.tellAround({answered : $0, result : JSON.parse(UTF8ToString($1))}); },
           static_cast<int>(walk.step() + 1), program.answers.c_str());
}

/// Sends what the program says beside the sentences of steps: a notice, or why nothing was opened.
void sendNotice(Program& program) {
    const Session& session = program.application->session();
    const bool failed = session.input().phase() == SessionPhase::Failed;
    const std::string& now = failed ? session.input().error() : session.messages().notice();
    if (std::exchange(program.notice, now) == now || now.empty()) return;
    EM_ASM({ Module.read(UTF8ToString($0)); }, se::printable(now).c_str());
}

/// The innermost list that scrolls at a position of the screen; null if there is none.
ImGuiWindow* listAt(ImVec2 position) {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    for (int i = imgui.Windows.Size; i-- > 0;) {
        ImGuiWindow* window = imgui.Windows[i];
        if (!window->WasActive || (window->Flags & ImGuiWindowFlags_NoMouseInputs) != 0 ||
            !window->OuterRectClipped.Contains(position))
            continue;
        while (window != nullptr && window->ScrollMax.y <= 0.0F) window = window->ParentWindow;
        return window;
    }
    return nullptr;
}

/// Begins the program at a link; `page` is the address of the page without it, `theme` that of the
/// page around, or of the system. An exit code.
int begin(const std::string& page, const std::string& link, const char* theme) {
    auto options = optionsFromLink(link);
    if (!options) return fail(kExitUsage, options.error().message);
    auto& program = theProgram() = std::make_unique<Program>();
    program->options = std::move(options.value());
    if (const auto status = adoptInputs(program->options); !status)
        return fail(kExitInput, status.error().message);
    program->options.narrate = true;  // for those who cannot see the picture
    program->kept = keptSettings(program->options, themeFromName(theme).value_or(Theme::Dark));
    const ViewSettings settings = settingsFor(program->options, program->kept);
    auto window = Window::create({settings.width, settings.height});
    if (!window) return fail(kExitNoDisplay, window.error().message);
    program->window = std::move(window.value());
    program->application = std::make_unique<Application>(program->options, settings);
    program->ui().hostFiles.pick = [] { EM_ASM({ Module.pick(); }); };
    program->ui().pageAddress = page;
    if (!program->options.noConfig) program->application->keepIn(statePath());
    if (const auto status = program->application->start(program->window->contentScale()); !status)
        return fail(kExitNoDisplay, status.error().message);
    program->window->attach(*program->application);
    return kExitGood;
}

}  // namespace

extern "C" {

/// Begins the program; see begin().
EMSCRIPTEN_KEEPALIVE int webBegin(const char* page, const char* link, const char* theme) {
    try {
        return begin(page, link, theme);
    } catch (const std::exception& e) {
        EM_ASM({ Module.stopped(UTF8ToString($0)); }, e.what());
        return kExitInternal;
    }
}

/// One turn of the window's loop; a value of Turn.
EMSCRIPTEN_KEEPALIVE int webTurn() {
    Turn next = kSleep;
    withProgram([&next](Program& program) {
        const bool again = program.window->turn() || program.application->animating();
        const bool notice = !program.application->session().messages().notice().empty();
        next = again ? kAgain : notice ? kLater : kSleep;
        sendAnswers(program);
        sendNotice(program);
    });
    return next;
}

/// Goes to an address, or where a link leads.
EMSCRIPTEN_KEEPALIVE void webGo(const char* text) {
    withProgram([text](Program& program) {
        actions::follow(program.application->context(), text);
        program.window->wake();
    });
}

/// Shows a sentence.
EMSCRIPTEN_KEEPALIVE void webSay(const char* text) {
    withProgram([text](Program& program) {
        program.application->session().messages().say(text);
        program.window->wake();
    });
}

/// Takes the theme of the page around, unless the reader has chosen one.
EMSCRIPTEN_KEEPALIVE void webTheme(const char* name) {
    withProgram([name](Program& program) {
        const auto known = themeFromName(name);
        if (!known) return;
        const Theme theme = *known;
        if (program.options.theme || program.ui().settings.theme != program.kept.theme ||
            keptSettings(program.options, theme).theme != theme)
            return;
        program.kept.theme = program.ui().settings.theme = theme;
        program.window->wake();
    });
}

/// Whether pictures may move: 0 if little motion is asked for.
EMSCRIPTEN_KEEPALIVE void webMotion(int moves) {
    withProgram([moves](Program& program) { program.ui().reducedMotion = moves == 0; });
}

/// Takes over that the page has entered or left full screen.
EMSCRIPTEN_KEEPALIVE void webFullScreen(int full) {
    withProgram([full](Program& program) { program.ui().fullScreen = full != 0; });
}

/// Scrolls the list at a position, by pixels; 0 if there is none.
EMSCRIPTEN_KEEPALIVE int webScroll(float x, float y, float by) {
    ImGuiWindow* list = nullptr;
    withProgram([&list, x, y, by](Program& program) {
        list = listAt({x, y});
        if (list == nullptr || by == 0.0F) return;
        // Several moves may come before the next frame.
        const bool scrolls = list->ScrollTarget.y < FLT_MAX;
        ImGui::SetScrollY(list, (scrolls ? list->ScrollTarget.y : list->Scroll.y) - by);
        program.window->wake();
    });
    return list != nullptr ? 1 : 0;
}

/// 1 while a text field has the focus.
EMSCRIPTEN_KEEPALIVE int webTyping() {
    bool typing = false;
    withProgram([&typing](Program&) { typing = ImGui::GetIO().WantTextInput; });
    return typing ? 1 : 0;
}

/// 1 if work would be lost with the page.
EMSCRIPTEN_KEEPALIVE int webUnsaved() {
    bool unsaved = false;
    withProgram([&unsaved](Program& program) {
        unsaved = !program.application->context().document.atStake().empty();
    });
    return unsaved ? 1 : 0;
}

/// Writes the settings, for the page to keep.
EMSCRIPTEN_KEEPALIVE void webKeep() {
    withProgram([](Program& program) {
        if (program.options.noConfig) return;
        const ViewSettings now =
            settingsToKeep(program.options, *program.application, program.kept);
        if (writeSettings(settingsPath(), program.kept, now)) program.kept = now;
    });
}
}
