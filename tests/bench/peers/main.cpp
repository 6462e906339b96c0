// spiraling-edge-peer METHOD IN.ply -o OUT.ply [--neighbors K] [--repeat N] [--json]: runs another
// method on the same points, read and written by our own code, and reports the time of each stage.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <string>

#include "method.h"
#include "spiraling_edge/io/write_mesh.h"

namespace se::peers {
namespace {

// As in the command line program.
constexpr int kUsage = 2;
constexpr int kInput = 3;
constexpr int kInternal = 5;

struct Options {
    const Method* method = nullptr;
    std::string input;
    std::string output;
    std::size_t neighbors = 0;
    std::size_t repeat = 1;
    bool json = false;
};

struct Seconds {
    std::vector<double> read, search, reconstruct, write;
};

struct Run {
    std::size_t points = 0;     ///< Of the input.
    std::size_t ownPoints = 0;  ///< Made by the method.
    std::size_t triangles = 0;
    Seconds seconds;
};

void printUsage() {
    std::fputs(
        "usage: spiraling-edge-peer METHOD IN.ply -o OUT.ply [--neighbors K] [--repeat N] "
        "[--json]\n",
        stderr);
    for (const Method& method : methods())
        std::fprintf(stderr, "  %-8s %s%s\n", method.name.data(), method.title.data(),
                     method.run != nullptr ? "" : " (not built)");
}

const Method* methodNamed(std::string_view name) {
    const auto all = methods();
    const auto place =
        std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.name == name; });
    return place == all.end() ? nullptr : &*place;
}

bool readCount(const char* text, std::size_t& count) {
    const std::string_view word = text == nullptr ? "" : text;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    return error == std::errc() && end == word.data() + word.size() && count > 0;
}

/// False if the words are not understood.
bool readOptions(char** word, Options& options) {
    std::vector<std::string> names;
    for (++word; *word != nullptr; ++word) {
        const std::string_view it = *word;
        if (it == "--json") {
            options.json = true;
        } else if (it == "-o") {
            if (*++word == nullptr) return false;
            options.output = *word;
        } else if (it == "--neighbors") {
            if (!readCount(*++word, options.neighbors)) return false;
        } else if (it == "--repeat") {
            if (!readCount(*++word, options.repeat)) return false;
        } else if (it.starts_with("-")) {
            return false;
        } else {
            names.emplace_back(it);
        }
    }
    if (names.size() != 2 || options.output.empty()) return false;
    options.method = methodNamed(names[0]);
    options.input = names[1];
    return options.method != nullptr;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Once from file to file. Returns an exit code.
int runOnce(const Options& options, Run& run) {
    StopWatch watch;
    const auto file = readPoints(std::filesystem::path(options.input));
    run.seconds.read.push_back(watch.lap());
    if (!file || !file.value().hasNormals() || file.value().position.size() < 4) {
        std::fprintf(stderr, "%s\n",
                     file ? (options.input + ": needs four points, with normals").c_str()
                          : file.error().message.c_str());
        return kInput;
    }
    const PointFile& points = file.value();
    const std::size_t asked = options.neighbors;
    const Outcome outcome =
        options.method->run(points, asked > 0 ? asked : options.method->neighbors);
    run.seconds.search.push_back(outcome.searchSeconds);
    run.seconds.reconstruct.push_back(outcome.reconstructSeconds);
    run.points = points.position.size();
    run.ownPoints = outcome.ownPoints ? outcome.ownPoints->position.size() : 0;
    run.triangles = outcome.triangles.size();
    watch.lap();
    const Status written = writeMeshPly(
        options.output, outcome.ownPoints ? *outcome.ownPoints : points, outcome.triangles);
    run.seconds.write.push_back(watch.lap());
    if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return written ? 0 : kInternal;
}

void printRun(const Options& options, const Run& run) {
    const double read = median(run.seconds.read);
    const double search = median(run.seconds.search);
    const double reconstruct = median(run.seconds.reconstruct);
    const double write = median(run.seconds.write);
    if (!options.json) {
        std::printf(
            "%s: %zu points, %zu triangles; read %.3f s, neighbors %.3f s, reconstruct "
            "%.3f s, write %.3f s\n",
            options.method->name.data(), run.points, run.triangles, read, search, reconstruct,
            write);
        return;
    }
    std::printf(
        "{\n  \"method\": \"%s\",\n  \"title\": \"%s\",\n  \"points\": %zu,\n"
        "  \"own_points\": %zu,\n  \"triangles\": %zu,\n  \"repeats\": %zu,\n"
        "  \"seconds\": {\n    \"read\": %.6f,\n    \"neighbors\": %.6f,\n"
        "    \"reconstruct\": %.6f,\n    \"write\": %.6f\n  }\n}\n",
        options.method->name.data(), options.method->title.data(), run.points, run.ownPoints,
        run.triangles, run.seconds.read.size(), read, search, reconstruct, write);
}

int runAll(const Options& options) {
    if (options.method->run == nullptr) {
        std::fprintf(stderr, "%s was not built: install %s and configure again\n",
                     options.method->name.data(), options.method->package.data());
        return kUsage;
    }
    Run run;
    for (std::size_t i = 0; i < options.repeat; ++i)
        if (const int code = runOnce(options, run); code != 0) return code;
    printRun(options, run);
    return 0;
}

}  // namespace
}  // namespace se::peers

int main(int, char** argv) {
    se::peers::Options options;
    if (!se::peers::readOptions(argv, options)) {
        se::peers::printUsage();
        return se::peers::kUsage;
    }
    try {
        return se::peers::runAll(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", options.method->name.data(), error.what());
        return se::peers::kInternal;
    }
}
