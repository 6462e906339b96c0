#include "spiraling_edge/look.h"

#include <cstdlib>
#include <filesystem>
#include <random>
#include <system_error>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/spec/session_text.h"

namespace se {
namespace {

/// Writes the files into the folder and runs the viewer on them.
Status lookFrom(const std::filesystem::path& folder, const Stepper& stepper,
                const std::string& viewer) {
    const std::string points = "points.ply";
    Status written = writeMeshPly(folder / points, fileOf(stepper.points()), {});
    if (!written) return written;
    const std::filesystem::path session = folder / ("run" + std::string(kSessionExtension));
    const std::uint32_t pivots = stepper.state().counters.pivots;
    written = writeFileAtomically(session, sessionText(stepper.params(), points, pivots));
    if (!written) return written;
    const std::string command = shellQuoted(viewer) + " " + shellQuoted(session.string());
    if (std::system(command.c_str()) == 0) return success();  // NOLINT(cert-env33-c): quoted
    return Error{viewer + " ended with an error, or is not installed"};
}

}  // namespace

std::string sessionText(const Params& params, const std::string& points, std::uint32_t pivots) {
    // The points have the lists of the run.
    return sessionText({points, withRule(specOf(params), "opposing", 0.0), std::to_string(pivots)});
}

Status look(const Stepper& stepper, const std::string& viewer) {
    std::error_code error;
    std::random_device random;
    const std::string name = "spiraling-edge-" + std::to_string(random());
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error) / name;
    if (error || !std::filesystem::create_directory(folder, error))
        return Error{folder.string() + ": the folder for temporary files cannot be made"};
    const Status looked = lookFrom(folder, stepper, viewer);
    std::filesystem::remove_all(folder, error);
    return looked;
}

}  // namespace se
