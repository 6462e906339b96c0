/// A lesson made of the bookmarks of a run.
#pragma once

#include <filesystem>
#include <string>

#include "run/model.h"
#include "session/annotations.h"
#include "spiraling_edge/base/result.h"

namespace se::view {

/// The text of a lesson in `folder`: `notes` as its introduction, and a step for each bookmark.
/// Fails if the input could not be found from there. Requires a bookmark.
Result<std::string> lessonOfBookmarks(const RunSpec& spec, const Annotations& annotations,
                                      const std::filesystem::path& folder);

}  // namespace se::view
