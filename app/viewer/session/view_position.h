/// A position in a run, with the camera, as text: to be copied, pasted and kept.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/camera.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

struct ViewPosition {
    std::string address;  ///< As accepted by the go-to box; empty at the start of the run.
    std::optional<CameraPose> camera;
};

/// One line of JSON.
std::string toText(const ViewPosition& place);
/// Parses the result of toText(), or a bare address. Fails with a sentence.
Result<ViewPosition> viewPositionFromText(std::string_view text);

}  // namespace se::view
