#include <array>
#include <cstdio>

#include "spiraling_edge/io/read_points.h"

namespace se {

Result<PointFile> readStandardInput() {
    const std::string name = "standard input";
    std::string bytes;
    std::array<char, 1U << 16U> block{};
    std::size_t count = 0;
    while ((count = std::fread(block.data(), 1, block.size(), stdin)) > 0)
        bytes.append(block.data(), count);
    if (std::ferror(stdin) != 0) return Error{name + ": cannot be read"};
    return readPoints(bytes, name);
}

}  // namespace se
