#include "start_arguments.h"

#include <utility>

#include "exit_code.h"
#include "input.h"
#include "spiraling_edge/scenes/scenes.h"
#include "teach/start_file.h"

namespace se::cli {

void StartArguments::addTo(CLI::App& app) {
    app.add_option("--start", path_,
                   "Begin with the triangles and edge rings of this JSON file "
                   "(docs/file-formats.md)")
        ->type_name("FILE");
}

GivenStart StartArguments::start(const std::string& input) const {
    if (!path_.empty()) {
        Result<GivenStart> start = teach::readStartFile(path_);
        if (!start) throw Failure(ExitCode::Input, start.error().message);
        return std::move(start.value());
    }
    constexpr std::string_view kScene = "scene:";
    return input.starts_with(kScene) ? startOfScene(input.substr(kScene.size())) : GivenStart{};
}

void StartArguments::require(const PointSet& points, const GivenStart& start,
                             const std::string& input) const {
    const Status status = requireStart(points, start);
    if (!status) {
        throw Failure(ExitCode::Input,
                      (path_.empty() ? nameOfInput(input) : path_) + ": " + status.error().message);
    }
}

void requireNoStart(const GivenStart& start, const std::string& what) {
    if (start.empty()) return;
    throw Failure(ExitCode::Usage,
                  what + ": the run begins with given triangles, which name points by numbers");
}

}  // namespace se::cli
