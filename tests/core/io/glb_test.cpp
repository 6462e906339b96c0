// GLB from this program and built by hand: what other programs write, and what is damaged.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "spiraling_edge/io/read_points.h"
#include "spiraling_edge/io/write_mesh.h"
#include "spiraling_edge/prepare/prepare.h"
#include "spiraling_edge/run/reconstruct.h"
#include "spiraling_edge/scenes/scenes.h"
#include "support/io_support.h"

using namespace se;
using namespace se::test;

namespace {

template <typename Number>
void append(std::string& bytes, std::initializer_list<Number> numbers) {
    // Tests run on little endian machines.
    for (const Number number : numbers)
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);  // NOLINT
}

std::string glb(std::string json, std::string binary) {
    while (json.size() % 4 != 0) json += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    const auto size = [](const std::string& chunk) {
        return static_cast<std::uint32_t>(chunk.size());
    };
    std::string bytes = "glTF";
    append<std::uint32_t>(bytes, {2, 28 + size(json) + size(binary), size(json), 0x4E4F534A});
    bytes += json;
    append<std::uint32_t>(bytes, {size(binary), 0x004E4942});
    return bytes + binary;
}

/// A document of one scene, with these lists of nodes, primitives of its mesh, accessors and views.
std::string document(const std::string& nodes, const std::string& primitives,
                     const std::string& accessors, const std::string& views,
                     const std::string& more = {}) {
    return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
           R"(],"meshes":[{"primitives":[)" + primitives + R"(]}],"accessors":[)" + accessors +
           R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":999}])" + more + "}";
}

const std::string kNode = R"({"mesh":0})";
const std::string kPrimitive = R"({"attributes":{"POSITION":0},"indices":1})";
const std::string kAccessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                               R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"})";
const std::string kViews =
    R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12})";

/// A square of two triangles in the plane z = 0.
std::string squareBytes() {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    append<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
    return bytes;
}
std::string squareFile() {
    return glb(document(kNode, kPrimitive, kAccessors, kViews), squareBytes());
}
/// The error of the square with one piece of its document replaced.
std::string errorWith(const std::string& old, const std::string& fresh) {
    std::string json = document(kNode, kPrimitive, kAccessors, kViews);
    const std::size_t at = json.find(old);
    REQUIRE(at != std::string::npos);
    json.replace(at, old.size(), fresh);
    return errorOf(glb(json, squareBytes()));
}

const std::vector<Triangle> kSquareFaces{{0, 1, 2}, {0, 2, 3}};

}  // namespace

TEST_CASE("GLB: what this program writes reads back, with or without triangles") {
    const PointFile sphere = findScene("sphere")->build();
    const PointSet points = prepare(sphere, {}).value().points;
    const auto mesh = reconstruct(points, *paramsByName("robust")).state.mesh();
    REQUIRE(mesh.size() == 1196);
    for (const double shift : {0.0, 5e6}) {
        PointFile moved = sphere;
        for (Vec3& x : moved.position) x += shift;
        for (const auto& triangles : {mesh, std::vector<Triangle>{}}) {
            const PointFile read = mustRead(meshFormatOf("a.glb")->bytes(moved, triangles));
            CHECK(read.faces == triangles);
            CHECK(read.notes.empty());
            REQUIRE(read.position.size() == moved.position.size());
            REQUIRE(read.normal.size() == moved.normal.size());
            for (std::size_t p = 0; p < read.position.size(); ++p) {
                CHECK(glm::distance(read.position[p], moved.position[p]) < 1e-6);
                CHECK(glm::distance(read.normal[p], moved.normal[p]) < 1e-6);
            }
        }
    }
}

