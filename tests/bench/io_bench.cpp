#include "io_bench.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "shapes.h"
#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/prepare/prepare.h"

namespace se::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMillion = 1'000'000;

/// A million points with normals and types, without lists.
const PointFile& points() {
    static const PointFile file = [] {
        PointFile made = sphere(kMillion);
        made.type.assign(kMillion, kInterior);
        return made;
    }();
    return file;
}
const PointFile& pointsWithLists() {
    static const PointFile file = [] {
        PointFile made = points();
        auto prepared = prepare(made, {});
        if (prepared) made.neighbors = std::move(prepared.value().points.neighbors);
        return made;
    }();
    return file;
}
/// Two million triangles, as many as a closed mesh of the points has; their places do not matter to
/// a writer.
const std::vector<Triangle>& triangles() {
    static const std::vector<Triangle> made = [] {
        std::vector<Triangle> all;
        for (Index i = 0; i + 2 < kMillion; ++i) {
            all.push_back({i, i + 1, i + 2});
            all.push_back({i + 2, i + 1, i});
        }
        return all;
    }();
    return made;
}

/// A file that is removed with its object.
class Scratch {
  public:
    explicit Scratch(const std::string& name)
        : path_(fs::temp_directory_path() / ("spiraling-edge-bench-" + name)) {}
    ~Scratch() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

bool writePlainly(const fs::path& path, const std::string& bytes) {
    const File file(std::fopen(path.c_str(), "wb"));
    return file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
}

std::string readPlainly(const fs::path& path) {
    std::string bytes(fs::file_size(path), '\0');
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file || std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) return {};
    return bytes;
}

std::string binaryPcd() {
    std::string bytes =
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\n"
        "TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH 1000000\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1000000\nDATA binary\n";
    const PointFile& file = points();
    for (std::size_t i = 0; i < kMillion; ++i) {
        for (const Vec3& v : {file.position[i], file.normal[i]}) {
            for (int axis = 0; axis < 3; ++axis) {
                const auto number = static_cast<float>(v[axis]);
                bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
            }
        }
    }
    return bytes;
}

/// The bytes of a million points in a format that can be read.
std::string bytesOf(const std::string& what) {
    if (what == "points.pcd") return binaryPcd();
    if (what == "points_lists.ply") return meshPlyBytes(pointsWithLists(), {});
    if (what == "mesh.ply") return meshPlyBytes(points(), triangles());
    if (what == "points.ply") return meshPlyBytes(points(), {});
    const Scratch scratch(what);  // text: what the writer makes of them
    if (!writeMesh(scratch.path(), points(), {})) return {};
    return readPlainly(scratch.path());
}

void count(benchmark::State& bench, std::size_t bytes) {
    bench.SetBytesProcessed(bench.iterations() * static_cast<std::int64_t>(bytes));
    bench.counters["MB"] = static_cast<double>(bytes) / 1e6;
}

void readAll(benchmark::State& bench, const std::string& what, bool plainly) {
    const Scratch scratch(what);
    const std::string bytes = bytesOf(what);
    if (bytes.empty() || !writePlainly(scratch.path(), bytes)) {
        bench.SkipWithError("no room for the file");
        return;
    }
    for (auto _ : bench) {
        if (plainly) {
            benchmark::DoNotOptimize(readPlainly(scratch.path()));
            continue;
        }
        const auto file = readPoints(scratch.path());
        if (!file || file.value().position.size() != kMillion)
            return bench.SkipWithError("not what was written");
        benchmark::DoNotOptimize(file);
    }
    count(bench, bytes.size());
}

void writeAll(benchmark::State& bench, const std::string& what, bool plainly) {
    const Scratch scratch(what);
    const PointFile& file = what == "points_lists.ply" ? pointsWithLists() : points();
    const std::vector<Triangle> none;
    const std::vector<Triangle>& faces = what.starts_with("mesh") ? triangles() : none;
    if (!writeMesh(scratch.path(), file, faces)) return bench.SkipWithError("cannot be written");
    const std::string bytes = readPlainly(scratch.path());
    for (auto _ : bench) {
        const bool good = plainly ? writePlainly(scratch.path(), bytes)
                                  : writeMesh(scratch.path(), file, faces).ok();
        if (!good) return bench.SkipWithError("cannot be written");
    }
    count(bench, bytes.size());
}

}  // namespace

void registerIo() {
    const auto add = [](const char* kind, bool plainly, const std::string& what, auto work) {
        std::string title = kind;
        title += plainly ? "_baseline/" : "/";
        title += what;
        benchmark::RegisterBenchmark(title.c_str(),
                                     [=](benchmark::State& bench) { work(bench, what, plainly); })
            ->Unit(benchmark::kMillisecond)
            ->MeasureProcessCPUTime()
            ->UseRealTime();
    };
    for (const bool plainly : {true, false}) {
        for (const char* what :
             {"points.ply", "points_lists.ply", "mesh.ply", "points.pcd", "points.obj"})
            add("io/read", plainly, what, readAll);
        for (const char* what : {"points.ply", "points_lists.ply", "mesh.ply", "mesh.stl",
                                 "mesh.glb", "mesh.obj", "mesh.off"})
            add("io/write", plainly, what, writeAll);
    }
}

}  // namespace se::bench
