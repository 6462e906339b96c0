#include "output.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "exit_code.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/outside_text.h"

namespace se::cli {
namespace {

namespace fs = std::filesystem;

/// Whether two names denote one file, also before it exists. A device such as /dev/null may be
/// named twice.
bool sameFile(const std::string& a, const std::string& b) {
    if (a == "-" || b == "-") return a == b;
    std::error_code ignored;
    const auto fileOf = [&](const std::string& path) {
        return fs::weakly_canonical(withLinksFollowed(fs::absolute(path, ignored)), ignored);
    };
    const fs::path first = fileOf(a);
    if (fs::exists(first, ignored) && !fs::is_regular_file(first, ignored)) return false;
    const fs::path second = fileOf(b);
    return first == second || fs::equivalent(first, second, ignored);
}

}  // namespace

CLI::Option* addOutputOption(CLI::App& app, const std::string& names, std::string& path,
                             const std::string& help) {
    return app.add_option(names, path, help)
        ->check(CLI::Validator(
            [](const std::string& given) {
                return given.empty() ? std::string("the file name is empty") : "";
            },
            ""));
}

void requireWritable(std::initializer_list<OutputPath> outputs) {
    for (const OutputPath* each = outputs.begin(); each != outputs.end(); ++each) {
        if (each->path.empty()) continue;
        for (const OutputPath* other = outputs.begin(); other != each; ++other) {
            if (other->path.empty() || !sameFile(other->path, each->path)) continue;
            throw Failure(ExitCode::Usage, fmt::format("{} and {} both name {}; give two names",
                                                       other->option, each->option, each->path));
        }
        if (each->path == "-") continue;
        if (const Status status = AtomicFile::check(each->path); !status)
            throw Failure(ExitCode::Usage,
                          fmt::format("{} {}", each->option, status.error().message));
    }
}

void requireOtherThan(const std::string& input, std::initializer_list<OutputPath> outputs) {
    for (const OutputPath& each : outputs) {
        if (each.path.empty() || each.path == "-" || !sameFile(input, each.path)) continue;
        throw Failure(ExitCode::Usage, fmt::format("{} {}: is the input; choose another name",
                                                   each.option, each.path));
    }
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

void printText(std::string_view text) { writeOutput("-", printableLines(text)); }

void printNote(std::string_view text) { std::fputs(printableLines(text).c_str(), stderr); }

}  // namespace se::cli
