#include "output.h"

#include <cstdio>

#include "spiraling_edge/base/operating_system.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/spec/run_spec.h"

namespace se::cli {

CLI::Option* addOutputOption(CLI::App& app, const std::string& names, const std::string& value,
                             std::string& path, const std::string& help) {
    return addOption(app, names, value, path, help)
        ->check(CLI::Validator(
            [](const std::string& given) {
                return given.empty() ? std::string("the file name is empty") : "";
            },
            ""));
}

void ForceOption::addTo(CLI::App& app, const std::string& also) {
    app.add_flag(std::string(kForceOption), given_, std::string(kForceHelp) + also);
}

void ForceOption::require(NamedFiles inputs, NamedFiles outputs) const {
    const auto isUnnamed = [](const NamedFile& each) { return each.path.empty(); };
    std::erase_if(inputs, isUnnamed);
    std::erase_if(outputs, isUnnamed);
    cli::require(requireApart(outputs), ExitCode::Usage);
    if (!given_) cli::require(requireKept(inputs, outputs), ExitCode::Usage);
    for (const NamedFile& each : outputs) {
        if (each.path != "-")
            cli::require(AtomicFile::check(each.path), ExitCode::Usage, each.role + " ");
    }
}

void writeOutput(const std::string& path, std::string_view bytes) {
    if (path != "-") {
        require(writeFileAtomically(path, bytes), ExitCode::Internal);
        return;
    }
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
        std::fflush(stdout) != 0) {
        throw Failure(ExitCode::Internal, "standard output: cannot be written");
    }
}

void requireNoTerminal(const std::string& output) {
    if (output == "-" && os::isTerminal(os::Stream::Output))
        refuse("-o -: refusing to write a binary file to a terminal");
}

void writeMeshOutput(const std::string& path, const PointFile& file,
                     std::span<const Triangle> triangles, const WriteOptions& options) {
    if (path == "-") return writeOutput(path, meshPlyBytes(file, triangles));
    require(writeMesh(path, file, triangles, options), ExitCode::Internal);
}

void printText(std::string_view text) { writeOutput("-", printableLines(text)); }

void print(const Answer& answer, bool asJson) {
    printText(asJson ? teach::jsonText(answer.json) : answer.text);
}

void printNote(std::string_view text) { std::fputs(printableLines(text).c_str(), stderr); }

std::string nameOfInput(const std::string& input) {
    return isStandardInput(input) ? "standard input" : input;
}

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted),
      enabled_(wanted && os::isTerminal(os::Stream::Error)),
      last_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() { clear(); }

bool ProgressLine::due() {
    if (!enabled_) return false;
    const auto now = std::chrono::steady_clock::now();
    constexpr std::chrono::milliseconds kInterval{100};
    if (now - last_ < kInterval) return false;
    last_ = now;
    return true;
}

void ProgressLine::write(const std::string& what, double share) {
    fmt::print(stderr, "\r{} {:3.0f} %", printable(what), 100.0 * share);
    std::fflush(stderr);
    dirty_ = true;
}

void ProgressLine::clear() {
    if (dirty_) fmt::print(stderr, "\r{:40}\r", "");
    dirty_ = false;
}

}  // namespace se::cli
