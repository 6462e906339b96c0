/// PCD, the format of the Point Cloud Library: a header in text, then rows in text or binary.
#include <algorithm>
#include <optional>
#include <vector>

#include "spiraling_edge/base/float_bits.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/io/ply.h"
#include "spiraling_edge/io/ply_rows.h"
#include "spiraling_edge/io/point_formats.h"

namespace se::io {
namespace {

/// A column, or several of the same name if `count` is more than one.
struct PcdField {
    std::string name;
    std::size_t size = 4;
    char kind = 'F';
    std::uint64_t count = 1;

    /// Nothing for integers of eight bytes, which no double holds exactly.
    std::optional<ScalarType> type() const {
        if (kind == 'F') {
            return size == 4   ? std::optional(ScalarType::Float)
                   : size == 8 ? std::optional(ScalarType::Double)
                               : std::nullopt;
        }
        const bool isSigned = kind == 'I';
        switch (size) {
            case 1:
                return isSigned ? ScalarType::Int8 : ScalarType::UInt8;
            case 2:
                return isSigned ? ScalarType::Int16 : ScalarType::UInt16;
            case 4:
                return isSigned ? ScalarType::Int32 : ScalarType::UInt32;
            default:
                return std::nullopt;
        }
    }
    bool isColor() const { return (name == "rgb" || name == "rgba") && size == 4 && count == 1; }
};

/// The target of the numbers of a field: that of point p is first[p * stride]. None if null.
struct Target {
    double* first = nullptr;
    std::size_t stride = 1;
};

class PcdReader {
  public:
    PcdReader(std::string_view bytes, const std::string& name)
        : lines_(bytes), whole_(bytes.size()), name_(name) {}

    Result<PointFile> read() {
        if (!readHeader() || !checkHeader()) return problem_;
        makeColumns();
        if (!(binary_ ? readBinary() : readText())) return problem_;
        splitColors();
        return std::move(file_);
    }

  private:
    bool fail(const std::string& what) {
        problem_ = errorAt(name_, lineText(lines_.number()), what);
        return false;
    }

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
        if (kind == "ascii" || kind == "binary") {
            binary_ = kind == "binary";
            return true;
        }
        if (kind == "binary_compressed") {
            return fail(
                "compressed PCD cannot be read; save it as binary, e.g. with "
                "pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1");
        }
        return fail("expected ascii or binary after DATA, found " + inQuotes(kind));
    }

