/// Measured volumes: scalars on a grid, read from NRRD files, and the field between them.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/result.h"
#include "spiraling_edge/sampling/field.h"

namespace se {

/// Samples at the corners of equal cells.
struct Volume {
    std::array<std::size_t, 3> size{};  ///< Along x, y and z; at least 2 each.
    Vec3 spacing{1.0};                  ///< Between samples; above 0.
    Vec3 origin{0.0};                   ///< Position of the first sample.
    std::vector<float> value;           ///< Finite; x fastest. Doubles of a file are rounded.
    /// Value of the key `isovalue` of the file.
    std::optional<double> isovalue;

    Vec3 high() const;  ///< Position of the last sample.
    float at(std::size_t i, std::size_t j, std::size_t k) const {
        return value[(k * size[1] + j) * size[0] + i];
    }
    /// Trilinear interpolation; outside the grid the value at its nearest place.
    double valueAt(const Vec3& x) const;
    /// Differences of valueAt() over half a spacing to both sides: the slope, averaged over the
    /// width of a cell. Continuous; central differences of the samples would be smoother, but have
    /// arbitrary directions on parts as thin as a spacing.
    Vec3 gradientAt(const Vec3& x) const;
};

/// Extensions of volumes, in lower case: ".nrrd", ".nhdr".
std::span<const std::string_view> volumeExtensions();
/// True if the extension, in upper or lower case, is one of them.
bool isVolumePath(const std::filesystem::path& path);

/// Reads NRRD (http://teem.sourceforge.net/nrrd/format.html), attached (.nrrd) or with its data in
/// a file beside it (.nhdr): three dimensions, integers of 8 to 32 bits, float or double in either
/// byte order, raw or gzip, axis-aligned spacings or space directions. Errors name the file and
/// the line, what was expected and what to do. Nothing is allocated that the file cannot fill, or
/// that is over `limit`: for each of the files, their unpacked bytes, and the values of the volume.
Result<Volume> readVolume(const std::filesystem::path& path, const ByteLimit& limit = {});
/// The file that holds the values of a volume; empty if the volume itself does, or cannot be read.
std::filesystem::path dataFileOf(const std::filesystem::path& path);
/// Reads a volume from memory, attached data only; `name` is its name in errors.
Result<Volume> readVolume(std::string_view bytes, const std::string& name,
                          const ByteLimit& limit = {});

/// The field of a volume in the box of its samples: higher values are inside. Requires 2 samples
/// along each axis.
Field fieldOf(const std::shared_ptr<const Volume>& volume, double isovalue);

}  // namespace se
