/// PCD, the format of the Point Cloud Library: a header in text, then rows in text or binary.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/io/formats.h"
#include "spiraling_edge/io/scalars.h"

namespace se::io {
namespace {

/// A column, or several of the same name if `count` is more than one.
struct PcdField {
    std::string name;
    std::size_t size = 4;
    char kind = 'F';
    std::uint64_t count = 1;

    /// Nothing for a kind that does not come in this size.
    std::optional<ScalarType> type() const {
        constexpr std::string_view kKinds = "IUIUIUFFIU";  // By ScalarType.
        for (std::size_t i = 0; i < kKinds.size(); ++i) {
            const auto type = static_cast<ScalarType>(i);
            if (kind == kKinds[i] && size == sizeOf(type)) return type;
        }
        return std::nullopt;
    }
    /// The size of all its numbers in a row.
    std::size_t bytes() const { return size * static_cast<std::size_t>(count); }
    bool isColor() const { return (name == "rgb" || name == "rgba") && size == 4 && count == 1; }
    /// The type of its numbers in memory. Requires a type().
    ScalarType valueType() const {
        assert(isColor() || type());
        return isColor() ? ScalarType::UInt32 : *type();
    }
};

/// The bytes of an LZF stream (Lehmann, LibLZF): of literals, and of references to bytes before. At
/// most `size`; fewer if the stream is damaged.
std::string unpackLzf(std::string_view packed, std::size_t size) {
    std::string bytes;
    bytes.reserve(std::min(size, 88 * packed.size()));
    std::size_t at = 0;
    const auto byte = [&] { return static_cast<std::uint8_t>(packed[at++]); };
    while (at < packed.size()) {
        const std::size_t control = byte();
        if (control < 32) {
            const std::size_t length = control + 1;
            if (length > packed.size() - at || length > size - bytes.size()) break;
            bytes.append(packed.substr(at, length));
            at += length;
            continue;
        }
        std::size_t length = control >> 5U;
        if (packed.size() - at < (length == 7 ? 2U : 1U)) break;
        if (length == 7) length += byte();
        length += 2;
        const std::size_t back = ((control & 31U) << 8U) + byte() + 1;
        if (back > bytes.size() || length > size - bytes.size()) break;
        // Byte by byte: a reference may reach into the bytes that it makes.
        for (; length > 0; --length) bytes.push_back(bytes[bytes.size() - back]);
    }
    return bytes;
}

class PcdReader : LineByLine {
  public:
    PcdReader(std::string_view bytes, const std::string& name)
        : LineByLine(bytes, name), whole_(bytes.size()) {}

    Result<PointFile> read() {
        if (!readHeader() || !checkHeader()) return problem_;
        makeColumns();
        if (!readRows()) return problem_;
        rounded_.addNotes(file_.notes);
        splitColors();
        return std::move(file_);
    }

  private:
    enum class Data : std::uint8_t { Text, Binary, Compressed };

    // ---- header -----------------------------------------------------------------------------

    bool readHeader() {
        while (lines_.nextContent('#')) {
            Fields words(lines_.line());
            const std::string_view key = words.next();
            if (key == "DATA") return readData(words.next());
            if (!readEntry(key, words)) return false;
        }
        return fail("the header ends without DATA; the file is cut short");
    }

    bool readData(std::string_view kind) {
        constexpr std::array<std::string_view, 3> kNames{"ascii", "binary", "binary_compressed"};
        return parseName(kNames, kind, data_) ||
               fail("expected ascii, binary or binary_compressed after DATA, found " +
                    inQuotes(kind));
    }

