#include "packed_file.h"

#include <zlib.h>
#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace se::view {

namespace {

constexpr std::size_t kNameLimit = 200;
/// Deflate without a header and a check sum.
constexpr int kRaw = -15;

Bytef* zlibBytes(const char* bytes) {
    // zlib does not write to its input, though its type is not const.
    return reinterpret_cast<Bytef*>(const_cast<char*>(bytes));  // NOLINT
}

Result<std::string> inflated(std::string_view packed) {
    constexpr std::size_t kPiece = std::size_t{1} << 16U;
    z_stream stream{};
    if (inflateInit2(&stream, kRaw) != Z_OK) return Error{"The packed file cannot be unpacked."};
    stream.next_in = zlibBytes(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string bytes;
    int code = Z_OK;
    while (code == Z_OK && bytes.size() <= kMostUnpacked) {
        const std::size_t had = bytes.size();
        bytes.resize(had + kPiece);
        stream.next_out = zlibBytes(bytes.data() + had);
        stream.avail_out = static_cast<uInt>(kPiece);
        code = inflate(&stream, Z_NO_FLUSH);
        bytes.resize(had + kPiece - stream.avail_out);
    }
    const bool whole = code == Z_STREAM_END && stream.avail_in == 0;
    inflateEnd(&stream);
    if (bytes.size() > kMostUnpacked)
        return Error{"The packed file is larger than 4 MiB, the limit of a link."};
    if (!whole) return Error{"The packed file is damaged: the link was cut or changed."};
    return bytes;
}

}  // namespace

std::string deflated(std::string_view bytes) {
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    stream.next_in = zlibBytes(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = zlibBytes(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string packedSource(const PackedFile& file) {
    std::string name = std::filesystem::path(file.name).filename().string();
    std::replace(name.begin(), name.end(), ':', '-');
    return std::string(kPackPrefix) + name + ":" + base64UrlOf(deflated(file.bytes));
}

Result<PackedFile> unpackedFile(std::string_view source) {
    const std::string name = packedName(source);
    if (!isPacked(source) || name.empty() || name.size() > kNameLimit ||
        name.find_first_of("/\\") != std::string::npos)
        return Error{"A packed file is NAME:BYTES, with the name of a file without its folder."};
    const std::optional<std::string> packed =
        bytesOfBase64Url(source.substr(kPackPrefix.size() + name.size() + 1));
    if (!packed || packed->empty())
        return Error{"The packed file is damaged: the link was cut or changed."};
    Result<std::string> bytes = inflated(*packed);
    if (!bytes) return bytes.error();
    return PackedFile{name, std::move(bytes.value())};
}

std::string packedName(std::string_view source) {
    if (!isPacked(source)) return {};
    source.remove_prefix(kPackPrefix.size());
    const std::size_t colon = source.find(':');
    return colon == std::string_view::npos ? std::string{} : std::string(source.substr(0, colon));
}

namespace {

constexpr std::string_view kSigns =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view kUrlSigns =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

}  // namespace

std::string base64Of(std::string_view bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits <<= 8U;
            if (i + k < bytes.size()) bits |= static_cast<unsigned char>(bytes[i + k]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            const bool there = i + k < bytes.size() + 1;
            text += there ? kSigns[(bits >> (18U - 6U * k)) & 63U] : '=';
        }
    }
    return text;
}

std::string base64UrlOf(std::string_view bytes) {
    std::string text = base64Of(bytes);
    text.erase(std::find(text.begin(), text.end(), '='), text.end());
    std::replace(text.begin(), text.end(), '+', '-');
    std::replace(text.begin(), text.end(), '/', '_');
    return text;
}

std::optional<std::string> bytesOfBase64Url(std::string_view letters) {
    std::string bytes;
    std::uint32_t bits = 0;
    unsigned held = 0;
    for (const char letter : letters) {
        const std::size_t value = kUrlSigns.find(letter);
        if (value == std::string_view::npos) return std::nullopt;
        bits = (bits << 6U) | static_cast<std::uint32_t>(value);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>((bits >> held) & 255U);
    }
    return held < 6 ? std::optional(bytes) : std::nullopt;
}

}  // namespace se::view
