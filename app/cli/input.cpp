#include "input.h"

#include "exit_code.h"
#include "spiraling_edge/base/shell_word.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/sampling/volume.h"
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
                      input + ": is a volume; `spiraling-edge sample " + shellPath(input) +
                          " -n N -o POINTS.ply` samples points on a surface in it");
    }
    if (input.starts_with("sample:")) {
        throw Failure(
            ExitCode::Input,
            input +
                ": works in the viewer only; `spiraling-edge sample` writes such points to "
                "a file first");
    }
    const MeshFormat* format = meshFormatOf(input);
    if (format != nullptr && !isReadable(*format)) {
        const auto unreadable = [](const MeshFormat& each) { return !isReadable(each); };
        throw Failure(ExitCode::Input,
                      input + ": " + listText(meshFormats(), &MeshFormat::name, "and", unreadable) +
                          " can be written, not read; " +
                          listText(meshFormats(), &MeshFormat::name, "and", isReadable) +
                          " can be read");
    }
}

}  // namespace

std::string nameOfInput(const std::string& input) {
    return input == kStandardInput ? "standard input" : input;
}

PointFile readInput(const std::string& input, const ByteLimit& limit) {
    refuseOtherThings(input);
    constexpr std::string_view kScenePrefix = "scene:";
    if (input.starts_with(kScenePrefix)) return buildScene(input.substr(kScenePrefix.size()));
    Result<PointFile> file = input == kStandardInput
                                 ? readStandardInput(limit)
                                 : readPoints(std::filesystem::path(input), limit);
    if (!file) throw Failure(ExitCode::Input, file.error().message);
    return std::move(file.value());
}

}  // namespace se::cli
