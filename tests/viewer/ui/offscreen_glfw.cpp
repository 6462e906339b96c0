// GLFW without a display, for tests: the calls that the viewer and Dear ImGui make, for one window
// whose content is in memory. Loaded before the real library (LD_PRELOAD), it lets the program run
// as it is, on any machine, many beside each other. Input comes as xdotool's words: a line of the
// pipe SE_INPUT is a command whose words are separated by tabs, such as "key\tctrl+F10" or
// "mousemove\t10\t20\tclick\t1". Answers go to the pipe SE_ANSWERS, a line for each question.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLFW/glfw3.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kScreenWidth = 1700;
constexpr int kScreenHeight = 1000;
/// Name of the window in scenarios.
constexpr std::string_view kWindow = "this";

/// Signs of a key of an American keyboard, alone and with Shift.
struct Key {
    int key;
    char plain;
    char shifted;
};

/// The keys with a sign, by their place on the keyboard.
std::optional<Key> keyOfSign(char sign) {
    static constexpr std::string_view kPlain = "`1234567890-=[]\\;',./ ";
    static constexpr std::string_view kShifted = "~!@#$%^&*()_+{}|:\"<>? ";
    if (std::isalpha(static_cast<unsigned char>(sign)) != 0) {
        const int upper = std::toupper(static_cast<unsigned char>(sign));
        return Key{upper, static_cast<char>(std::tolower(upper)), static_cast<char>(upper)};
    }
    std::size_t place = kPlain.find(sign);
    if (place == std::string_view::npos) place = kShifted.find(sign);
    if (place == std::string_view::npos) return std::nullopt;
    return Key{kPlain[place], kPlain[place], kShifted[place]};
}

/// Keys by the names that the display server has for them.
struct NamedKey {
    std::string_view name;
    int key;
    char sign;
};
constexpr NamedKey kNamedKeys[] = {
    {"Return", GLFW_KEY_ENTER, 0},
    {"Escape", GLFW_KEY_ESCAPE, 0},
    {"Tab", GLFW_KEY_TAB, 0},
    {"ISO_Left_Tab", GLFW_KEY_TAB, 0},
    {"BackSpace", GLFW_KEY_BACKSPACE, 0},
    {"Delete", GLFW_KEY_DELETE, 0},
    {"Insert", GLFW_KEY_INSERT, 0},
    {"Left", GLFW_KEY_LEFT, 0},
    {"Right", GLFW_KEY_RIGHT, 0},
    {"Up", GLFW_KEY_UP, 0},
    {"Down", GLFW_KEY_DOWN, 0},
    {"Home", GLFW_KEY_HOME, 0},
    {"End", GLFW_KEY_END, 0},
    {"Prior", GLFW_KEY_PAGE_UP, 0},
    {"Next", GLFW_KEY_PAGE_DOWN, 0},
    {"Page_Up", GLFW_KEY_PAGE_UP, 0},
    {"Page_Down", GLFW_KEY_PAGE_DOWN, 0},
    {"Menu", GLFW_KEY_MENU, 0},
    {"KP_Enter", GLFW_KEY_KP_ENTER, 0},
    {"space", 0, ' '},
    {"grave", 0, '`'},
    {"period", 0, '.'},
    {"comma", 0, ','},
    {"slash", 0, '/'},
    {"question", 0, '?'},
    {"equal", 0, '='},
    {"plus", 0, '+'},
    {"minus", 0, '-'},
    {"bracketleft", 0, '['},
    {"bracketright", 0, ']'},
    {"semicolon", 0, ';'},
    {"apostrophe", 0, '\''},
    {"backslash", 0, '\\'},
    {"less", 0, '<'},
    {"greater", 0, '>'},
    {"colon", 0, ':'},
    {"asterisk", 0, '*'},
    {"underscore", 0, '_'},
};

