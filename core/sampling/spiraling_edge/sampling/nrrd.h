/// The parts of reading NRRD: the header, the numbers that it describes, and their decompression.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "spiraling_edge/io/scalars.h"
#include "spiraling_edge/sampling/volume.h"

namespace se::io {

struct NrrdHeader {
    ScalarType type = ScalarType::UInt8;
    bool bigEndian = false;
    bool gzip = false;
    std::string dataFile;  ///< As in the header; empty if the data follow the header.
    std::size_t dataFileLine = 0;
    std::uint64_t lineSkip = 0;
    std::int64_t byteSkip = 0;   ///< -1: the data are the last bytes of the file.
    std::size_t dataOffset = 0;  ///< End of the header.
    Volume volume;               ///< Without its values.

    std::size_t samples() const { return volume.size[0] * volume.size[1] * volume.size[2]; }
};

/// Parses the header. In the result, samples() times sizeOf(type) fits a size_t.
Result<NrrdHeader> parseNrrdHeader(std::string_view bytes, const std::string& name);

/// The values, from the bytes that follow the header or those of the data file. `name` is the file
/// that holds them. Fails before it allocates more than `limit`.
Result<Volume> decodeNrrd(const NrrdHeader& header, std::string_view data, const std::string& name,
                          const ByteLimit& limit);

/// The `expected` bytes that a gzip (or zlib) stream holds. Fails, with a reason to append to the
/// name of a file, if it is damaged or holds fewer or more. Allocates nothing that the stream could
/// not fill.
Result<std::string> inflateExactly(std::string_view packed, std::size_t expected);

}  // namespace se::io
