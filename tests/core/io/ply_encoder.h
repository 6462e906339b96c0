/// Makes binary PLY files out of text, for the tests of the reader.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "support/io_support.h"

namespace se::test {

/// Encodes text PLY as binary: an independent, naive conversion.
class BinaryEncoder {
  public:
    BinaryEncoder(const std::string& ascii, bool bigEndian) : big_(bigEndian) {
        const std::string_view mark = "end_header\n";
        const std::size_t body = ascii.find(mark) + mark.size();
        out_ = replaced(ascii.substr(0, body), "ascii",
                        bigEndian ? "binary_big_endian" : "binary_little_endian");
        std::istringstream header(ascii.substr(0, body));
        std::istringstream rows(ascii.substr(body));
        std::vector<std::vector<std::string>> properties;
        int count = 0;
        for (std::string line; std::getline(header, line);) {
            std::istringstream words(line);
            std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
            if (word[0] == "element" || word[0] == "end_header") {
                encode(rows, properties, count);
                properties.clear();
                if (word[0] == "element") count = std::stoi(word[2]);
            }
            if (word[0] == "property") properties.push_back(word);
        }
    }
    const std::string& bytes() const { return out_; }

  private:
    void encode(std::istream& rows, const std::vector<std::vector<std::string>>& properties,
                int count) {
        for (int row = 0; row < count; ++row) {
            for (const auto& word : properties) {
                if (word[1] != "list") {
                    put(word[1], next(rows));
                    continue;
                }
                const double size = next(rows);
                put(word[2], size);
                for (int i = 0; i < static_cast<int>(size); ++i) put(word[3], next(rows));
            }
        }
    }
    static double next(std::istream& rows) {
        std::string word;
        rows >> word;
        return std::stod(word);
    }
    template <typename Scalar>
    void putAs(double value) {
        const auto scalar = static_cast<Scalar>(value);
        std::string raw(sizeof scalar, '\0');
        std::memcpy(raw.data(), &scalar, sizeof scalar);
        const int one = 1;
        const bool bigHost = *reinterpret_cast<const char*>(&one) == 0;
        if (big_ != bigHost) std::reverse(raw.begin(), raw.end());
        out_ += raw;
    }
    void put(const std::string& type, double value) {
        if (type == "uchar") putAs<std::uint8_t>(value);
        if (type == "short") putAs<std::int16_t>(value);
        if (type == "ushort") putAs<std::uint16_t>(value);
        if (type == "int") putAs<std::int32_t>(value);
        if (type == "uint") putAs<std::uint32_t>(value);
        if (type == "float") putAs<float>(value);
        if (type == "double") putAs<double>(value);
    }

    bool big_;
    std::string out_;
};

}  // namespace se::test