TEST_CASE("GLB: triangles by indices, and points that no triangle has") {
    const PointFile file = mustRead(squareFile());
    CHECK(file.faces == kSquareFaces);
    CHECK(file.position == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(file.positionType == ScalarType::Float);
    CHECK_FALSE(file.hasNormals());
    std::string json = document(kNode, kPrimitive, kAccessors, kViews);
    json.replace(json.find("\"count\":6"), 9, "\"count\":3");
    const PointFile one = mustRead(glb(json, squareBytes()));
    CHECK(one.position.size() == 4);
    CHECK(one.faces == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("GLB: strips, fans, lists without indices, and lines, which are left out") {
    const auto read = [](const std::string& mode, const std::string& indices) {
        return mustRead(
            glb(document(kNode, R"({"attributes":{"POSITION":0})" + indices + mode + "}",
                         kAccessors, kViews),
                squareBytes()));
    };
    CHECK(read(R"(,"mode":6)", "").faces == kSquareFaces);
    CHECK(read(R"(,"mode":5)", "").faces == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    CHECK(read("", "").faces == std::vector<Triangle>{{0, 1, 2}});
    CHECK(read(R"(,"mode":0)", "").faces.empty());
    const std::string lines = kPrimitive + R"(,{"attributes":{"POSITION":0},"mode":1})";
    const PointFile both = mustRead(glb(document(kNode, lines, kAccessors, kViews), squareBytes()));
    CHECK(both.notes == std::vector<std::string>{"left out: lines"});
    CHECK(both.position.size() == 4);
}

TEST_CASE("GLB: nodes move, turn, scale and mirror their meshes, one inside the other") {
    // 90 degrees about z.
    const std::string nodes =
        R"({"children":[1],"translation":[10,0,0]},)"
        R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,2,2]})";
    const PointFile turned =
        mustRead(glb(document(nodes, kPrimitive, kAccessors, kViews), squareBytes()));
    CHECK(glm::distance(turned.position[1], Vec3(10, 2, 0)) < 1e-12);
    CHECK(glm::distance(turned.position[3], Vec3(8, 0, 0)) < 1e-12);
    CHECK(turned.faces == kSquareFaces);
    CHECK(turned.positionType == ScalarType::Double);
    // Mirrored in x, and longer in y: the normals (1 1 0) become (-1 0.5 0).
    std::string bytes = squareBytes();
    for (int i = 0; i < 4; ++i) append<float>(bytes, {1, 1, 0});
    const PointFile mirrored = mustRead(glb(
        document(R"({"mesh":0,"matrix":[-1,0,0,0, 0,2,0,0, 0,0,1,0, 0,0,5,1]})",
                 R"({"attributes":{"POSITION":0,"NORMAL":2},"indices":1})",
                 kAccessors + R"(,{"bufferView":2,"componentType":5126,"count":4,"type":"VEC3"})",
                 kViews + R"(,{"buffer":0,"byteOffset":60,"byteLength":48})"),
        bytes));
    CHECK(mirrored.position[2] == Vec3(-1, 2, 5));
    CHECK(mirrored.faces == std::vector<Triangle>{{0, 2, 1}, {0, 3, 2}});
    for (const Vec3& n : mirrored.normal)
        CHECK(glm::distance(n, glm::normalize(Vec3(-1, 0.5, 0))) < 1e-12);
}

TEST_CASE("GLB: a mesh that two nodes place is there twice") {
    std::string json =
        document(R"({"mesh":0},{"mesh":0,"translation":[5,0,0]})", kPrimitive, kAccessors, kViews);
    json.replace(json.find("\"nodes\":[0]"), 11, "\"nodes\":[0,1]");
    const PointFile file = mustRead(glb(json, squareBytes()));
    CHECK(file.position.size() == 8);
    CHECK(file.faces.size() == 4);
}

TEST_CASE("GLB: vertices of triangles at one place are one point with the mean of their normals") {
    // Two squares at the edge x = 0, each with vertices and a normal of its own.
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    append<float>(bytes, {0, 0, 0, 0, 1, 0, 0, 0, 1});
    for (int i = 0; i < 3; ++i) append<float>(bytes, {0, 0, 1});
    for (int i = 0; i < 3; ++i) append<float>(bytes, {1, 0, 0});
    const std::string accessors =
        R"({"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5126,"count":6,"type":"VEC3"})";
    const std::string views =
        R"({"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":72})";
    const auto read = [&](const std::string& mode) {
        return mustRead(
            glb(document(kNode, R"({"attributes":{"POSITION":0,"NORMAL":1},"mode":)" + mode + "}",
                         accessors, views),
                bytes));
    };
    const PointFile merged = read("4");
    CHECK(merged.position.size() == 4);
    CHECK(merged.faces == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    CHECK(glm::distance(merged.normal[0], glm::normalize(Vec3(1, 0, 1))) < 1e-12);
    CHECK(merged.notes == std::vector<std::string>{
                              "2 vertices at the place of another one: one point for each place",
                              "2 places with several normals: the mean of them is used"});
    // Points without triangles stay as they are.
    CHECK(read("0").position.size() == 6);
}

