#include "spiraling_edge/sampling/volume.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>
#include <thread>
#include <vector>

#include "spiraling_edge/sampling/gzip.h"
#include "spiraling_edge/sampling/sampler.h"
#include "support/io_support.h"
#include "support/oracles.h"
#include "support/scarce_memory.h"
#include "support/shared_data.h"

using namespace se;

namespace {

const std::string kHeader =
    "NRRD0004\n"
    "# made by a test\n"
    "type: uint8\n"
    "dimension: 3\n"
    "sizes: 2 3 4\n"
    "spacings: 1 2 0.5\n"
    "axis mins: -1 0 10\n"
    "encoding: raw\n"
    "isovalue:=11.5\n"
    "\n";

/// 0, 1, 2, ... as T, in the given byte order.
template <typename T>
std::string numbers(std::size_t count, bool big) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) {
        const T value = static_cast<T>(i);
        std::array<char, sizeof(T)> raw{};
        std::memcpy(raw.data(), &value, sizeof(T));
        if (big == (std::endian::native == std::endian::little))
            std::reverse(raw.begin(), raw.end());
        bytes.append(raw.data(), raw.size());
    }
    return bytes;
}

std::string gzipped(const std::string& bytes) {
    z_stream stream{};
    REQUIRE(deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    packed.resize(packed.size() - stream.avail_out);
    deflateEnd(&stream);
    return packed;
}

Volume readGood(const std::string& bytes) {
    Result<Volume> volume = readVolume(bytes, "test.nrrd");
    REQUIRE_MESSAGE(volume.ok(), (volume.ok() ? "" : volume.error().message));
    return std::move(volume.value());
}
std::string problem(const std::string& bytes) {
    const Result<Volume> volume = readVolume(bytes, "test.nrrd");
    REQUIRE_FALSE(volume.ok());
    return volume.error().message;
}

template <typename T>
void checkType(const char* name) {
    CAPTURE(name);
    for (const bool big : {false, true}) {
        const std::string header =
            replaced(replaced(kHeader, "uint8", name), "encoding: raw\n",
                     std::string("encoding: raw\nendian: ") + (big ? "big\n" : "little\n"));
        const Volume volume = readGood(header + numbers<T>(24, big));
        REQUIRE(volume.value.size() == 24);
        for (std::size_t i = 0; i < 24; ++i) CHECK(volume.value[i] == static_cast<float>(i));
        const Volume packed =
            readGood(replaced(header, "raw", "gzip") + gzipped(numbers<T>(24, big)));
        CHECK(packed.value == volume.value);
    }
}

/// A ball of radius 0.7 as a volume of n^3 samples over [-1, 1]^3.
Volume ballVolume(std::size_t n) {
    Volume volume;
    volume.size = {n, n, n};
    volume.spacing = Vec3(2.0 / static_cast<double>(n - 1));
    volume.origin = Vec3(-1.0);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t i = 0; i < n; ++i) {
                const Vec3 x = volume.origin + volume.spacing * Vec3(i, j, k);
                volume.value.push_back(static_cast<float>(0.7 - glm::length(x)));
            }
        }
    }
    return volume;
}

}  // namespace

TEST_CASE("NRRD: header and samples are read unchanged") {
    const Volume volume = readGood(kHeader + numbers<std::uint8_t>(24, false));
    CHECK(volume.size == std::array<std::size_t, 3>{2, 3, 4});
    CHECK(volume.spacing == Vec3(1, 2, 0.5));
    CHECK(volume.origin == Vec3(-1, 0, 10));
    CHECK(volume.high() == Vec3(0, 4, 11.5));
    CHECK(volume.isovalue == 11.5);
    CHECK(volume.at(1, 0, 0) == 1.0F);
    CHECK(volume.at(0, 1, 0) == 2.0F);
    CHECK(volume.at(0, 0, 1) == 6.0F);
}