struct Modifier {
    std::string_view name;
    int key;
    int bit;
};
constexpr Modifier kModifiers[] = {
    {"ctrl", GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL},
    {"Control_L", GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL},
    {"shift", GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT},
    {"Shift_L", GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT},
    {"alt", GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT},
    {"Alt_L", GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT},
};

const Modifier* modifierOf(std::string_view name) {
    const auto* found = std::find_if(std::begin(kModifiers), std::end(kModifiers),
                                     [&](const Modifier& each) { return each.name == name; });
    return found == std::end(kModifiers) ? nullptr : found;
}

/// A key by name, and whether Shift belongs to it.
struct Stroke {
    int key = GLFW_KEY_UNKNOWN;
    unsigned sign = 0;
    unsigned shiftedSign = 0;
    bool shift = false;
};

Stroke strokeOfSign(unsigned sign) {
    const auto key = sign < 128 ? keyOfSign(static_cast<char>(sign)) : std::nullopt;
    if (!key) return {GLFW_KEY_UNKNOWN, sign, sign, false};
    const auto plain = static_cast<unsigned char>(key->plain);
    const auto shifted = static_cast<unsigned char>(key->shifted);
    return {key->key, plain, shifted, sign != plain};
}

Stroke strokeNamed(std::string_view name) {
    for (const NamedKey& each : kNamedKeys) {
        if (each.name != name) continue;
        if (each.sign == 0) return {each.key};
        return strokeOfSign(static_cast<unsigned char>(each.sign));
    }
    if (name.size() >= 2 && name[0] == 'F' && std::isdigit(name[1]) != 0)
        return {GLFW_KEY_F1 + std::atoi(name.data() + 1) - 1};
    if (name.size() == 1) return strokeOfSign(static_cast<unsigned char>(name[0]));
    std::fprintf(stderr, "offscreen window: no key is called %s\n", std::string(name).c_str());
    std::abort();
}

/// The characters of a text in UTF-8.
std::vector<unsigned> signsOf(std::string_view text) {
    std::vector<unsigned> signs;
    for (const char each : text) {
        const auto byte = static_cast<unsigned char>(each);
        if ((byte & 0xC0U) == 0x80U) {
            signs.back() = signs.back() << 6U | (byte & 0x3FU);
        } else {
            signs.push_back(byte < 0x80U ? byte : byte & (byte < 0xE0U ? 0x1FU : 0x0FU));
        }
    }
    return signs;
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> words;
    for (std::size_t from = 0; from <= line.size();) {
        const std::size_t to = std::min(line.find('\t', from), line.size());
        words.emplace_back(line.substr(from, to - from));
        from = to + 1;
    }
    return words;
}

/// The window, its picture, and the input that comes to it.
class Window {
  public:
    bool open(int width, int height);
    void poll(double seconds);
    void resize(int width, int height);
    void rename(const char* title) { title_ = title; }

    void* user = nullptr;
    int width = 0;
    int height = 0;
    double x = -1.0;
    double y = -1.0;
    std::array<bool, 8> buttons{};
    bool closes = false;
    GLFWmonitor* monitor = nullptr;
    std::string clipboard;
    GLFWkeyfun onKey = nullptr;
    GLFWcharfun onChar = nullptr;
    GLFWmousebuttonfun onButton = nullptr;
    GLFWcursorposfun onMove = nullptr;
    GLFWcursorenterfun onEnter = nullptr;
    GLFWscrollfun onScroll = nullptr;
    GLFWdropfun onDrop = nullptr;
    GLFWframebuffersizefun onSize = nullptr;

  private:
    GLFWwindow* self() { return reinterpret_cast<GLFWwindow*>(this); }
    void makeSurface();
    void obey(const std::vector<std::string>& words);
    std::size_t obeyOne(const std::vector<std::string>& words, std::size_t at);
    void key(int code, int action);
    void hold(const Modifier& modifier, bool down);
    void stroke(const Stroke& stroke, bool down);
    void chord(std::string_view text);
    void type(unsigned sign);
    void move(double toX, double toY);
    void button(int number, bool down);
    void wheel(int number);
    void click(int number);
    void answer(const std::string& line) const;
    void savePicture(const std::string& path) const;

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLConfig config_ = nullptr;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
    int input_ = -1;
    int answers_ = -1;
    int mods_ = 0;
    std::string unread_;
    std::string title_;
};