TEST_CASE("GLB: colors of 8 and 16 bits and fractions are kept from 0 to 255") {
    std::string bytes = squareBytes();
    append<std::uint8_t>(bytes, {255, 0, 51, 255, 0, 0, 0, 255, 255, 255, 255, 0, 1, 2, 3, 4});
    append<std::uint16_t>(bytes, {65535, 0, 13107, 0, 0, 0, 65535, 65535, 65535, 257, 514, 771});
    append<float>(bytes, {1, 0, 0.2F, 0, 0, 0, 1, 1, 1, 1 / 255.0F, 2 / 255.0F, 3 / 255.0F});
    const std::string views = kViews + R"(,{"buffer":0,"byteOffset":60,"byteLength":16})"
                                       R"(,{"buffer":0,"byteOffset":76,"byteLength":24})"
                                       R"(,{"buffer":0,"byteOffset":100,"byteLength":48})";
    const std::string kinds[] = {
        R"(,{"bufferView":2,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"})",
        R"(,{"bufferView":3,"componentType":5123,"normalized":true,"count":4,"type":"VEC3"})",
        R"(,{"bufferView":4,"componentType":5126,"count":4,"type":"VEC3"})"};
    for (const std::string& kind : kinds) {
        CAPTURE(kind);
        const PointFile file =
            mustRead(glb(document(kNode, R"({"attributes":{"POSITION":0,"COLOR_0":2},"indices":1})",
                                  kAccessors + kind, views),
                         bytes));
        REQUIRE(file.attributes.size() == 3);
        CHECK(file.attributes[0].name == "red");
        CHECK(file.attributes[0].values == std::vector<double>{255, 0, 255, 1});
        CHECK(file.attributes[2].values == std::vector<double>{51, 0, 255, 3});
    }
}

TEST_CASE("GLB: interleaved attributes, and primitives that share their vertices") {
    std::string bytes;
    for (int i = 0; i < 4; ++i)
        append<float>(bytes, {static_cast<float>(i), static_cast<float>(i * i), 0, 0, 0, 1});
    append<std::uint8_t>(bytes, {0, 1, 2, 1, 2, 3});
    const std::string accessors =
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":4,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},)"
        R"({"bufferView":1,"byteOffset":3,"componentType":5121,"count":3,"type":"SCALAR"})";
    const std::string views =
        R"({"buffer":0,"byteLength":96,"byteStride":24},{"buffer":0,"byteOffset":96,"byteLength":6})";
    const PointFile file =
        mustRead(glb(document(kNode,
                              R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":2},)"
                              R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":3})",
                              accessors, views),
                     bytes));
    CHECK(file.position == std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 4, 0}, {3, 9, 0}});
    CHECK(file.normal == std::vector<Vec3>(4, Vec3(0, 0, 1)));
    CHECK(file.faces == std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}});
    CHECK(file.notes.empty());
}

TEST_CASE("GLB: materials, skins, morph targets and other attributes are said to be left out") {
    const PointFile file = mustRead(
        glb(document(R"({"mesh":0,"skin":0})",
                     R"({"attributes":{"POSITION":0,"TEXCOORD_0":0,"_TIME":0},"indices":1,)"
                     R"("material":0,"targets":[{}]})",
                     kAccessors, kViews),
            squareBytes()));
    CHECK(file.notes == std::vector<std::string>{"left out: attribute TEXCOORD_0",
                                                 "left out: attribute _TIME", "left out: materials",
                                                 "left out: morph targets",
                                                 "left out: skins: meshes are as stored"});
}

TEST_CASE("GLB: extensions of nodes that place meshes otherwise are named, others are not") {
    const auto notesOf = [](const std::string& extension) {
        const std::string node = R"({"mesh":0,"extensions":{")" + extension + R"(":{}}})";
        return mustRead(glb(document(node, kPrimitive, kAccessors, kViews), squareBytes())).notes;
    };
    CHECK(notesOf("EXT_mesh_gpu_instancing") ==
          std::vector<std::string>{"left out: extension EXT_mesh_gpu_instancing of nodes"});
    CHECK(notesOf("KHR_lights_punctual").empty());
}

TEST_CASE("GLB: what cannot be read is named, with its byte") {
    CHECK(contains(errorWith(R"({"byteLength":999})", R"({"uri":"a.bin"})"),
                   "the data are not in the chunk BIN"));
    CHECK(contains(
        errorWith(R"("asset")", R"("extensionsRequired":["KHR_draco_mesh_compression"],"asset")"),
        "byte 43: the file needs the extension \"KHR_draco_mesh_compression\""));
    CHECK(contains(errorWith(R"("count":4)", R"("sparse":{},"count":4)"), "sparse"));
    CHECK(contains(errorWith(R"({"bufferView":0,)", "{"), "sparse or compressed"));
    CHECK(
        contains(errorWith(R"("POSITION":0)", R"("NORMAL":0)"), "expected the attribute POSITION"));
    std::string old = squareFile();
    old[4] = 1;
    CHECK(contains(errorOf(old), "byte 4: expected version 2, found 1"));
    CHECK(mustRead(glb("{}", "")).position.empty());
}