TEST_CASE("NRRD: all types in both byte orders, raw and packed") {
    checkType<std::int8_t>("signed char");
    checkType<std::uint8_t>("uchar");
    checkType<std::int16_t>("short");
    checkType<std::uint16_t>("uint16");
    checkType<std::int32_t>("int");
    checkType<std::uint32_t>("uint32_t");
    checkType<float>("float");
    checkType<double>("double");
}

TEST_CASE("NRRD: space directions, cell centers and skipped bytes") {
    const std::string data = numbers<std::uint8_t>(24, false);
    std::string header = replaced(kHeader, "spacings: 1 2 0.5",
                                  "space: left-posterior-superior\n"
                                  "space directions: (1,0,0) (0, 2, 0) (0,0,0.5)");
    header = replaced(header, "axis mins", "space origin");
    CHECK(readGood(replaced(header, "-1 0 10", "(-1,0,10)") + data).spacing == Vec3(1, 2, 0.5));
    const std::string cells = replaced(kHeader, "encoding", "centers: cell cell node\nencoding");
    CHECK(readGood(cells + data).origin == Vec3(-0.5, 1, 10));
    const std::string skipped =
        replaced(kHeader, "encoding", "line skip: 1\nbyte skip: 2\nencoding");
    CHECK(readGood(skipped + "a line\nxx" + data).value[23] == 23.0F);
    CHECK(readGood(replaced(kHeader, "encoding", "byte skip: -1\nencoding") + "junk" + data)
              .value[0] == 0.0F);
    const std::string packed = replaced(kHeader, "encoding: raw", "byte skip: 3\nencoding: gzip");
    CHECK(readGood(packed + gzipped("abc" + data)).value[23] == 23.0F);
    // Two consecutive streams are one file for gzip.
    CHECK(readGood(replaced(kHeader, "raw", "gz") + gzipped(data.substr(0, 9)) +
                   gzipped(data.substr(9)))
              .value[23] == 23.0F);
}