    bool readEntry(std::string_view key, Fields& words) {
        if (key == "FIELDS" || key == "COLUMNS") {
            for (auto word = words.next(); !word.empty(); word = words.next())
                fields_.push_back({std::string(word)});
            return true;
        }
        if (key == "SIZE") {
            return forEachField(key, words, [&](PcdField& field, std::string_view word) {
                std::int64_t number = 0;
                if (!parseInteger(word, number)) return false;
                field.size = static_cast<std::size_t>(number);
                return number == 1 || number == 2 || number == 4 || number == 8;
            });
        }
        if (key == "TYPE") {
            return forEachField(key, words, [](PcdField& field, std::string_view word) {
                field.kind = word.empty() ? '?' : word.front();
                return word == "F" || word == "I" || word == "U";
            });
        }
        if (key == "COUNT") {
            return forEachField(key, words, [](PcdField& field, std::string_view word) {
                constexpr std::int64_t kMax = 1 << 20;
                return parseCount(word, field.count, kMax);
            });
        }
        if (key == "WIDTH") return readNumber(key, words, width_);
        if (key == "HEIGHT") return readNumber(key, words, height_);
        if (key == "POINTS") return readNumber(key, words, points_);
        if (key == "VIEWPOINT") return readViewpoint(words);
        if (key == "VERSION") return true;
        return fail("expected a line of a PCD header (FIELDS, SIZE, ...), found " + inQuotes(key));
    }

    /// A place and a turn. The origin, which many programs write without a thought, tells nothing.
    bool readViewpoint(Fields& words) {
        Vec3 place{0.0};
        if (parseVector(words, place) && isFinite(place) && place != Vec3(0.0))
            file_.viewpoint = place;
        return true;
    }

    template <typename Take>
    bool forEachField(std::string_view key, Fields& words, Take&& take) {
        for (PcdField& field : fields_) {
            const std::string_view word = words.next();
            if (!take(field, word)) {
                return fail(std::string(key) + " of field " + inQuotes(field.name) + " is " +
                            inQuotes(word) + "; correct the header");
            }
        }
        return words.next().empty() ||
               fail(std::string(key) + " names more fields than FIELDS; correct the header");
    }

    bool readNumber(std::string_view key, Fields& words, std::optional<std::uint64_t>& number) {
        const std::string_view word = words.next();
        return parseCount(word, number.emplace(0), kNone - 1) ||
               fail("expected a number of points after " + std::string(key) + ", found " +
                    inQuotes(word));
    }

    /// The field of numbers of this name; if there is none, one whose name differs only in case.
    const PcdField* find(std::string_view name) const {
        return findInAnyCase(fields_, name, [](const PcdField& field) {
            return field.count == 1 && field.kind == 'F' && field.type();
        });
    }

    bool checkHeader() {
        if (!points_ && width_) points_ = *width_ * height_.value_or(1);
        if (!points_) return fail("the header does not say how many POINTS there are");
        if (width_ && height_ && *width_ * *height_ != *points_) {
            return fail("WIDTH times HEIGHT is " + std::to_string(*width_ * *height_) +
                        ", but POINTS is " + std::to_string(*points_) + "; correct the header");
        }
        for (const char* axis : kAxes) {
            if (find(axis) == nullptr) {
                return fail(std::string("there is no field ") + axis +
                            " of type F and size 4 or 8; the algorithm needs x, y and z");
            }
        }
        rowSize_ = 0;
        std::uint64_t numbers = 0;
        for (const PcdField& field : fields_) {
            rowSize_ += field.bytes();
            numbers += field.count;
        }
        // Checked before allocation: a number has at least two bytes in text, with its separator.
        // Three bytes of a compressed file unpack to 264 at most.
        std::uint64_t room = lines_.rest().size() + 1;
        if (data_ == Data::Compressed) room *= 88;
        const std::uint64_t least = data_ == Data::Text ? 2 * numbers : rowSize_;
        if (*points_ <= room / least) return true;
        if (data_ != Data::Text) return failCut(0);
        // Without columns nothing is stored: this finds the line where the file is too short.
        columns_.assign(fields_.size(), {});
        return readText() && failCut(0);
    }

    bool failCut(std::uint64_t found) {
        const bool isText = data_ == Data::Text;
        return LineByLine::failCut(isText ? lineText(lines_.number()) : byteText(whole_), found,
                                   *points_, "points");
    }

    // ---- rows -------------------------------------------------------------------------------

