/// Bytes of files: in pieces, so that a source of unknown length takes no more memory than it
/// holds.
#include "spiraling_edge/base/files.h"

#include <algorithm>
#include <vector>

#include "spiraling_edge/base/operating_system.h"

namespace se {
namespace {

namespace fs = std::filesystem;

/// The pieces in one; each is freed once it is copied.
std::string joinedPieces(std::vector<std::string>& pieces) {
    if (pieces.size() == 1) return std::move(pieces.front());
    std::size_t size = 0;
    for (const std::string& each : pieces) size += each.size();
    std::string bytes;
    bytes.reserve(size);
    for (std::string& each : pieces) bytes += std::exchange(each, {});
    return bytes;
}

}  // namespace

Error ByteLimit::exceededBy(const std::string& name) const {
    return Error{name + ": holds more than " + std::to_string(bytes) +
                 " bytes, read or unpacked; " + std::string(remedy)};
}

Result<std::string> readBytes(const fs::path& path, const ByteLimit& limit,
                              const Progress& progress) {
    const std::string name = path == os::kStandardInputDevice ? "standard input" : path.string();
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return Error{name + ": there is no such file"};
    if (fs::is_directory(status)) return Error{name + ": is a folder; name a file in it"};
    errno = 0;
    const int file = os::openToRead(path);
    const os::Closing closing(file);
    if (file < 0) return Error{name + ": cannot be opened: " + systemReason()};
    const std::uint64_t expected = os::sizeOf(file);
    if (expected > limit.bytes) return limit.exceededBy(name);
    constexpr std::size_t kStep = std::size_t{1} << 20U;
    // One byte more than expected, to detect the end without another piece.
    std::size_t room = static_cast<std::size_t>(expected) + 1;
    std::vector<std::string> pieces;
    std::uint64_t total = 0;
    for (bool ended = false; !ended; room = kStep) {
        std::string& piece = pieces.emplace_back(room, '\0');
        std::size_t filled = 0;
        while (!ended && filled < room) {
            const std::ptrdiff_t got =
                os::readSome(file, &piece[filled], std::min(kStep, room - filled));
            if (got < 0) return Error{name + ": cannot be read: " + systemReason()};
            ended = got == 0;
            filled += static_cast<std::size_t>(got);
            total += static_cast<std::uint64_t>(got);
            if (total > limit.bytes) return limit.exceededBy(name);
            const double whole = static_cast<double>(std::max(expected, total));
            if (progress && !progress(static_cast<double>(total) / std::max(whole, 1.0)))
                return Error{"Cancelled."};
        }
        piece.resize(filled);
    }
    return joinedPieces(pieces);
}

bool isUnfit(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return fs::exists(status) && !fs::is_regular_file(status);
}

bool isUnfitIn(const fs::path& folder, const fs::path& path) {
    std::error_code problem;
    const fs::path root = fs::canonical(folder.empty() ? "." : folder, problem);
    const fs::path place = problem ? fs::path() : fs::weakly_canonical(fs::absolute(path), problem);
    const auto way = std::mismatch(root.begin(), root.end(), place.begin(), place.end());
    return problem || way.first != root.end() || isUnfit(path);
}

}  // namespace se
