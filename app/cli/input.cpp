#include "input.h"

#include "exit_code.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::cli {
namespace {

PointFile buildScene(const std::string& id) {
    const Scene* scene = findScene(id);
    if (scene == nullptr) {
        throw Failure(ExitCode::Input, "scene:" + id +
                                           ": there is no such scene; `spiraling-edge scenes` "
                                           "lists those that there are");
    }
    return scene->build();
}

/// What else a person might take for points, and what to do with it.
void refuseOtherThings(const std::string& input) {
    if (isVolumePath(input)) {
        throw Failure(ExitCode::Input,
                      input + ": is a volume; `spiraling-edge sample " + input +
                          " -n N -o POINTS.ply` spreads points over a surface in it");
    }
    if (input.starts_with("sample:")) {
        throw Failure(ExitCode::Input,
                      input +
                          ": is for the viewer; here `spiraling-edge sample` writes such points to "
                          "a file first");
    }
    if (input.ends_with(".stl") || input.ends_with(".glb")) {
        throw Failure(
            ExitCode::Input,
            input + ": STL and GLB are written, not read; PLY, OBJ and OFF are read as well");
    }
}

}  // namespace

std::string nameOfInput(const std::string& input) {
    return input == kStandardInput ? "standard input" : input;
}

bool isVolumePath(std::string_view input) {
    return input.ends_with(".nrrd") || input.ends_with(".nhdr");
}

PointFile readInput(const std::string& input) {
    refuseOtherThings(input);
    constexpr std::string_view kScenePrefix = "scene:";
    if (input.starts_with(kScenePrefix)) return buildScene(input.substr(kScenePrefix.size()));
    Result<PointFile> file =
        input == kStandardInput ? readStandardInput() : readPoints(std::filesystem::path(input));
    if (!file) throw Failure(ExitCode::Input, file.error().message);
    return std::move(file.value());
}

}  // namespace se::cli