    void makeColumns() {
        const auto n = static_cast<std::size_t>(*points_);
        columns_.assign(fields_.size(), {});
        takeVectors(kAxes, file_.position, file_.positionType);
        takeVectors(namesThere(kNormals, kShortNormals, [this](auto name) { return find(name); }),
                    file_.normal, file_.normalType);
        for (std::size_t i = 0; n > 0 && i < fields_.size(); ++i) {
            if (columns_[i].first != nullptr || fields_[i].name == "_") continue;
            if (!isAttribute(fields_[i])) {
                file_.notes.push_back("left out: field " + fields_[i].name);
                continue;
            }
            // Moving the vector of attributes later does not move the values.
            file_.attributes.push_back(
                {fields_[i].name, fields_[i].valueType(), std::vector<double>(n)});
            columns_[i] = {file_.attributes.back().values.data(), 1};
        }
    }

    static constexpr VectorNames kAxes{"x", "y", "z"};
    static constexpr VectorNames kNormals{"normal_x", "normal_y", "normal_z"};
    static constexpr VectorNames kShortNormals{"nx", "ny", "nz"};

    /// Sends three fields to the components of `vectors`, if there are all of them.
    void takeVectors(const VectorNames& names, std::vector<Vec3>& vectors, ScalarType& type) {
        const auto isThere = [this](const char* name) { return find(name) != nullptr; };
        if (!std::all_of(names.begin(), names.end(), isThere)) return;
        const auto isFloat = [this](const char* name) {
            return *find(name)->type() == ScalarType::Float;
        };
        type = std::all_of(names.begin(), names.end(), isFloat) ? ScalarType::Float
                                                                : ScalarType::Double;
        vectors.resize(static_cast<std::size_t>(*points_));
        if (vectors.empty()) return;
        double* component = &vectors.front().x;
        for (const char* name : names) {
            columns_[static_cast<std::size_t>(find(name) - fields_.data())] = {component++, 3};
        }
    }

    /// True if a field that is no part of a position or normal is kept.
    static bool isAttribute(const PcdField& field) {
        if (field.count != 1 || !field.type()) return false;
        // Whole numbers of these names are not normals here, but would be in PLY.
        const std::string name = lowerCase(field.name);
        return field.kind == 'F' || !(isAmong(name, kNormals) || isAmong(name, kShortNormals));
    }

    bool readText() {
        for (std::size_t p = 0; p < *points_; ++p) {
            if (!lines_.nextContent('#')) return failCut(p);
            Fields words(lines_.line());
            for (std::size_t i = 0; i < fields_.size(); ++i) {
                for (std::uint64_t c = 0; c < fields_[i].count; ++c) {
                    if (!readWord(words.next(), i, p)) return false;
                }
            }
            if (!words.next().empty()) {
                return fail("the line has more numbers than the header has fields");
            }
        }
        if (lines_.nextContent('#')) {
            return fail("the file goes on after the " + std::to_string(*points_) +
                        " points that its header announces; correct POINTS");
        }
        return true;
    }

    bool readWord(std::string_view word, std::size_t i, std::size_t p) {
        double value = 0.0;
        if (!parseDouble(word, value)) {
            return fail("expected a number for field " + inQuotes(fields_[i].name) + ", found " +
                        inQuotes(word) + "; correct the line");
        }
        const PcdField& field = fields_[i];
        if (columns_[i].first == nullptr) return true;
        if (!rounded_.round(*field.type(), value, field.name)) {
            return fail(std::string(word) + " is no number of the type and size of field " +
                        inQuotes(field.name) + "; correct the line or the header");
        }
        columns_[i].set(p, field.isColor() ? colorBits(field, value) : value);
        return true;
    }

    /// In text a color of type F is the float that has its bits, one of type I their number with a
    /// sign.
    static double colorBits(const PcdField& field, double value) {
        if (std::isnan(value)) return 0.0;
        if (field.kind == 'F') return bitsAs<std::uint32_t>(static_cast<float>(value));
        if (field.kind == 'I') return static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
        return value;
    }

    bool readRows() {
        if (data_ == Data::Text) return readText();
        return data_ == Data::Compressed ? readCompressed() : readBinary();
    }

