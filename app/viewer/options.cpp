#include "options.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "commands.h"
#include "spiraling_edge/scenes.h"

namespace se::view {

namespace {

/// Reads "1280x800".
std::optional<glm::ivec2> sizeFromString(const std::string& text) {
    glm::ivec2 size(0);
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &rest) != 2) return std::nullopt;
    if (size.x < 320 || size.y < 240 || size.x > 16384 || size.y > 16384) return std::nullopt;
    return size;
}

std::vector<std::string> ruleSetNames() {
    const auto names = paramSetNames();
    return {names.begin(), names.end()};
}

std::string ruleSets() {
    std::string text;
    for (const std::string& name : ruleSetNames()) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string sceneList() {
    std::string text = "Scenes:";
    for (const Scene& scene : scenes()) {
        text += "\n  scene:" + std::string(scene.id);
        text.append(scene.id.size() < 18 ? 18 - scene.id.size() : 1, ' ');
        text += std::string(scene.title);
    }
    return text;
}

/// What needs a second look before it goes into Options.
struct RawOptions {
    std::string size;
    std::string theme;
    std::string layout;
    std::size_t neighbors = 0;
    double radius = 0.0;
    std::string screenshot;
    std::string shaders;
    std::string stateDump;
    bool actions = false;
};

void addOptions(CLI::App& app, Options& o, RawOptions& raw) {
    app.add_option("FILE", o.input.source,
                   "Points: PLY, XYZ, OBJ or OFF; or scene:ID. Without it, the first scene");
    app.add_option("--rules", o.input.rules,
                   "How the paper is read: " + ruleSets() + " (default paper)")
        ->check(CLI::IsMember(ruleSetNames()));
    auto* k =
        app.add_option("--neighbors", raw.neighbors, "List the K nearest neighbors of each point")
            ->check(CLI::Range(std::size_t{1}, std::size_t{1000}));
    auto* r = app.add_option("--radius", raw.radius, "List the neighbors within R, in scene units")
                  ->check(CLI::PositiveNumber);
    k->excludes(r);
    app.add_option("--goto", o.goTo,
                   "Begin at PIVOT[.STAGE[.N]], for example 137.sphere.3, or 50%");
    app.add_flag("--focus", o.focus, "Begin with the pivot and its neighbors framed");
    app.add_option("--size", raw.size,
                   "Size of the window or picture in pixels, for example 1280x800");
    app.add_option("--screenshot", raw.screenshot,
                   "Write a picture of the window and leave; needs no display");
    app.add_option("--frames", o.frames, "Leave after N frames")->check(CLI::Range(1, 1000000));
    app.add_option("--ui-scale", o.uiScale, "Size of text and panels, 0.75 to 3")
        ->check(CLI::Range(0.75, 3.0));
    app.add_option("--theme", raw.theme, "dark or light")->check(CLI::IsMember({"dark", "light"}));
    app.add_option("--layout", raw.layout, "How the window is arranged: debug, learn or present")
        ->check(CLI::IsMember({"debug", "learn", "present"}));
    app.add_flag("--narrate", o.narrate, "Print one sentence per step to stdout");
    app.add_option("--state-dump", raw.stateDump,
                   "Write what is shown as JSON, whenever it changes")
        ->type_name("FILE");
    app.add_option("--bench-frames", o.benchFrames,
                   "Draw N frames, one sub-step each, without a window; print what they cost")
        ->check(CLI::Range(1, 100000));
    app.add_flag("--no-config", o.noConfig, "Neither read nor write settings");
    app.add_option("--shaders", raw.shaders, "Read the shaders from this folder");
    app.add_flag("--keys", o.cheatSheet, "Begin with the list of keys open");
    app.add_flag("--list-actions", raw.actions, "Print all actions with their keys, and leave");
    app.set_version_flag("--version", "spiraling-edge-viewer " SE_VERSION);
    app.footer(sceneList);
}

}  // namespace

ParsedOptions parseOptions(int argc, const char* const* argv) {
    Options o;
    CLI::App app{"Watch the Spiraling Edge algorithm triangulate points, decision by decision.",
                 "spiraling-edge-viewer"};
    RawOptions raw;
    addOptions(app, o, raw);
    try {
        app.parse(argc, argv);
        o.size = sizeFromString(raw.size.empty() ? "1280x800" : raw.size);
        if (!o.size)
            throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT, for example 1280x800");
    } catch (const CLI::ParseError& e) {
        return {std::nullopt, app.exit(e) == 0 ? kExitGood : kExitUsage};
    }
    if (raw.size.empty()) o.size.reset();
    if (raw.actions) {
        std::fputs(listActions().c_str(), stdout);
        return {std::nullopt, kExitGood};
    }
    if (raw.neighbors > 0) o.input.neighbors = {KNearest{raw.neighbors}, true, true};
    if (raw.radius > 0.0) o.input.neighbors = {WithinRadius{raw.radius}, true, true};
    o.theme = themeFromName(raw.theme);
    o.layout = arrangementFromName(raw.layout);
    o.screenshot = raw.screenshot;
    o.shaders = raw.shaders;
    o.stateDump = raw.stateDump;
    return {std::move(o), kExitGood};
}

}  // namespace se::view