Window& theWindow() {
    static Window window;
    return window;
}

bool Window::open(int openedWidth, int openedHeight) {
    width = openedWidth;
    height = openedHeight;
    input_ = ::open(std::getenv("SE_INPUT"), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    answers_ = ::open(std::getenv("SE_ANSWERS"), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getDisplay == nullptr || input_ < 0 || answers_ < 0) return false;
    display_ = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              3,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    EGLint count = 0;
    if (eglInitialize(display_, nullptr, nullptr) != EGL_TRUE ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE ||
        eglChooseConfig(display_, wanted, &config_, 1, &count) != EGL_TRUE || count == 0)
        return false;
    context_ = eglCreateContext(display_, config_, EGL_NO_CONTEXT, version);
    makeSurface();
    return context_ != EGL_NO_CONTEXT && surface_ != EGL_NO_SURFACE;
}

void Window::makeSurface() {
    const EGLSurface before = surface_;
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config_, size);
    eglMakeCurrent(display_, surface_, surface_, context_);
    if (before != EGL_NO_SURFACE) eglDestroySurface(display_, before);
}

void Window::resize(int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
    makeSurface();
    if (onSize != nullptr) onSize(self(), width, height);
}

/// Waits for input at most so long, and passes on all that is there.
void Window::poll(double seconds) {
    pollfd ready{input_, POLLIN, 0};
    if (unread_.empty()) ::poll(&ready, 1, static_cast<int>(1e3 * seconds));
    std::array<char, 4096> bytes{};
    for (ssize_t count = 0; (count = read(input_, bytes.data(), bytes.size())) > 0;)
        unread_.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = unread_.find('\n')) != std::string::npos;) {
        const std::vector<std::string> words = split(std::string_view(unread_).substr(0, end));
        unread_.erase(0, end + 1);
        obey(words);
    }
}

void Window::obey(const std::vector<std::string>& words) {
    for (std::size_t at = 0; at < words.size();) at = obeyOne(words, at);
}

/// Obeys the command that begins at a word; returns the place of the next one.
std::size_t Window::obeyOne(const std::vector<std::string>& words, std::size_t at) {
    const std::string& what = words[at++];
    int times = 1;
    // Options: how often. Delays, windows and waiting have no meaning here.
    while (at < words.size() && (words[at].starts_with("--") || words[at] == kWindow)) {
        const std::string& option = words[at++];
        if (option == "--") break;
        if (option == "--repeat") times = std::atoi(words[at].c_str());
        if (option == "--repeat" || option == "--delay") ++at;
    }
    const auto number = [&] { return std::atoi(words.at(at++).c_str()); };
    const auto isCommand = [&] {
        static constexpr std::string_view kCommands[] = {"key",       "keydown", "keyup", "type",
                                                         "mousedown", "mouseup", "click"};
        return std::find(std::begin(kCommands), std::end(kCommands), words[at]) !=
               std::end(kCommands);
    };
    if (what == "key" || what == "keydown" || what == "keyup") {
        for (; at < words.size() && !isCommand(); ++at) {
            if (what == "key") {
                chord(words[at]);
            } else if (const Modifier* modifier = modifierOf(words[at])) {
                hold(*modifier, what == "keydown");
            } else {
                stroke(strokeNamed(words[at]), what == "keydown");
            }
        }
    } else if (what == "type") {
        for (; at < words.size(); ++at)
            for (const unsigned sign : signsOf(words[at])) type(sign);
    } else if (what == "mousemove") {
        const int toX = number();
        move(toX, number());
    } else if (what == "mousemove_relative") {
        const int byX = number();
        move(x + byX, y + number());
    } else if (what == "mousedown" || what == "mouseup") {
        button(number(), what == "mousedown");
    } else if (what == "click") {
        const int which = number();
        for (int i = 0; i < times; ++i) click(which);
    } else if (what == "windowsize") {
        const int toWidth = number();
        resize(toWidth, number());
    } else if (what == "getmouselocation") {
        answer("x:" + std::to_string(int(x)) + " y:" + std::to_string(int(y)));
    } else if (what == "getwindowgeometry") {
        answer("X=0 Y=0 WIDTH=" + std::to_string(width) + " HEIGHT=" + std::to_string(height));
    } else if (what == "getwindowname") {
        answer(title_);
    } else if (what == "import") {
        savePicture(words.at(at++));
        answer("saved");
    } else {
        std::fprintf(stderr, "offscreen window: what is %s?\n", what.c_str());
        std::abort();
    }
    return at;
}

