/// Bytes of files: hashes, and UTF-8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace se::teach {

/// 64-bit FNV-1a, as in session files.
class ByteHash {
  public:
    void add(std::string_view bytes);
    /// Adds the eight bytes of a double, the least significant first.
    void add(double number);
    /// "fnv1a64:" and 16 hexadecimal digits.
    std::string text() const;

  private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Hash of a text.
std::string hashOfText(std::string_view text);

/// Line of the first byte that is no UTF-8, from 1; 0 if there is none.
std::size_t lineOfBadByte(std::string_view text);

}  // namespace se::teach