TEST_CASE("NRRD: every broken line is named, with what was expected") {
    struct Broken {
        const char *from, *to, *says;
    };
    const std::string data = numbers<std::uint8_t>(24, false);
    for (const Broken& b :
         {Broken{"NRRD0004", "NRRD0009", "line 1: expected NRRD0001"},
          {"NRRD0004", "P5", "line 1: expected NRRD0001"},
          {"type: uint8", "type: complex", "line 3: type: expected"},
          {"type: uint8", "type uint8", "line 3: expected a field"},
          {"type: uint8", "tipe: uint8", "line 3: NRRD has no field \"tipe\""},
          {"type: uint8\n", "", "without the field type"},
          {"type: uint8", "type: float", "without the field endian"},
          {"dimension: 3", "dimension: 4", "line 4: dimension: only 3"},
          {"dimension: 3\n", "", "line 4: sizes: must come after dimension"},
          {"sizes: 2 3 4", "sizes: 2 3", "line 5: sizes: expected three"},
          {"sizes: 2 3 4", "sizes: 2 3 4 5", "line 5: sizes: expected three"},
          {"sizes: 2 3 4", "sizes: 2 -3 4", "line 5: sizes: expected three"},
          {"sizes: 2 3 4", "sizes: 1 3 4", "line 5: sizes: expected three"},
          {"sizes: 2 3 4", "sizes: 2 x 4", "line 5: sizes: expected three"},
          {"sizes: 2 3 4", "sizes: 2 3 99999999", "line 5: sizes: expected three"},
          {"sizes: 2 3 4\n", "", "without the field sizes"},
          {"sizes: 2 3 4", "sizes: 2 3 5", "expected 30 bytes of data, found 24"},
          {"sizes: 2 3 4", "sizes: 1048576 1048576 1024", "bytes of data, found 24"},
          {"sizes: 2 3 4", "sizes: 1048576 1048576 1048576", "line 5: sizes: more samples"},
          {"spacings: 1 2 0.5", "spacings: 1 2", "line 6: spacings: expected three"},
          {"spacings: 1 2 0.5", "spacings: 1 0 1", "line 6: spacings: expected three"},
          {"spacings: 1 2 0.5", "spacings: 1 nan 1", "line 6: spacings: expected three"},
          {"spacings: 1 2 0.5", "spacings: 1 inf 1", "line 6: spacings: expected three"},
          {"spacings: 1 2 0.5", "space directions: (1,0,0) (0,1,0.1) (0,0,1)",
           "line 6: space directions: only axes"},
          {"spacings: 1 2 0.5", "space directions: (1,0,0) none (0,0,1)",
           "line 6: space directions: only axes"},
          {"spacings: 1 2 0.5", "space directions: (-1,0,0) (0,1,0) (0,0,1)",
           "line 6: space directions: only axes"},
          {"axis mins: -1 0 10", "axis mins: -1 0", "line 7: axis mins: expected three"},
          {"axis mins: -1 0 10", "spacings: 1 1 1", "line 7: the field \"spacings\" stands there"},
          {"axis mins: -1 0 10", "centers: cell edge node", "line 7: centers: expected"},
          {"axis mins: -1 0 10", "byte skip: -2", "line 7: byte skip: expected"},
          {"axis mins: -1 0 10", "line skip: -1", "line 7: line skip: expected"},
          {"axis mins: -1 0 10", "line skip: 3", "fewer than the 3 lines"},
          {"axis mins: -1 0 10", "endian: middle", "line 7: endian: expected"},
          {"axis mins: -1 0 10", "data file: LIST", "line 7: data file: only a single"},
          {"axis mins: -1 0 10", "data file: other.raw", "line 7: the data are in another file"},
          {"encoding: raw", "encoding: hex", "line 8: encoding: only raw and gzip"},
          {"encoding: raw", "encoding: gzip", "gzip data are damaged"},
          {"encoding: raw\n", "", "without the field encoding"},
          {"isovalue:=11.5", "isovalue:=high", "line 9: isovalue: expected a number"}}) {
        CAPTURE(b.to);
        const std::string message = problem(replaced(kHeader, b.from, b.to) + data);
        CHECK_MESSAGE(message.find(b.says) != std::string::npos, message);
        CHECK(message.starts_with("test.nrrd: "));
    }
}

TEST_CASE("NRRD: samples that are no numbers are an error") {
    const std::string header =
        replaced(replaced(kHeader, "uint8", "float"), "encoding", "endian: little\nencoding");
    std::string data = numbers<float>(24, false);
    data[4 * 5 + 2] = static_cast<char>(0xc0);
    data[4 * 5 + 3] = 0x7f;
    CHECK(problem(header + data).find("sample 5 is not a finite number") != std::string::npos);
}

TEST_CASE("NRRD: a file that is cut anywhere is an error, never a volume") {
    const std::string data = numbers<std::uint8_t>(24, false);
    for (const std::string& whole :
         {kHeader + data, replaced(kHeader, "raw", "gzip") + gzipped(data)}) {
        for (std::size_t length = 0; length < whole.size(); ++length)
            CHECK_FALSE(readVolume(std::string_view(whole).substr(0, length), "cut").ok());
    }
    CHECK(problem(kHeader + data + "x").find("found 25") != std::string::npos);
    CHECK(problem(replaced(kHeader, "raw", "gzip") + gzipped(data + "x")).find("more than") !=
          std::string::npos);
}