TEST_CASE("GLB: numbers that point outside of the file are refused before they are used") {
    CHECK(contains(errorWith(R"("count":4)", R"("count":5)"), "5 elements of the accessor"));
    CHECK(contains(errorWith(R"("count":4)", R"("count":4000000000000)"), "do not fit"));
    CHECK(contains(errorWith(R"("count":4)", R"("count":-1)"), "expected a whole number"));
    CHECK(contains(errorWith(R"("count":4)", R"("byteOffset":8,"count":4)"), "do not fit"));
    CHECK(contains(errorWith(R"("byteLength":48)", R"("byteLength":48000)"), "beyond the chunk"));
    CHECK(contains(errorWith(R"("byteLength":48)", R"("byteStride":4,"byteLength":48)"),
                   "do not fit"));
    CHECK(contains(errorWith(R"("byteOffset":48)", R"("byteOffset":9007199254740000)"), "beyond"));
    CHECK(contains(errorWith(R"("buffer":0)", R"("buffer":1)"), "beyond the chunk"));
    CHECK(contains(errorWith(R"("indices":1)", R"("indices":9)"), "one of the 2 accessors"));
    CHECK(contains(errorWith(R"("indices":1)", R"("indices":0)"), "single numbers"));
    CHECK(contains(errorWith(R"("POSITION":0)", R"("POSITION":1)"), "vectors"));
    CHECK(contains(errorWith(R"("mesh":0)", R"("mesh":0.5)"), "one of the 1 mesh"));
    CHECK(contains(errorWith(R"({"mesh":0})", R"({"mesh":0,"children":[0]})"), "in itself"));
    CHECK(contains(errorWith(R"({"mesh":0})", R"({"mesh":0,"matrix":[1,2]})"), "16 numbers"));
    std::string bytes = squareBytes();
    bytes[48] = 4;
    CHECK(contains(errorOf(glb(document(kNode, kPrimitive, kAccessors, kViews), bytes)),
                   "name a vertex beyond the 4"));
}

TEST_CASE("GLB: nodes cannot place more points than memory holds" * doctest::test_suite("long")) {
    // Each node places the square with four vertices; a thousand primitives share no vertices.
    std::string primitives;
    for (int i = 0; i < 1000; ++i) {
        primitives += (i > 0 ? "," : "");
        primitives += R"({"attributes":{"POSITION":0}})";
    }
    const std::string many = glb(document(kNode, primitives, kAccessors, kViews), squareBytes());
    CHECK(mustRead(many).position.size() == 4);
    std::string nodes;
    std::string numbers;
    for (int i = 0; i < 300; ++i) {
        nodes += (i > 0 ? "," : "") + kNode;
        numbers += (i > 0 ? "," : "") + std::to_string(i);
    }
    std::string binary;
    for (int i = 0; i < 20000; ++i) append<float>(binary, {static_cast<float>(i), 0, 0});
    std::string json =
        document(nodes, R"({"attributes":{"POSITION":0},"mode":0})",
                 R"({"bufferView":0,"componentType":5126,"count":20000,"type":"VEC3"})",
                 R"({"buffer":0,"byteLength":240000})");
    json.replace(json.find("\"nodes\":[0]"), 11, "\"nodes\":[" + numbers + "]");
    CHECK(contains(errorOf(glb(json, binary)), "place more than 22"));
}

TEST_CASE("GLB: a file cut at any byte is refused, with the byte where it ends") {
    const std::string whole = squareFile();
    for (std::size_t size = 4; size < whole.size(); ++size) {
        CAPTURE(size);
        CHECK(contains(errorOf(whole.substr(0, size)), "byte " + std::to_string(size)));
    }
}

TEST_CASE("GLB: errors in its JSON name their byte in the file") {
    CHECK(contains(errorOf(glb("{\"a\":}", "")), "byte 25: expected a value"));
    CHECK(contains(errorOf(glb("{\"a\" 1}", "")), "expected \":\""));
    CHECK(contains(errorOf(glb("[1,2", "")), "byte 24: the JSON text ends within a value"));
    CHECK(contains(errorOf(glb("[1 2]", "")), "expected \",\" or \"]\""));
    CHECK(contains(errorOf(glb("[1e999]", "")), "expected a value"));
    CHECK(contains(errorOf(glb("[nan]", "")), "expected a value"));
    CHECK(contains(errorOf(glb("[] []", "")), "goes on after its end"));
    CHECK(contains(errorOf(glb("[\"abc", "")), "ends within"));
    CHECK(contains(errorOf(glb(std::string(70000, '['), "")), "more than 64 levels"));
    std::string many = "[0";
    for (int i = 0; i < 2000000; ++i) many += ",0";
    CHECK(contains(errorOf(glb(many + "]", "")), "more than 2,000,000 values"));
    // Escapes and words are read; nothing is there to be placed.
    CHECK(mustRead(glb(R"({"a\n\"\u00e4":[true,false,null,-1.5e3,{}],"b":""})", ""))
              .position.empty());
}
