/// State and requests of the dialog Save mesh. Plain values, no ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "session/mesh_export.h"

namespace se::view {

/// Asked for in a frame, carried out at its end.
enum class MeshAsk : std::uint8_t {
    None,
    Save,         ///< Asks first where a file is to be replaced.
    Replace,      ///< The answer yes.
    Keep,         ///< Do not replace the file.
    Cancel,       ///< Stops waiting for the mesh.
    CopyCommand,  ///< The command line goes to the clipboard.
};

/// Size of the mesh that would be written.
struct MeshSize {
    std::size_t triangles = 0;
    std::size_t points = 0;
    std::size_t usedPoints = 0;
    bool capped = false;
};

struct MeshForm {
    std::size_t format = 0;  ///< A place in core's meshFormats().
    bool usedOnly = false;
    MeshAsk ask = MeshAsk::None;
    std::string path;  ///< The file that `ask` names.

    // Set by MeshSaving.
    std::optional<MeshSize> size;  ///< Empty until the run has ended.
    double share = 0.0;            ///< Of the run, in [0, 1].
    bool saving = false;
    bool writing = false;  ///< Too late to cancel.

    std::string complaint;    ///< Why nothing was saved or copied; empty: nothing to say.
    std::string note;         ///< What there is to know about the command that was copied.
    std::string question;     ///< The file that would be replaced; empty: none.
    bool justAsked = false;   ///< The answer no gets the keyboard.
    std::string savedPath;    ///< Where the mesh of `savedSource` was saved last.
    std::string savedSource;  ///< A source, see InputSpec.
    std::string copied;       ///< The command that was copied last.

    /// True while a question or the progress stands in place of the fields.
    bool waits() const { return saving || !question.empty(); }
    /// Forgets what was said when the dialog was open before; choices stay.
    void open();
    /// Takes the format that the name says, if it says one.
    void followName(const std::string& name);
    /// Chooses a format; a name that says another one gets its extension.
    void choose(std::size_t place, std::string& name);
    /// The typed name, with the extension of the format unless it has one of those.
    std::string withFormat(const std::string& typed) const;
};

/// By extension: one of core's meshFormats().
bool namesMeshFormat(const std::filesystem::path& path);
/// The size as a line of the dialog: "19 304 triangles, 21 000 points".
std::string sizeText(const MeshSize& size, bool usedOnly);
/// The notice after saving: size and path.
std::string savedText(const SavedMesh& saved);
/// The question before a file is replaced; `source` is that of the input.
std::string replaceText(const std::string& path, const std::string& source);

}  // namespace se::view
