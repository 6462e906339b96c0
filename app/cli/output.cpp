#include "output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "exit_code.h"
#include "spiraling_edge/io.h"

namespace se::cli {

namespace fs = std::filesystem;

void requireWritable(const std::string& path, std::string_view option) {
    if (path.empty() || path == "-") return;
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        throw Failure(ExitCode::Usage,
                      fmt::format("{} {}: is a folder; name a file", option, path));
    fs::path folder = fs::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, ignored)) {
        throw Failure(ExitCode::Usage, fmt::format("{} {}: there is no folder {}; make it first",
                                                   option, path, folder.string()));
    }
    // What exists and is no plain file (/dev/stdout, a pipe) needs no right to the folder.
    const bool special = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
    if (::access(special ? path.c_str() : folder.c_str(), W_OK) != 0)
        throw Failure(ExitCode::Usage, fmt::format("{} {}: may not be written", option, path));
}

void writeOutput(const std::string& path, std::string_view bytes) {
    if (path != "-") {
        const Status status = writeFileAtomically(path, bytes);
        if (!status) throw Failure(ExitCode::Internal, status.error().message);
        return;
    }
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
        std::fflush(stdout) != 0) {
        throw Failure(ExitCode::Internal, "standard output: cannot be written");
    }
}

}  // namespace se::cli
