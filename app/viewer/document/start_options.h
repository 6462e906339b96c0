/// Options of the command line of the viewer.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "export/order.h"
#include "panel_state/picture_look.h"
#include "run/model.h"
#include "run/sample_spec.h"
#include "scene/mesh_style.h"
#include "scene/palette.h"
#include "session/layout_preset.h"
#include "session/session_file.h"

namespace se::view {

/// Colors and styles; nothing: the user's own.
struct Looks {
    std::optional<Theme> theme;
    std::optional<MeshStyle> meshStyle;
    std::optional<PointTint> pointTint;
};

/// All that a link says: what is opened, where, and how it is shown.
struct LinkOptions : Looks {
    RunSpec input;                          ///< An empty source: begin with the start page.
    SpecChange given;                       ///< Options of the run; `input` has them.
    std::optional<SessionFile> session;     ///< The session in FILE, if it is one.
    std::string lesson;                     ///< The lesson in FILE, if it is one; empty: none.
    std::optional<std::size_t> lessonStep;  ///< Its step to begin with, from 0.
    std::string goTo;
    /// Class and number of the alert to open on, or "first"; empty: none named.
    std::string alert;
    bool atDifference = false;               ///< --goto difference.
    std::string withText;                    ///< Text of --with.
    std::optional<std::uint64_t> stateHash;  ///< Expected at the end of the run.
    std::optional<CameraPose> camera;        ///< Also of --place.
    std::optional<LayoutPreset> layout;
    bool lessons = false;      ///< The column opens at Lesson.
    double playSeconds = 0.0;  ///< Play the run once, in about that time; 0: not.
    bool focus = false;        ///< Begin with the pivot framed.
};

struct Options : LinkOptions {
    std::string startFile;           ///< --start; empty: the start of the input.
    std::optional<SampleSpec> grow;  ///< --new: begin with these particles spreading.
    std::string sessionPath;
    std::filesystem::path resultFile;  ///< Answers to a lesson's questions; empty: nowhere.
    std::optional<CompareWith> with;
    bool resetLayout = false;
    std::optional<glm::ivec2> size;
    std::filesystem::path screenshot;     ///< Empty: open a window.
    std::optional<ExportOrder> exported;  ///< Frames to write instead of opening a window.
    PictureLook picture;
    int frames = 0;                 ///< Quit after that number of frames; 0: when closed.
    double uiScale = 0.0;           ///< 0: not given.
    std::filesystem::path shaders;  ///< Folder to read shaders from; empty: the built-in ones.
    bool noConfig = false;
    bool force = false;       ///< kForceOption.
    bool narrate = false;     ///< Print every sentence to stdout as well.
    bool cheatSheet = false;  ///< Open with the list of keys.

    /// Pictures are drawn, without a user.
    bool onPaper() const { return !screenshot.empty() || exported; }
};

}  // namespace se::view