void Window::key(int code, int action) {
    if (onKey != nullptr) onKey(self(), code, code, action, mods_);
}

/// As the display server reports it: the state of the modifiers before the event.
void Window::hold(const Modifier& modifier, bool down) {
    key(modifier.key, down ? GLFW_PRESS : GLFW_RELEASE);
    mods_ = down ? mods_ | modifier.bit : mods_ & ~modifier.bit;
}

void Window::stroke(const Stroke& stroke, bool down) {
    key(stroke.key, down ? GLFW_PRESS : GLFW_RELEASE);
    const bool plain = (mods_ & (GLFW_MOD_CONTROL | GLFW_MOD_ALT)) == 0;
    const unsigned sign = (mods_ & GLFW_MOD_SHIFT) != 0 ? stroke.shiftedSign : stroke.sign;
    if (down && plain && sign != 0 && onChar != nullptr) onChar(self(), sign);
}

/// "ctrl+shift+F10"
void Window::chord(std::string_view text) {
    std::vector<const Modifier*> held;
    for (std::size_t plus = 0; (plus = text.find('+')) != std::string_view::npos && plus > 0;) {
        held.push_back(modifierOf(text.substr(0, plus)));
        text.remove_prefix(plus + 1);
    }
    const Stroke last = strokeNamed(text);
    const Modifier* shift = modifierOf("shift");
    if (last.shift && std::find(held.begin(), held.end(), shift) == held.end())
        held.push_back(shift);
    for (const Modifier* each : held) hold(*each, true);
    stroke(last, true);
    stroke(last, false);
    for (auto each = held.rbegin(); each != held.rend(); ++each) hold(**each, false);
}

void Window::type(unsigned sign) {
    const Stroke typed = strokeOfSign(sign);
    const Modifier* shift = modifierOf("shift");
    if (typed.shift) hold(*shift, true);
    stroke(typed, true);
    stroke(typed, false);
    if (typed.shift) hold(*shift, false);
}

void Window::move(double toX, double toY) {
    if (x < 0.0 && onEnter != nullptr) onEnter(self(), GLFW_TRUE);
    x = toX;
    y = toY;
    if (onMove != nullptr) onMove(self(), x, y);
}

void Window::button(int number, bool down) {
    constexpr std::array kButtons = {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_MIDDLE,
                                     GLFW_MOUSE_BUTTON_RIGHT};
    const int which = kButtons.at(static_cast<std::size_t>(number - 1));
    buttons.at(static_cast<std::size_t>(which)) = down;
    if (onButton != nullptr) onButton(self(), which, down ? GLFW_PRESS : GLFW_RELEASE, mods_);
}

void Window::wheel(int number) {
    constexpr std::array<std::array<double, 2>, 4> kBy{{{0, 1}, {0, -1}, {1, 0}, {-1, 0}}};
    const auto& [byX, byY] = kBy.at(static_cast<std::size_t>(number - 4));
    if (onScroll != nullptr) onScroll(self(), byX, byY);
}

void Window::click(int number) {
    if (number > 3) return wheel(number);
    button(number, true);
    button(number, false);
}

