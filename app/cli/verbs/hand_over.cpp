// spiraling-edge view and render: replace this process by the viewer, which lies beside it. The
// command line links no window library, so that it runs on machines without one.
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

/// Replaces this process by the viewer. Throws if the viewer is missing.
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
                  fmt::format("cannot start the viewer: {} does not exist. Build it with "
                              "-DSPIRALING_EDGE_BUILD_VIEWER=ON, or use spiraling-edge run",
                              viewer));
}

/// Decided by the extension, or by JSON content. A session has a position of its own to show.
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
        "Writes a picture of a run without opening a window. All other options are passed "
        "to spiraling-edge-viewer.",
        "spiraling-edge render");
    std::string input;
    std::string picture;
    std::string place;
    app.add_option("IN", input, "File with points, - or scene:ID")->required();
    addOutputOption(app, "-o,--output", picture, "Picture to write")
        ->type_name("OUT.png")
        ->required();
    app.add_option(
           "--goto", place,
           "Position in the run: PIVOT[.STAGE[.N]] or a share (default: that of the session, "
           "otherwise 100%)")
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
