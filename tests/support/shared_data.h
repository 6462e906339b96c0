/// Large inputs next to the checkout, absent on most machines.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "spiraling_edge/io/read_points.h"

namespace se::test {

/// The file or folder of this name; empty, with a message, where it is absent.
inline std::filesystem::path sharedFile(const std::string& name) {
#ifdef SPIRALING_EDGE_SHARED_DATA
    std::filesystem::path path = std::filesystem::path(SPIRALING_EDGE_SHARED_DATA) / name;
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path;
#endif
    MESSAGE("skipped: ", name, " is not at hand");
    return {};
}

/// The content of the file of this name; nothing, with a message, where it is absent.
inline std::optional<PointFile> sharedPoints(const std::string& name) {
    const std::filesystem::path path = sharedFile(name);
    if (path.empty()) return std::nullopt;
    auto file = readPoints(path);
    REQUIRE_MESSAGE(file.ok(), name);
    return std::move(file.value());
}

}  // namespace se::test
