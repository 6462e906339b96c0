// spiraling-edge view, render and export: replace this process by the viewer, which lies beside it.
// The command line links no window library, so that it runs on machines without one.
#include <array>
#include <filesystem>

#include "output/output.h"
#include "spiraling_edge/base/operating_system.h"
#include "spiraling_edge/spec/session_text.h"
#include "verbs.h"

namespace se::cli {
namespace {

namespace fs = std::filesystem;

/// Replaces this process by the viewer. Throws if the viewer is missing.
[[noreturn]] void becomeViewer(Arguments arguments) {
    const fs::path viewer = os::programPath().parent_path() / "spiraling-edge-viewer";
    os::becomeProgram(viewer, std::move(arguments));
    throw Failure(ExitCode::NoDisplay,
                  "cannot start the viewer: {} does not exist. Install the package "
                  "spiraling-edge-viewer, build it with -DSPIRALING_EDGE_BUILD_VIEWER=ON, or use "
                  "spiraling-edge run",
                  viewer.string());
}

/// An option that is passed on as it stands; the viewer checks its value.
struct PassedOption {
    const char* name;
    const char* type;  ///< Empty: it has no value.
    const char* help;
};
constexpr std::array kExportOptions{
    PassedOption{"--goto", "WHERE",
                 "One frame: PIVOT[.STAGE[.N]] or a share (default: that of the session, "
                 "otherwise 100%)"},
    PassedOption{"--from", "WHERE", "First frame of a range of the run"},
    PassedOption{"--to", "WHERE", "Last frame of the range; a pivot: its last decision"},
    PassedOption{"--unit", "UNIT",
                 "Frames of the range: each sub-step (default), each pivot, or each event (seed, "
                 "split, join, alert)"},
    PassedOption{"--around", "WHERE", "All decisions of the pivot of this address"},
    PassedOption{"--steps", "LIST", "Steps of a lesson, 2,4-6 (default: all)"},
    PassedOption{"--size", "WxH", "Size in pixels (default 1280x800)"},
    PassedOption{"--scale", "X", "X times as many pixels, with the same content"},
    PassedOption{"--supersample", "N", "Draw N by N pixels for each one"},
    PassedOption{"--theme", "dark|light", "Colors (default dark)"},
    PassedOption{"--background", "none", "A transparent background"},
    PassedOption{"--labels", "on|off", "Names and values beside points (default on)"},
    PassedOption{"--dial", "on|off", "The dial of the pivot beside the view (default off)"},
    PassedOption{"--captions", "on|off",
                 "Sentences: in captions.txt, below an animation, on a page (default on)"},
    PassedOption{"--fps", "N", "Frames a second of an animation (default 2)"},
    PassedOption{"--viewer", "URL",
                 "On a page, addresses of decisions are links to the program at this address"},
    PassedOption{"--app", "",
                 "Write the program itself as one page (.html) that begins with IN; it needs no "
                 "network"},
};

/// Adds the options that were given, and those that this program does not know.
void forward(const CLI::App& app, Arguments& arguments) {
    for (const PassedOption& each : kExportOptions) {
        if (app.count(each.name) == 0) continue;
        // The viewer has the steps of the sampler as well.
        const bool steps = each.name == std::string_view("--steps");
        arguments.emplace_back(steps ? "--lesson-steps" : each.name);
        if (*each.type != '\0') arguments.push_back(app[each.name]->as<std::string>());
    }
    for (const std::string& word : app.remaining()) arguments.push_back(word);
}

}  // namespace

ExitCode viewVerb(CLI::App&, const Arguments& words) { becomeViewer(words); }

ExitCode renderVerb(CLI::App& app, const Arguments& words) {
    std::string input;
    std::string picture;
    std::string place;
    app.add_option("IN", input, "File with points, - or scene:ID")->required();
    addOutputOption(app, "-o,--output", "OUT.png", picture, "Picture to write")->required();
    addOption(app, "--goto", "WHERE", place,
              "Position in the run: PIVOT[.STAGE[.N]] or a share (default: that of the session, "
              "otherwise 100%)");
    app.allow_extras();
    if (const auto code = parseArguments(app, words)) return *code;
    if (!picture.ends_with(".png") && !picture.ends_with(".PNG"))
        refuse("-o {}: pictures are written as .png only", picture);
    // A session has a position of its own to show.
    if (place.empty() && !looksLikeSession(input)) place = "100%";
    Arguments arguments{input};
    if (!place.empty()) arguments.insert(arguments.end(), {"--goto", place});
    arguments.insert(arguments.end(), {"--screenshot", picture});
    for (const std::string& word : app.remaining()) arguments.push_back(word);
    becomeViewer(arguments);
}

ExitCode exportVerb(CLI::App& app, const Arguments& words) {
    std::string input;
    std::string output;
    app.add_option("IN", input,
                   "Points, a session, scene:ID, a lesson (.lesson.md), or the id of a lesson")
        ->required();
    addOutputOption(
        app, "-o,--output", "OUT", output,
        "File to write, by its extension; several pictures are numbered, or in a folder")
        ->required();
    for (const PassedOption& each : kExportOptions) {
        if (*each.type == '\0')
            app.add_flag(each.name, each.help);
        else
            app.add_option(each.name, each.help)->type_name(each.type);
    }
    app.allow_extras();
    if (const auto code = parseArguments(app, words)) return *code;
    Arguments arguments{input, "--export", output};
    forward(app, arguments);
    becomeViewer(arguments);
}

}  // namespace se::cli