    /// Loads the numbers of a field that is kept, each `stride` bytes after the one before.
    void load(std::size_t field, const char* first, std::size_t stride) const {
        if (columns_[field].first == nullptr) return;
        columns_[field].load(fields_[field].valueType(), first, stride,
                             static_cast<std::size_t>(*points_), kLittleIsSwapped);
    }

    bool readBinary() {
        const std::string_view rows = lines_.rest();
        const auto n = static_cast<std::size_t>(*points_);
        const std::size_t expected = rowSize_ * n;
        if (rows.size() < expected) return failCut(rows.size() / rowSize_);
        const char* at = rows.data();
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            load(i, at, rowSize_);
            at += fields_[i].bytes();
        }
        // Some writers append a line end or fill up a page with zeros.
        const std::string_view rest = rows.substr(expected);
        if (rest.find_first_not_of(std::string_view("\0\r\n", 3)) == std::string_view::npos) {
            return true;
        }
        return failAt(byteText(whole_ - rest.size()),
                      "the file goes on after the " + std::to_string(n) +
                          " points that its header announces; correct POINTS");
    }

    /// Two sizes, packed and unpacked, then the packed bytes: all numbers of the first field, then
    /// all of the second.
    bool readCompressed() {
        const std::string_view rest = lines_.rest();
        const auto n = static_cast<std::size_t>(*points_);
        if (rest.size() < 8) return failCut(0);
        const auto packed = loadScalar<std::uint32_t>(rest.data(), kLittleIsSwapped);
        const auto unpacked = loadScalar<std::uint32_t>(rest.data() + 4, kLittleIsSwapped);
        if (packed > rest.size() - 8) return failCut(0);
        const std::string bytes = unpackLzf(rest.substr(8, packed), unpacked);
        if (bytes.size() != unpacked || unpacked != rowSize_ * n) {
            return failAt(byteText(whole_ - rest.size() + 8),
                          "the compressed points are damaged, or not the " + std::to_string(n) +
                              " that the header announces");
        }
        const char* at = bytes.data();
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            load(i, at, fields_[i].bytes());
            at += fields_[i].bytes() * n;
        }
        return true;
    }

    /// True if the highest bytes of colors tell them apart: they are all 0 where a writer has none.
    static bool hasTransparent(const std::vector<double>& colors) {
        const auto alpha = [](double color) { return static_cast<std::uint32_t>(color) >> 24U; };
        return std::any_of(colors.begin(), colors.end(),
                           [&](double each) { return alpha(each) != alpha(colors.front()); });
    }

    /// Splits packed colors into the usual columns.
    void splitColors() {
        const auto isPacked = [this](const Attribute& attribute) {
            return attribute.type == ScalarType::UInt32 &&
                   std::any_of(fields_.begin(), fields_.end(), [&](const PcdField& field) {
                       return field.isColor() && field.name == attribute.name;
                   });
        };
        const auto packed =
            std::find_if(file_.attributes.begin(), file_.attributes.end(), isPacked);
        if (packed == file_.attributes.end()) return;
        const std::vector<double> colors = std::move(packed->values);
        const bool hasAlpha = packed->name == "rgba" && hasTransparent(colors);
        if (hasAlpha) file_.notes.emplace_back("left out: transparency of colors");
        file_.attributes.erase(packed);
        addColorColumns(file_, [&](std::size_t p, int channel) {
            return (static_cast<std::uint32_t>(colors[p]) >> (16 - 8 * channel)) & 0xFFU;
        });
    }

    std::size_t whole_;
    std::vector<PcdField> fields_;
    std::vector<Column> columns_;
    std::optional<std::uint64_t> width_, height_, points_;
    std::size_t rowSize_ = 0;
    Data data_ = Data::Text;
    RoundedNumbers rounded_;
    PointFile file_;
};

}  // namespace

bool isPcd(const FileStart& start) { return start.word == "VERSION" || start.word == "FIELDS"; }

Result<PointFile> readPcd(std::string_view bytes, const std::string& name) {
    return PcdReader(bytes, name).read();
}

}  // namespace se::io
