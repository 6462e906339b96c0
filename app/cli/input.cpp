#include "input.h"

#include "exit_code.h"
#include "spiraling_edge/scenes/scenes.h"

namespace se::cli {
namespace {

PointFile buildScene(const std::string& id) {
    const Scene* scene = findScene(id);
    if (scene == nullptr) {
        throw Failure(ExitCode::Input, "scene:" + id +
                                           ": no such scene; `spiraling-edge scenes` "
                                           "lists the scenes");
    }
    return scene->build();
}

/// Message for inputs that are commonly mistaken for points, with what to do instead.
void refuseOtherThings(const std::string& input) {
    if (isVolumePath(input)) {
        throw Failure(ExitCode::Input,
                      input + ": is a volume; `spiraling-edge sample " + input +
                          " -n N -o POINTS.ply` samples points on a surface in it");
    }
    if (input.starts_with("sample:")) {
        throw Failure(
            ExitCode::Input,
            input +
                ": works in the viewer only; `spiraling-edge sample` writes such points to "
                "a file first");
    }
    if (input.ends_with(".stl") || input.ends_with(".glb")) {
        throw Failure(
            ExitCode::Input,
            input + ": STL and GLB can be written, not read; PLY, OBJ and OFF can be read");
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