void Window::answer(const std::string& line) const {
    const std::string text = line + "\n";
    if (write(answers_, text.data(), text.size()) < 0) std::perror("offscreen window");
}

/// As PPM, which has no options.
void Window::savePicture(const std::string& path) const {
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width * height) * 3);
    using ReadPixels = void (*)(int, int, int, int, unsigned, unsigned, void*);
    using PixelStore = void (*)(unsigned, int);
    using Bind = void (*)(unsigned, unsigned);
    constexpr unsigned kReadFramebuffer = 0x8CA8;
    constexpr unsigned kRgb = 0x1907;
    constexpr unsigned kUnsignedByte = 0x1401;
    constexpr unsigned kPackAlignment = 0x0D05;
    reinterpret_cast<Bind>(eglGetProcAddress("glBindFramebuffer"))(kReadFramebuffer, 0);
    reinterpret_cast<PixelStore>(eglGetProcAddress("glPixelStorei"))(kPackAlignment, 1);
    reinterpret_cast<ReadPixels>(eglGetProcAddress("glReadPixels"))(0, 0, width, height, kRgb,
                                                                    kUnsignedByte, pixels.data());
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return;
    std::fprintf(file, "P6\n%d %d\n255\n", width, height);
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    for (int line = height - 1; line >= 0; --line)
        std::fwrite(pixels.data() + static_cast<std::size_t>(line) * row, 1, row, file);
    std::fclose(file);
}

GLFWwindow* handle() { return reinterpret_cast<GLFWwindow*>(&theWindow()); }
GLFWmonitor* theMonitor() {
    static char monitor = 0;
    return reinterpret_cast<GLFWmonitor*>(&monitor);
}

}  // namespace

