// spiraling-edge view and render: the window program beside this one does the work.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "options.h"
#include "output/output.h"
#include "verbs.h"

namespace se::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kViewerName = "spiraling-edge-viewer";

/// Becomes the viewer. Throws if there is none.
[[noreturn]] void becomeViewer(Arguments arguments) {
    std::error_code problem;
    const fs::path self = fs::read_symlink("/proc/self/exe", problem);
    const std::string viewer = (self.parent_path() / kViewerName).string();
    arguments.insert(arguments.begin(), viewer);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    ::execv(viewer.c_str(), pointers.data());
    throw Failure(ExitCode::NoDisplay,
                  fmt::format("the viewer cannot be started: there is no program {}. Build it with "
                              "-DSPIRALING_EDGE_BUILD_VIEWER=ON, or use spiraling-edge run",
                              viewer));
}

/// By its extension, or by its content as JSON: a session has a place of its own to show.
bool isSession(const std::string& input) {
    if (input.ends_with(".sesession")) return true;
    std::error_code ignored;
    if (!fs::is_regular_file(input, ignored)) return false;
    std::ifstream file(input, std::ios::binary);
    char first = 0;
    return (file >> first) && first == '{';
}

}  // namespace

ExitCode viewVerb(const Arguments& words) { becomeViewer(words); }

ExitCode renderVerb(const Arguments& words) {
    CLI::App app(
        "Writes a picture of a run without opening a window. Further options go "
        "to spiraling-edge-viewer.",
        "spiraling-edge render");
    std::string input;
    std::string picture;
    std::string place;
    app.add_option("IN", input, "File with points, - or scene:ID")->required();
    addOutputOption(app, "-o,--output", picture, "Picture to write")
        ->type_name("OUT.png")
        ->required();
    app.add_option("--goto", place,
                   "Place in the run: PIVOT[.STAGE[.N]] or a share (default: that of the session, "
                   "or else 100%)")
        ->type_name("WHERE");
    app.allow_extras();
    if (const auto code = parseArguments(app, words)) return *code;
    if (!picture.ends_with(".png") && !picture.ends_with(".PNG"))
        throw Failure(ExitCode::Usage,
                      fmt::format("-o {}: pictures are written as .png only", picture));
    requireWritable({{"-o", picture}});
    if (place.empty() && !isSession(input)) place = "100%";
    Arguments arguments{input};
    if (!place.empty()) arguments.insert(arguments.end(), {"--goto", place});
    arguments.insert(arguments.end(), {"--screenshot", picture});
    for (const std::string& word : app.remaining()) arguments.push_back(word);
    becomeViewer(arguments);
}

}  // namespace se::cli
