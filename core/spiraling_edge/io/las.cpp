// LAS, the format of laser scanners: ASPRS LAS Specification 1.0 to 1.4, point formats 0 to 10.
// Packed files (LAZ) have the highest bit of the point format set.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/counted.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

/// Places in the header, in bytes.
constexpr std::size_t kMinorAt = 25;
constexpr std::size_t kHeaderSizeAt = 94;
constexpr std::size_t kPointsBeginAt = 96;
constexpr std::size_t kPointFormatAt = 104;
constexpr std::size_t kRecordSizeAt = 105;
constexpr std::size_t kCountAt = 107;
constexpr std::size_t kScaleAt = 131;
constexpr std::size_t kOffsetAt = 155;
constexpr std::size_t kWaveformsAt = 227;
constexpr std::size_t kExtendedAt = 235;
constexpr std::size_t kLongCountAt = 247;
constexpr std::size_t kLeastHeader = 227;

/// The sizes of records and the places in them, by point format: 0 where a format lacks it.
struct RecordLayout {
    std::size_t size;
    std::size_t classAt;
    std::size_t colorAt;
};
constexpr std::array<RecordLayout, 11> kLayouts{{
    {20, 15, 0},
    {28, 15, 0},
    {26, 15, 20},
    {34, 15, 28},
    {57, 15, 0},
    {63, 15, 28},
    {30, 16, 0},
    {36, 16, 30},
    {38, 16, 30},
    {59, 16, 0},
    {67, 16, 30},
}};
constexpr std::size_t kIntensityAt = 12;

class LasReader : FirstProblem {
  public:
    LasReader(std::string_view bytes, const std::string& name)
        : FirstProblem(name), bytes_(bytes) {}

    Result<PointFile> read() {
        if (!readHeader()) return problem_;
        readPositions();
        if (count_ == 0) return std::move(file_);
        keep("intensity", ScalarType::UInt16, kIntensityAt);
        keep("classification", ScalarType::UInt8, layout().classAt);
        maskClasses();
        keepColors();
        noteWithheld();
        file_.notes.emplace_back("left out: returns, scan angles and the other fields of a record");
        return std::move(file_);
    }

  private:
    template <typename Scalar>
    Scalar at(std::size_t byte) const {
        return loadScalar<Scalar>(bytes_.data() + byte, kLittleIsSwapped);
    }
    const RecordLayout& layout() const { return kLayouts[format_]; }

    bool readHeader() {
        if (bytes_.size() < kLeastHeader) {
            return fail(bytes_.size(), "the file ends within its header of " +
                                           std::to_string(kLeastHeader) +
                                           " bytes; it is cut short");
        }
        const auto packed = at<std::uint8_t>(kPointFormatAt);
        if (packed >= 128) {
            return fail(kPointFormatAt,
                        "the points are packed (LAZ), which cannot be read; unpack them with "
                        "\"pdal translate IN.laz OUT.las\" or \"laszip -i IN.laz -o OUT.las\"");
        }
        format_ = packed;
        if (format_ >= kLayouts.size()) {
            return fail(kPointFormatAt, "expected a point format from 0 to 10, found " +
                                            std::to_string(format_) +
                                            "; convert it with \"pdal translate IN.las OUT.ply\"");
        }
        recordSize_ = at<std::uint16_t>(kRecordSizeAt);
        if (recordSize_ < layout().size) {
            return fail(kRecordSizeAt, "expected records of " + std::to_string(layout().size) +
                                           " bytes or more for point format " +
                                           std::to_string(format_) + ", found " +
                                           std::to_string(recordSize_) + "; the header is damaged");
        }
        return readCount() && readScale();
    }

    bool readCount() {
        begin_ = at<std::uint32_t>(kPointsBeginAt);
        if (begin_ < kLeastHeader) {
            return fail(kPointsBeginAt,
                        "expected the place of the points after the header, found " +
                            std::to_string(begin_) +
                            "; the header is damaged: copy the file again");
        }
        const std::uint64_t count =
            std::max<std::uint64_t>(at<std::uint32_t>(kCountAt), longAt(4, kLongCountAt));
        if (begin_ > bytes_.size() || count > (bytes_.size() - begin_) / recordSize_) {
            const std::uint64_t room =
                begin_ > bytes_.size() ? 0 : (bytes_.size() - begin_) / recordSize_;
            return failCut(byteText(bytes_.size()), room, count, "points");
        }
        if (count >= kNone) return fail(kCountAt, "at most 4294967294 points can be read");
        count_ = static_cast<std::size_t>(count);
        return checkRest();
    }

    /// A number of eight bytes that headers have from a version on; 0 before.
    std::uint64_t longAt(std::uint8_t minor, std::size_t byte) const {
        const bool isThere = at<std::uint8_t>(kMinorAt) >= minor && bytes_.size() >= byte + 8 &&
                             at<std::uint16_t>(kHeaderSizeAt) >= byte + 8;
        return isThere ? at<std::uint64_t>(byte) : 0;
    }