// NOLINTBEGIN: the names and types are GLFW's.
extern "C" {

int glfwInit() { return GLFW_TRUE; }
void glfwTerminate() {}
void glfwWindowHint(int, int) {}
GLFWwindow* glfwCreateWindow(int width, int height, const char*, GLFWmonitor*, GLFWwindow*) {
    return theWindow().open(width, height) ? handle() : nullptr;
}
void glfwDestroyWindow(GLFWwindow*) {}
void glfwShowWindow(GLFWwindow*) {}
void glfwMakeContextCurrent(GLFWwindow*) {}
GLFWglproc glfwGetProcAddress(const char* name) { return eglGetProcAddress(name); }
void glfwSwapInterval(int) {}
void glfwSwapBuffers(GLFWwindow*) {}
double glfwGetTime() {
    static const auto began = Clock::now();
    return std::chrono::duration<double>(Clock::now() - began).count();
}
void glfwPollEvents() { theWindow().poll(0.0); }
void glfwWaitEventsTimeout(double seconds) { theWindow().poll(seconds); }

void glfwSetWindowTitle(GLFWwindow*, const char* title) { theWindow().rename(title); }
void glfwSetWindowSizeLimits(GLFWwindow*, int, int, int, int) {}
void glfwGetWindowSize(GLFWwindow*, int* width, int* height) {
    *width = theWindow().width;
    *height = theWindow().height;
}
void glfwGetFramebufferSize(GLFWwindow* window, int* width, int* height) {
    glfwGetWindowSize(window, width, height);
}
void glfwGetWindowPos(GLFWwindow*, int* x, int* y) { *x = *y = 0; }
void glfwGetWindowContentScale(GLFWwindow*, float* x, float* y) { *x = *y = 1.0F; }
int glfwGetWindowAttrib(GLFWwindow*, int) { return GLFW_TRUE; }
int glfwWindowShouldClose(GLFWwindow*) { return theWindow().closes ? GLFW_TRUE : GLFW_FALSE; }
void glfwSetWindowShouldClose(GLFWwindow*, int value) { theWindow().closes = value == GLFW_TRUE; }
void glfwSetWindowUserPointer(GLFWwindow*, void* user) { theWindow().user = user; }
void* glfwGetWindowUserPointer(GLFWwindow*) { return theWindow().user; }
GLFWmonitor* glfwGetPrimaryMonitor() { return theMonitor(); }
GLFWmonitor* glfwGetWindowMonitor(GLFWwindow*) { return theWindow().monitor; }
const GLFWvidmode* glfwGetVideoMode(GLFWmonitor*) {
    static const GLFWvidmode mode{kScreenWidth, kScreenHeight, 8, 8, 8, 60};
    return &mode;
}
void glfwSetWindowMonitor(GLFWwindow*, GLFWmonitor* monitor, int, int, int width, int height, int) {
    theWindow().monitor = monitor;
    theWindow().resize(width, height);
}

int glfwGetMouseButton(GLFWwindow*, int button) {
    return theWindow().buttons.at(static_cast<std::size_t>(button)) ? GLFW_PRESS : GLFW_RELEASE;
}
void glfwGetCursorPos(GLFWwindow*, double* x, double* y) {
    *x = theWindow().x;
    *y = theWindow().y;
}
void glfwSetCursorPos(GLFWwindow*, double, double) {}
int glfwGetInputMode(GLFWwindow*, int) { return GLFW_CURSOR_NORMAL; }
void glfwSetInputMode(GLFWwindow*, int, int) {}
GLFWcursor* glfwCreateStandardCursor(int) { return nullptr; }
void glfwDestroyCursor(GLFWcursor*) {}
void glfwSetCursor(GLFWwindow*, GLFWcursor*) {}
const float* glfwGetJoystickAxes(int, int* count) {
    *count = 0;
    return nullptr;
}
const unsigned char* glfwGetJoystickButtons(int, int* count) {
    *count = 0;
    return nullptr;
}
const char* glfwGetKeyName(int key, int) {
    static char name[2];
    const auto known = key > 32 && key < 127 ? keyOfSign(static_cast<char>(key)) : std::nullopt;
    if (!known) return nullptr;
    name[0] = known->plain;
    return name;
}
const char* glfwGetClipboardString(GLFWwindow*) { return theWindow().clipboard.c_str(); }
void glfwSetClipboardString(GLFWwindow*, const char* text) { theWindow().clipboard = text; }

GLFWerrorfun glfwSetErrorCallback(GLFWerrorfun) { return nullptr; }
GLFWmonitorfun glfwSetMonitorCallback(GLFWmonitorfun) { return nullptr; }
GLFWwindowrefreshfun glfwSetWindowRefreshCallback(GLFWwindow*, GLFWwindowrefreshfun) {
    return nullptr;
}
GLFWwindowfocusfun glfwSetWindowFocusCallback(GLFWwindow*, GLFWwindowfocusfun) { return nullptr; }
GLFWkeyfun glfwSetKeyCallback(GLFWwindow*, GLFWkeyfun call) {
    return std::exchange(theWindow().onKey, call);
}
GLFWcharfun glfwSetCharCallback(GLFWwindow*, GLFWcharfun call) {
    return std::exchange(theWindow().onChar, call);
}
GLFWmousebuttonfun glfwSetMouseButtonCallback(GLFWwindow*, GLFWmousebuttonfun call) {
    return std::exchange(theWindow().onButton, call);
}
GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow*, GLFWcursorposfun call) {
    return std::exchange(theWindow().onMove, call);
}
GLFWcursorenterfun glfwSetCursorEnterCallback(GLFWwindow*, GLFWcursorenterfun call) {
    return std::exchange(theWindow().onEnter, call);
}
GLFWscrollfun glfwSetScrollCallback(GLFWwindow*, GLFWscrollfun call) {
    return std::exchange(theWindow().onScroll, call);
}
GLFWdropfun glfwSetDropCallback(GLFWwindow*, GLFWdropfun call) {
    return std::exchange(theWindow().onDrop, call);
}
GLFWframebuffersizefun glfwSetFramebufferSizeCallback(GLFWwindow*, GLFWframebuffersizefun call) {
    return std::exchange(theWindow().onSize, call);
}
}
// NOLINTEND