TEST_CASE("NRRD: what unpacks to more than the limit is refused before memory is taken") {
    const ByteLimit limit{1'000'000};
    // Eight million bytes, in less than ten thousand.
    const std::string bomb = replaced(replaced(kHeader, "2 3 4", "200 200 200"), "raw", "gzip") +
                             gzipped(std::string(8'000'000, '\0'));
    // A header that promises much, and more bytes to pass over than the limit.
    const std::string promise = replaced(kHeader, "2 3 4", "1000000 1000000 1000");
    const std::string skip =
        replaced(replaced(kHeader, "raw", "gzip"), "isovalue", "byte skip: 1000001\nisovalue") +
        gzipped(std::string(1'000'025, '\0'));
    // The bytes are within the limit, their values as numbers are not.
    const std::string wide = replaced(kHeader, "2 3 4", "100 100 60") + std::string(600'000, '\0');
    std::vector<std::string> messages;
    const ScarceMemory scarce(1'100'000);
    std::thread reader([&] {
        for (const std::string* each : {&bomb, &promise, &skip, &wide}) {
            try {
                const Result<Volume> volume = readVolume(*each, "test.nrrd", limit);
                messages.push_back(volume.ok() ? "read" : volume.error().message);
            } catch (const std::bad_alloc&) {
                messages.push_back("took memory");
            }
        }
    });
    reader.join();
    const std::string over =
        "test.nrrd: holds more than 1000000 bytes, read or unpacked; --most-bytes N raises this "
        "limit";
    REQUIRE(messages.size() == 4);
    CHECK(messages[0] == over);
    CHECK(messages[1].find("found 0") != std::string::npos);
    CHECK(messages[2] == over);
    CHECK(messages[3] == over);
}

TEST_CASE("NRRD: data beside the header are found, and missed by name") {
    std::ofstream("volume_test.nhdr", std::ios::binary)
        << replaced(kHeader, "encoding", "data file: volume_test.raw\nencoding");
    std::ofstream("volume_test.raw", std::ios::binary) << numbers<std::uint8_t>(24, false);
    const Result<Volume> volume = readVolume(std::filesystem::path("volume_test.nhdr"));
    REQUIRE(volume.ok());
    CHECK(volume.value().value[23] == 23.0F);
    std::filesystem::remove("volume_test.raw");
    const Result<Volume> missing = readVolume(std::filesystem::path("volume_test.nhdr"));
    REQUIRE_FALSE(missing.ok());
    CHECK(missing.error().message.find("line 8") != std::string::npos);
    CHECK(missing.error().message.find("volume_test.raw") != std::string::npos);
    std::filesystem::remove("volume_test.nhdr");
}

TEST_CASE("volumes are known by their extension, in upper or lower case") {
    for (const std::string_view extension : volumeExtensions())
        CHECK(isVolumePath("folder/a" + std::string(extension)));
    CHECK(isVolumePath("A.NRRD"));
    for (const char* other : {"a.ply", "nrrd", "a.nrrd.gz", "torus", ""})
        CHECK_FALSE(isVolumePath(other));
}

TEST_CASE("values between samples are trilinear, gradients of linear values exact") {
    Volume volume;
    volume.size = {3, 4, 5};
    volume.spacing = Vec3(0.5, 1.0, 2.0);
    volume.origin = Vec3(1.0, -2.0, 0.0);
    test::Random random(3);
    for (std::size_t i = 0; i < 60; ++i)
        volume.value.push_back(static_cast<float>(random.between(-1.0, 1.0)));
    for (int n = 0; n < 100; ++n) {
        const Vec3 x = random.inBox(volume.origin, volume.high());
        const Vec3 at = (x - volume.origin) / volume.spacing;
        double sum = 0.0;  // every sample weighted by a tent
        for (std::size_t k = 0; k < 5; ++k) {
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t i = 0; i < 3; ++i) {
                    const Vec3 d = glm::max(1.0 - glm::abs(at - Vec3(i, j, k)), Vec3(0.0));
                    sum += d.x * d.y * d.z * static_cast<double>(volume.at(i, j, k));
                }
            }
        }
        CHECK(std::abs(volume.valueAt(x) - sum) < 1e-12);
    }
    for (std::size_t k = 0; k < 5; ++k) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t i = 0; i < 3; ++i)
                volume.value[(k * 4 + j) * 3 + i] = static_cast<float>(i + 4 * j) - float(k);
        }
    }
    for (int n = 0; n < 100; ++n) {
        const Vec3 x = random.inBox(volume.origin, volume.high());
        CHECK(glm::length(volume.gradientAt(x) - Vec3(2.0, 4.0, -0.5)) < 1e-9);
    }
    CHECK(glm::length(volume.gradientAt(volume.high()) - Vec3(2.0, 4.0, -0.5)) < 1e-9);
}

