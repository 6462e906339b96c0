// spiraling-edge sample: even points on the isosurface of a shape or a volume.
#include <fmt/format.h>

#include <algorithm>

#include "input.h"
#include "output/sentences.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/stop_watch.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/sampling/sampler.h"
#include "spiraling_edge/sampling/volume.h"
#include "verbs.h"

namespace se::cli {
namespace {

struct SampleArguments : AnswerOptions {
    std::string input;
    std::string output;
    std::string box;
    std::optional<double> isovalue;
    std::size_t neighbors = 0;
    SamplerOptions sampler;
    ForceOption force;
    ByteLimit limit;
    bool list = false;

    void addTo(CLI::App& app) {
        app.add_option(
            "SHAPE", input,
            "Name of a shape (see --list), or a volume: " + wordList(volumeExtensions(), "or"));
        addOutputOption(app, "-o,--output", "OUT", output,
                        "Write the points to this file, as " +
                            listText(meshFormats(), &MeshFormat::name, "or", keepsPoints) +
                            " by its extension; - : PLY to standard output");
        auto* count = addOption(app, "-n,--points", "N", sampler.count,
                                "Exactly N points, 10 million at most");
        count->check(CLI::Range(std::size_t{1}, kMaxParticles));
        addOption(app, "--spacing", "S", sampler.spacing, "As many points as fit at distance S")
            ->excludes(count);
        addOption(app, "--iso", "V", isovalue,
                  "Isovalue (default: that of the shape, or the key `isovalue` of the volume)");
        addOption(app, "--seed", "S", sampler.seed, "Seed of the random start positions")
            ->capture_default_str()
            ->check(wholeNumber(0));
        addOption(app, "--box", "BOX", box,
                  "Clip to this box, X0,Y0,Z0,X1,Y1,Z1 (default: that of the "
                  "shape, or the whole volume)");
        addOption(app, "--curvature", "X", sampler.curvature,
                  "Denser where the surface bends: spacing divided by 1 + X times the "
                  "curvature over its mean, at most by 5")
            ->check(CLI::Range(0.0, 100.0));
        addOption(app, "-k,--neighbors", "K", neighbors,
                  "Also write the lists of the K nearest points")
            ->check(CLI::Range(std::size_t{1}, kMostNeighbors));
        force.addTo(app);
        addByteLimit(app, limit);
        app.add_flag("--list", list, "List the shapes");
        addAnswerOptions(app, "With --list: as JSON", "Print errors only");
    }

    void validate() const {
        if (input.empty())
            refuse("name a shape or a volume; `spiraling-edge sample --list` lists the shapes");
        if (sampler.count == 0 && !(sampler.spacing > 0.0))
            refuse("give the number of points: -n N, or --spacing S above 0");
        if (output.empty()) refuse("name a file with -o OUT.ply");
        requireNoTerminal(output);
        // Points are made to be read again.
        const MeshFormat* format = output == "-" ? nullptr : meshFormatOf(output);
        if (output != "-" && (format == nullptr || !keepsPoints(*format)))
            refuse("-o {}: points can be written as {}", output,
                   listText(meshFormats(), &MeshFormat::extension, "or", keepsPoints));
        const bool volume = isVolumePath(input);
        force.require({{"", volume ? input : ""},
                       {"the data file", volume ? dataFileOf(input).string() : ""}},
                      {{"-o", output}});
    }
};

Answer shapesAnswer() {
    std::size_t width = 0;
    for (const Shape& shape : shapes()) width = std::max(width, shape.id.size());
    Answer answer{"", Json::array()};
    for (const Shape& shape : shapes()) {
        answer.text += fmt::format("{:<{}}  {}\n", shape.id, width, shape.title);
        answer.json.push_back({{"id", shape.id},
                               {"title", shape.title},
                               {"isovalue", shape.isovalue},
                               {"low", shape.low},
                               {"high", shape.high}});
    }
    return answer;
}

std::string summary(const std::string& input, const PointFile& file, const SampleQuality& quality,
                    double seconds) {
    const std::size_t walls = countOfType(file, isBoundary);
    const std::size_t corners = countOfType(file, isCorner);
    Answer summary{fmt::format("{}: {}", printable(input), counted(file.position.size(), "point"))};
    if (walls > 0)
        summary.text += fmt::format(", {} of them on walls, {}", walls, counted(corners, "corner"));
    summary.text += "\n";
    summary.line("spacing", fmt::format("{:.4g}, varying by {:.1f} %", quality.spacing,
                                        100.0 * quality.variation));
    summary.line("off", fmt::format("{:.1g} spacings at most", quality.off));
    summary.line("time", fmt::format("{:.2f} s", seconds));
    return summary.text;
}

}  // namespace

ExitCode sampleVerb(CLI::App& app, const Arguments& words) {
    SampleArguments arguments;
    arguments.addTo(app);
    if (const auto code = parseArguments(app, words)) return *code;
    if (arguments.list) {
        print(shapesAnswer(), arguments.json);
        return ExitCode::Good;
    }
    arguments.validate();
    Field field = readSurface(arguments.input, arguments.isovalue, arguments.limit);
    if (!arguments.box.empty()) {
        const RunSpec spec = specOf({{findSpecField("box"), arguments.box}});
        if (spec.walls.from == WallChoice::From::Box) cutBy(spec.walls.box, arguments.input, field);
    }

    ProgressLine line(!arguments.quiet);
    StopWatch watch;
    PointFile file = samplePoints(field, arguments.sampler, arguments.input, line);
    const double seconds = watch.lap();
    if (arguments.neighbors > 0) {  // As `run` would compute them.
        PrepareOptions options;
        options.neighbors.reach = KNearest{arguments.neighbors};
        file.neighbors = require(prepare(file, options), ExitCode::Internal).points.neighbors;
    }
    // The normals are half the result.
    writeMeshOutput(arguments.output, file, {}, {.normals = true});
    if (arguments.quiet) return ExitCode::Good;
    printNote(summary(arguments.input, file, measureSample(field, file), seconds));
    return ExitCode::Good;
}

}  // namespace se::cli