    /// Refuses more points than the header counts: whole records after the last one, up to what
    /// may follow there.
    bool checkRest() {
        const std::size_t end = begin_ + count_ * recordSize_;
        std::string_view rest = bytes_.substr(end);
        for (const std::uint64_t next : {longAt(3, kWaveformsAt), longAt(4, kExtendedAt)}) {
            if (next >= end && next < bytes_.size())
                rest = rest.substr(0, static_cast<std::size_t>(next) - end);
        }
        if (rest.find_first_not_of('\0') == std::string_view::npos) return true;
        if (rest.size() % recordSize_ == 0) {
            return fail(kCountAt, "the header announces " + counted(count_, "point") + ", but " +
                                      std::to_string(rest.size() / recordSize_) +
                                      " more follow; correct it, e.g. with \"lasinfo "
                                      "-i IN.las -repair_counters\"");
        }
        file_.notes.push_back("left out: " + counted(rest.size(), "byte") + " after the points");
        return true;
    }

    bool readScale() {
        for (int axis = 0; axis < 3; ++axis) {
            const auto step = std::size_t{8} * static_cast<std::size_t>(axis);
            scale_[axis] = at<double>(kScaleAt + step);
            offset_[axis] = at<double>(kOffsetAt + step);
            if (std::isfinite(scale_[axis]) && scale_[axis] != 0.0 && std::isfinite(offset_[axis]))
                continue;
            return fail(kScaleAt + step,
                        "expected a finite scale other than 0 and a finite offset for each axis; "
                        "the header is damaged");
        }
        return true;
    }

    const char* record(std::size_t point) const {
        return bytes_.data() + begin_ + point * recordSize_;
    }

    void readPositions() {
        file_.positionType = ScalarType::Double;
        file_.position.reserve(count_);
        for (std::size_t point = 0; point < count_; ++point) {
            Vec3 place;
            for (int axis = 0; axis < 3; ++axis) {
                const auto steps =
                    loadScalar<std::int32_t>(record(point) + 4 * axis, kLittleIsSwapped);
                place[axis] = static_cast<double>(steps) * scale_[axis] + offset_[axis];
            }
            file_.position.push_back(place);
        }
    }

    /// Keeps a number of each record as a column, unless it is 0 in all of them.
    void keep(const char* name, ScalarType type, std::size_t byte) {
        Attribute column{name, type, std::vector<double>(count_)};
        Column{column.values.data(), 1}.load(type, record(0) + byte, recordSize_, count_,
                                             kLittleIsSwapped);
        const auto isZero = [](double value) { return value == 0.0; };
        if (std::all_of(column.values.begin(), column.values.end(), isZero)) return;
        file_.attributes.push_back(std::move(column));
    }

    /// Formats before 6 hold three flags above the five bits of the class.
    void maskClasses() {
        constexpr unsigned kClass = 31;
        for (Attribute& column : file_.attributes) {
            if (format_ >= 6 || column.name != "classification") continue;
            for (double& value : column.values)
                value = static_cast<double>(static_cast<unsigned>(value) & kClass);
        }
    }

    /// Points that a program before has marked as not to be used stay: only the user knows.
    void noteWithheld() {
        const unsigned bit = format_ >= 6 ? 4U : 128U;
        std::size_t withheld = 0;
        for (std::size_t point = 0; point < count_; ++point) {
            const auto flags = loadScalar<std::uint8_t>(record(point) + 15, kLittleIsSwapped);
            withheld += (flags & bit) != 0 ? 1U : 0U;
        }
        if (withheld > 0)
            file_.notes.push_back(counted(withheld, "point") + " marked as withheld: used");
    }

    /// Colors have 16 bits; many writers use the lower 8 alone.
    void keepColors() {
        if (layout().colorAt == 0) return;
        const auto color = [this](std::size_t point, int channel) -> unsigned {
            return loadScalar<std::uint16_t>(record(point) + layout().colorAt + 2 * channel,
                                             kLittleIsSwapped);
        };
        unsigned most = 0;
        for (std::size_t point = 0; point < count_; ++point) {
            for (int channel = 0; channel < 3; ++channel)
                most = std::max(most, color(point, channel));
        }
        if (most == 0) return;
        const unsigned divisor = most > 255 ? 256 : 1;
        addColorColumns(
            file_, [&](std::size_t point, int channel) { return color(point, channel) / divisor; });
        if (divisor > 1) {
            file_.notes.emplace_back("colors of 16 bits are kept as red, green and blue of 8 bits");
        }
    }

    std::string_view bytes_;
    std::size_t format_ = 0;
    std::size_t recordSize_ = 0;
    std::size_t begin_ = 0;
    std::size_t count_ = 0;
    Vec3 scale_{1.0};
    Vec3 offset_{0.0};
    PointFile file_;
};

}  // namespace

bool isLas(const FileStart& start) { return start.bytes.starts_with("LASF"); }

Result<PointFile> readLas(std::string_view bytes, const std::string& name) {
    return LasReader(bytes, name).read();
}

}  // namespace se::io
