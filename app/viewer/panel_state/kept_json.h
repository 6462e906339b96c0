/// A JSON object that the program keeps for itself in a file of the user's folders. Of a file that
/// it reads, only what changed is written back: fields of others, and values that it does not
/// understand, stay. A file that it cannot read is never lost.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "spiraling_edge/base/result.h"

namespace se::view {

/// The object in a file; an empty one if there is no file, or none that this version can read.
nlohmann::json readKept(const std::filesystem::path& path);
/// The reason why readKept() did not read an existing file, and what becomes of it, in sentences;
/// empty if there is none.
std::string keptComplaint(const std::filesystem::path& path);

/// Changes the file as it is on disk by the difference between two objects, or writes `after` if
/// there is none; makes the folder if necessary. A damaged file is kept beside it before, as
/// NAME.bad or, if another is there, NAME.2.bad and so on. One of a newer version, and one that
/// cannot be read, is left as it is. An empty path has no effect.
Status writeKept(const std::filesystem::path& path, const nlohmann::json& before,
                 const nlohmann::json& after);

}  // namespace se::view
