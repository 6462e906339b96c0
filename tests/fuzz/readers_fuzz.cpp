/// Feeds arbitrary bytes to the readers: no crash, and any result can be written, read back and
/// prepared. By default a plain program that takes files, so that it never rots:
///
///     readers_fuzz FILE...
///
/// With SPIRALING_EDGE_LIBFUZZER defined and -fsanitize=fuzzer,address,undefined it is a fuzzer:
///
///     readers_fuzz -max_len=4096 CORPUS_FOLDER
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/sampling/volume.h"

namespace {

void checkContent(const se::PointFile& file) {
    const std::string bytes = se::meshPlyBytes(file, file.faces);
    const auto again = se::readPoints(bytes, "written");
    demand(again.ok(), "what was written cannot be read");
    demand(se::meshPlyBytes(again.value(), again.value().faces) == bytes,
           "what was read back is written differently");
    const auto prepared = se::prepare(file, {});
    const bool isOutOfRange =
        !prepared.ok() && prepared.error().message.starts_with("coordinates are too ");
    demand(prepared.ok() || isOutOfRange || !file.hasNormals(), "good points cannot be prepared");
    demand(!prepared.ok() || se::validate(prepared.value().points).ok(),
           "prepared points are not valid");
}

/// Checks the guarantees of volume.h for a volume that was read.
void checkVolume(const se::Volume& volume) {
    const auto& size = volume.size;
    demand(size[0] >= 2 && size[1] >= 2 && size[2] >= 2, "fewer than two samples");
    demand(volume.value.size() == size[0] * size[1] * size[2], "samples are missing");
    demand(std::all_of(volume.value.begin(), volume.value.end(),
                       [](float value) { return std::isfinite(value); }),
           "samples that are not finite");
    for (int axis = 0; axis < 3; ++axis)
        demand(volume.spacing[axis] > 0.0, "a spacing that is not above 0");
    for (const se::Vec3& corner : {volume.origin, volume.high()}) {
        demand(!std::isnan(volume.valueAt(corner)), "no value at a corner");
        volume.gradientAt(corner);
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const char* name :
         {"input", "input.off", "input.stl"}) {  // the other extensions do not matter
        const auto file = se::readPoints(bytes, name);
        demand(file.ok() || !file.error().message.empty(), "an error without a message");
        if (file.ok()) checkContent(file.value());
    }
    const auto volume = se::readVolume(bytes, "input.nrrd");
    demand(volume.ok() || !volume.error().message.empty(), "an error without a message");
    if (volume.ok()) checkVolume(volume.value());
    return 0;
}