TEST_CASE("a volume is sampled like a shape") {
    const auto volume = std::make_shared<Volume>(ballVolume(24));
    SamplerOptions options;
    options.count = 700;
    const Result<PointFile> file = sample(fieldOf(volume, 0.0), options);
    REQUIRE(file.ok());
    REQUIRE(file.value().position.size() == 700);
    const double spacing = std::sqrt(4.0 * test::kPi * 0.49 / 700.0 / 0.866);
    for (std::size_t i = 0; i < 700; ++i) {
        const Vec3 x = file.value().position[i];
        CHECK(std::abs(volume->valueAt(x)) < 1e-4 * spacing);  // a distance, but for the grid
        CHECK(glm::dot(file.value().normal[i], x) > 0.68);
    }
}

TEST_CASE("the lobster's particles are on its surface, as many as in Table 1" *
          doctest::test_suite("long")) {
    const auto path = test::sharedFile("volumes/lobster.nhdr");
    if (path.empty()) return;
    Result<Volume> read = readVolume(path);
    REQUIRE(read.ok());
    const auto volume = std::make_shared<Volume>(std::move(read.value()));
    REQUIRE(volume->isovalue == 30.5);
    SamplerOptions options;
    options.count = 8000;  // 42906 take seconds, see docs/performance.md
    const Result<PointFile> file = sample(fieldOf(volume, 30.5), options);
    REQUIRE(file.ok());
    REQUIRE(file.value().position.size() == 8000);
    double worst = 0.0;
    for (const Vec3& x : file.value().position) {
        const Vec3 g = volume->gradientAt(x);
        worst = std::max(worst, std::abs(volume->valueAt(x) - 30.5) / glm::length(g));
    }
    CHECK(worst < 1e-4);
}

TEST_CASE("gzip: all streams of a file are unpacked, and zeros after the last are no error") {
    const auto unpacked = [](const std::string& packed) {
        const Result<std::string> bytes = unpackGzip(packed, "a.gz", {});
        return bytes.ok() ? bytes.value() : bytes.error().message;
    };
    const std::string one = gzipped("1 2 3\n");
    const std::string many = one + gzipped("") + gzipped(std::string(3000000, 'x'));
    CHECK(unpacked(one) == "1 2 3\n");
    CHECK(unpacked(many) == "1 2 3\n" + std::string(3000000, 'x'));
    CHECK(unpacked(one + std::string(512, '\0')) == "1 2 3\n");
    // A multiple of the piece that is unpacked at once ends exactly with the stream.
    const std::string whole(std::size_t{1} << 20U, 'y');
    CHECK(unpacked(gzipped(whole) + one) == whole + "1 2 3\n");
}

TEST_CASE("gzip: other bytes after the last stream are named with their place") {
    const std::string one = gzipped("1 2 3\n");
    const auto error = [](const std::string& packed) {
        const Result<std::string> bytes = unpackGzip(packed, "a.gz", {});
        REQUIRE_FALSE(bytes.ok());
        return bytes.error().message;
    };
    CHECK(error(one + "garbage") ==
          "a.gz: byte " + std::to_string(one.size()) +
              ": the gzip data end here, and 7 bytes of another kind follow; remove them, or "
              "unpack the file with gunzip");
    CHECK(error(one + one.substr(0, one.size() - 3)).find("end too early") != std::string::npos);
}
