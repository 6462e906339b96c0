/// The document and the numbers of a GLB file (binary glTF 2.0), checked against its size before
/// they are used.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/json_value.h"

namespace se::io {

/// Numbers of the binary chunk, known to lie within it.
struct GlbAccessor {
    const char* first = nullptr;
    std::size_t stride = 0;  ///< Bytes from one element to the next.
    std::size_t count = 0;   ///< Elements.
    std::size_t width = 0;   ///< Numbers of an element.
    ScalarType type = ScalarType::Float;
    bool normalized = false;  ///< Whole numbers stand for 0 to 1, or -1 to 1.

    /// The first three numbers of each element, of at least three.
    std::vector<Vec3> vectors() const;
    /// The only number of each element.
    std::vector<double> numbers() const;
};

/// Reads the two chunks of a file, and the accessors that its document names. Members that return
/// false have set the problem, with its byte.
class GlbData : protected FirstProblem {
  protected:
    GlbData(std::string_view bytes, const std::string& name) : FirstProblem(name), bytes_(bytes) {}

    /// Reads the chunks. Fails for extensions that change places or triangles, and for data in
    /// other files.
    bool readDocument();
    const JsonValue& document(std::string_view member) const { return root_.member(member); }
    std::size_t fileSize() const { return bytes_.size(); }

    /// The number of an item of a list of the document; `noun` is one of them.
    bool readNumber(const JsonValue& value, std::string_view list, const char* noun,
                    std::size_t& number);
    /// A whole number; 0 where it is missing.
    bool readSize(const JsonValue& value, std::uint64_t& size);
    /// An accessor of single numbers (`width` 1), or of vectors of at least `width` numbers.
    bool readAccessor(const JsonValue& reference, std::size_t width, GlbAccessor& accessor);

  private:
    std::uint32_t wordAt(std::size_t byte) const;
    bool readChunk(std::size_t& at, std::uint32_t type, const char* kind, std::string_view& chunk);
    bool readChunks();
    bool readView(const JsonValue& value, GlbAccessor& accessor);

    std::string_view bytes_;
    std::string_view binary_;
    JsonValue root_;
};

}  // namespace se::io
