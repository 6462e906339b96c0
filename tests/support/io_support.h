/// Helpers of the readers' tests: comparison of contents, truncated files, a temporary folder.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "spiraling_edge/io/read_points.h"

namespace se::test {

/// Equal including the sign of zero, or both NaN.
inline bool sameNumber(double a, double b) {
    if (std::isnan(a)) return std::isnan(b);
    return a == b && std::signbit(a) == std::signbit(b);
}
inline bool sameVectors(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    bool same = a.size() == b.size();
    for (std::size_t i = 0; same && i < a.size(); ++i) {
        same =
            sameNumber(a[i].x, b[i].x) && sameNumber(a[i].y, b[i].y) && sameNumber(a[i].z, b[i].z);
    }
    return same;
}
inline bool sameAttributes(const std::vector<Attribute>& a, const std::vector<Attribute>& b) {
    bool same = a.size() == b.size();
    for (std::size_t i = 0; same && i < a.size(); ++i) {
        same = a[i].name == b[i].name && a[i].type == b[i].type && a[i].values == b[i].values;
    }
    return same;
}
/// Checks everything but the scalar types of positions and normals, which text formats lack.
inline void checkSame(const PointFile& a, const PointFile& b) {
    CHECK(sameVectors(a.position, b.position));
    CHECK(sameVectors(a.normal, b.normal));
    CHECK(a.type == b.type);
    CHECK(a.neighbors.offset == b.neighbors.offset);
    CHECK(a.neighbors.ids == b.neighbors.ids);
    CHECK(a.faces == b.faces);
    CHECK(sameAttributes(a.attributes, b.attributes));
}

inline PointFile mustRead(std::string_view bytes, const std::string& name = "test") {
    const Result<PointFile> result = readPoints(bytes, name);
    REQUIRE_MESSAGE(result.ok(), result.error().message);
    return result.value();
}

/// The error of reading `bytes`; fails the test if they can be read.
inline std::string errorOf(std::string_view bytes, const std::string& name = "test") {
    const Result<PointFile> result = readPoints(bytes, name);
    REQUIRE_FALSE(result.ok());
    return result.error().message;
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// `text` with its first `from` replaced by `to`; a `from` that is not there fails the test.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// Reads every proper prefix of `bytes`: none may be read as a file with less content than `bytes`.
inline void checkAllPrefixes(const std::string& bytes) {
    const PointFile whole = mustRead(bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        // A copy of exact size, so that the address sanitizer sees reading past the end.
        const std::vector<char> copy(bytes.begin(),
                                     bytes.begin() + static_cast<std::ptrdiff_t>(size));
        const Result<PointFile> cut = readPoints(std::string_view(copy.data(), size), "cut");
        if (!cut.ok()) {
            CHECK_MESSAGE(contains(cut.error().message, "cut:"), cut.error().message);
            continue;
        }
        INFO("cut to ", size, " of ", bytes.size(), " bytes");
        checkSame(cut.value(), whole);
    }
}

/// A new folder that is removed with all in it.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        namespace fs = std::filesystem;
        for (int i = 0; path_.empty(); ++i) {
            const fs::path tried =
                fs::temp_directory_path() / ("spiraling-edge-test-" + std::to_string(i));
            if (fs::create_directory(tried)) path_ = tried;
        }
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return path_ / name; }
    std::size_t fileCount() const {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(path_), {}));
    }

  private:
    std::filesystem::path path_;
};

inline std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace se::test