    bool readEntry(std::string_view key, Fields& words) {
        if (key == "FIELDS" || key == "COLUMNS") return readNames(words);
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
                std::int64_t number = 0;
                constexpr std::int64_t kMax = 1 << 20;
                if (!parseInteger(word, number) || number < 0 || number > kMax) return false;
                field.count = static_cast<std::uint64_t>(number);
                return true;
            });
        }
        if (key == "WIDTH") return readNumber(key, words, width_);
        if (key == "HEIGHT") return readNumber(key, words, height_);
        if (key == "POINTS") return readNumber(key, words, points_);
        if (key == "VERSION" || key == "VIEWPOINT") return true;
        return fail("expected a line of a PCD header (FIELDS, SIZE, ...), found " + inQuotes(key));
    }

    bool readNames(Fields& words) {
        for (auto word = words.next(); !word.empty(); word = words.next()) {
            fields_.push_back({std::string(word)});
        }
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
        std::int64_t found = 0;
        const std::string_view word = words.next();
        if (!parseInteger(word, found) || found < 0 || found >= std::int64_t{kNone}) {
            return fail("expected a number of points after " + std::string(key) + ", found " +
                        inQuotes(word));
        }
        number = static_cast<std::uint64_t>(found);
        return true;
    }

    const PcdField* find(std::string_view name) const {
        for (const PcdField& field : fields_) {
            if (field.name == name && field.count == 1 && field.kind == 'F' && field.type()) {
                return &field;
            }
        }
        return nullptr;
    }

    bool checkHeader() {
        if (!points_ && width_) points_ = *width_ * height_.value_or(1);
        if (!points_) return fail("the header does not say how many POINTS there are");
        if (width_ && height_ && *width_ * *height_ != *points_) {
            return fail("WIDTH times HEIGHT is " + std::to_string(*width_ * *height_) +
                        ", but POINTS is " + std::to_string(*points_) + "; correct the header");
        }
        for (const char* axis : {"x", "y", "z"}) {
            if (find(axis) == nullptr) {
                return fail(std::string("there is no field ") + axis +
                            " of type F and size 4 or 8; the algorithm needs x, y and z");
            }
        }
        rowSize_ = 0;
        for (const PcdField& field : fields_) rowSize_ += field.size * field.count;
        // Checked before allocation: a row has at least two bytes in text, and its size in binary.
        const std::uint64_t least = binary_ ? rowSize_ : 2;
        if (*points_ > (lines_.rest().size() + 1) / least) return failCut(0);
        return true;
    }

    bool failCut(std::uint64_t found) {
        const std::string place =
            binary_ ? "byte " + std::to_string(whole_) : lineText(lines_.number());
        problem_ = errorAt(name_, place,
                           "the file ends after " + std::to_string(found) + " of " +
                               std::to_string(*points_) +
                               " points; it is cut short, or its header announces too many");
        return false;
    }

    // ---- rows -------------------------------------------------------------------------------

    void makeColumns() {
        const auto n = static_cast<std::size_t>(*points_);
        targets_.assign(fields_.size(), {});
        file_.position.resize(n);
        file_.positionType = *find("x")->type();
        const bool hasNormals = find("normal_x") != nullptr && find("normal_y") != nullptr &&
                                find("normal_z") != nullptr;
        if (hasNormals) {
            file_.normal.resize(n);
            file_.normalType = *find("normal_x")->type();
        }
        std::size_t others = 0;
        for (const PcdField& field : fields_) others += isOther(field) ? 1 : 0;
        file_.attributes.reserve(others);  // Targets point into them.
        for (std::size_t i = 0; i < fields_.size(); ++i) targets_[i] = targetOf(fields_[i]);
    }

    static constexpr const char* kAxes[] = {"x", "y", "z"};
    static constexpr const char* kNormals[] = {"normal_x", "normal_y", "normal_z"};

    bool isOther(const PcdField& field) const {
        if (field.count != 1 || !field.type() || field.name == "_") return false;
        for (const char* own : kAxes) {
            if (&field == find(own)) return false;
        }
        for (const char* own : kNormals) {
            // Whole numbers of this name are not normals here, but would be in PLY.
            if (field.name == own && field.kind != 'F') return false;
            if (!file_.normal.empty() && &field == find(own)) return false;
        }
        return true;
    }

    Target targetOf(const PcdField& field) {
        if (*points_ == 0) return {};
        for (int i = 0; i < 3; ++i) {
            if (&field == find(kAxes[i])) return {&file_.position.front()[i], 3};
            if (file_.hasNormals() && &field == find(kNormals[i])) {
                return {&file_.normal.front()[i], 3};
            }
        }
        if (!isOther(field)) return {};
        const ScalarType type = field.isColor() ? ScalarType::UInt32 : *field.type();
        file_.attributes.push_back(
            {field.name, type, std::vector<double>(static_cast<std::size_t>(*points_))});
        return {file_.attributes.back().values.data(), 1};
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
        if (targets_[i].first == nullptr) return true;
        if (!roundTo(*field.type(), value)) {
            return fail(std::string(word) + " is no number of the type and size of field " +
                        inQuotes(field.name) + "; correct the line or the header");
        }
        targets_[i].first[p * targets_[i].stride] =
            field.isColor() ? colorBits(field, value) : value;
        return true;
    }

    /// In text a color of type F is the float that has its bits, one of type I their number with a
    /// sign.
    static double colorBits(const PcdField& field, double value) {
        if (field.kind == 'F') return bitsAs<std::uint32_t>(static_cast<float>(value));
        if (field.kind == 'I') return static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
        return value;
    }

    bool readBinary() {
        const std::string_view rows = lines_.rest();
        const auto n = static_cast<std::size_t>(*points_);
        const std::size_t expected = rowSize_ * n;
        if (rows.size() < expected) return failCut(rows.size() / rowSize_);
        constexpr bool kSwapped = std::endian::native == std::endian::big;  // Files are little.
        std::size_t at = 0;
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            if (targets_[i].first != nullptr) {
                const ScalarType type =
                    fields_[i].isColor() ? ScalarType::UInt32 : *fields_[i].type();
                withScalar(type, [&](auto zero) {
                    for (std::size_t p = 0; p < n; ++p) {
                        targets_[i].first[p * targets_[i].stride] = static_cast<double>(
                            loadScalar<decltype(zero)>(rows.data() + p * rowSize_ + at, kSwapped));
                    }
                });
            }
            at += fields_[i].size * fields_[i].count;
        }
        // Some writers append a line end or fill up a page with zeros.
        const std::string_view rest = rows.substr(expected);
        if (rest.find_first_not_of(std::string_view("\0\r\n", 3)) == std::string_view::npos) {
            return true;
        }
        problem_ = errorAt(name_, "byte " + std::to_string(whole_ - rest.size()),
                           "the file goes on after the " + std::to_string(n) +
                               " points that its header announces; correct POINTS");
        return false;
    }

    /// Splits packed colors into the usual columns.
    void splitColors() {
        for (std::size_t i = 0; i < file_.attributes.size(); ++i) {
            const Attribute& packed = file_.attributes[i];
            const auto isIt = [&](const PcdField& f) {
                return f.isColor() && f.name == packed.name;
            };
            if (packed.type != ScalarType::UInt32 ||
                std::none_of(fields_.begin(), fields_.end(), isIt)) {
                continue;
            }
            const std::vector<double> colors = std::move(file_.attributes[i].values);
            file_.attributes.erase(file_.attributes.begin() + static_cast<std::ptrdiff_t>(i));
            unsigned shift = 16;
            for (const char* name : {"red", "green", "blue"}) {
                Attribute channel{name, ScalarType::UInt8, {}};
                channel.values.reserve(colors.size());
                for (const double value : colors) {
                    const auto bits = static_cast<std::uint32_t>(value);
                    channel.values.push_back(static_cast<double>((bits >> shift) & 0xFFU));
                }
                file_.attributes.push_back(std::move(channel));
                shift -= 8;
            }
            return;
        }
    }

    LineReader lines_;
    std::size_t whole_;
    const std::string& name_;
    std::vector<PcdField> fields_;
    std::vector<Target> targets_;
    std::optional<std::uint64_t> width_, height_, points_;
    std::size_t rowSize_ = 0;
    bool binary_ = false;
    PointFile file_;
    Error problem_;
};

}  // namespace

bool isPcd(const FileStart& start) { return start.word == "VERSION" || start.word == "FIELDS"; }

Result<PointFile> readPcd(std::string_view bytes, const std::string& name) {
    return PcdReader(bytes, name).read();
}

}  // namespace se::io
