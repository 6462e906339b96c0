/// Decompression of gzip and zlib streams by zlib, with the size or a limit known beforehand. A
/// stream expands to at most 1032 times its size, so that memory is bounded by the input.
#include <zlib.h>

#include <algorithm>

#include "spiraling_edge/sampling/gzip.h"

namespace se {
namespace {

/// No byte of a stream unpacks to more than this many (zlib's own documentation).
constexpr std::size_t kMaxPerByte = 1032;
/// Maximum size of the input or output of one call of zlib; its counters have 32 bits.
constexpr std::size_t kPiece = 1U << 30U;

/// Owns the state of zlib.
class Inflater {
  public:
    explicit Inflater(std::string_view packed)
        : packed_(packed), mark_(packed.empty() ? '\0' : packed.front()) {
        constexpr int kGzipOrZlib = 15 + 32;
        good_ = inflateInit2(&stream_, kGzipOrZlib) == Z_OK;
    }
    ~Inflater() {
        if (good_) inflateEnd(&stream_);
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    /// Fills `out` and returns the number of bytes. Fewer than `size` only at the end of the
    /// stream, or with damaged() true.
    std::size_t fill(char* out, std::size_t size) {
        std::size_t filled = 0;
        while (good_ && !damaged_ && filled < size) {
            const std::size_t in = std::min(packed_.size(), kPiece);
            const std::size_t room = std::min(size - filled, kPiece);
            // zlib does not write to its input, though its type is not const.
            stream_.next_in =
                reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data()));  // NOLINT
            stream_.avail_in = static_cast<uInt>(in);
            stream_.next_out = reinterpret_cast<Bytef*>(out + filled);  // NOLINT
            stream_.avail_out = static_cast<uInt>(room);
            const int code = inflate(&stream_, Z_NO_FLUSH);
            packed_.remove_prefix(in - stream_.avail_in);
            const std::size_t made = room - stream_.avail_out;
            filled += made;
            if (code == Z_STREAM_END) {
                // A file may hold several consecutive streams, and zeros after the last.
                ended_ = packed_.find_first_not_of('\0') == std::string_view::npos;
                followed_ = !ended_ && packed_.front() != mark_;
                if (ended_ || followed_ || inflateReset(&stream_) != Z_OK) break;
            } else if (code != Z_OK || (made == 0 && packed_.empty())) {
                damaged_ = code != Z_BUF_ERROR && code != Z_OK;
                break;
            }
        }
        return filled;
    }
    /// True if the last stream has ended, with a correct checksum.
    bool ended() const { return ended_; }
    /// True if it is followed by bytes that are no stream.
    bool followed() const { return followed_; }
    /// Bytes not read yet.
    std::size_t rest() const { return packed_.size(); }
    bool damaged() const { return damaged_ || !good_; }
    const char* reason() const { return stream_.msg != nullptr ? stream_.msg : "not gzip"; }

  private:
    z_stream stream_{};
    std::string_view packed_;
    char mark_;  ///< The first byte of each stream.
    bool good_ = false;
    bool damaged_ = false;
    bool ended_ = false;
    bool followed_ = false;
};

}  // namespace

Result<std::string> inflateExactly(std::string_view packed, std::size_t expected) {
    if (expected / kMaxPerByte > packed.size()) {
        return Error{"the gzip data are too short to hold " + std::to_string(expected) + " bytes"};
    }
    std::string bytes(expected, '\0');
    Inflater inflater(packed);
    const std::size_t filled = inflater.fill(bytes.data(), expected);
    char more = 0;
    const bool tooLong = filled == expected && inflater.fill(&more, 1) > 0;
    if (inflater.damaged())
        return Error{std::string("the gzip data are damaged: ") + inflater.reason()};
    if (filled < expected) {
        return Error{"the gzip data end too early: expected " + std::to_string(expected) +
                     " bytes, found " + std::to_string(filled)};
    }
    if (tooLong)
        return Error{"the gzip data hold more than the expected " + std::to_string(expected) +
                     " bytes; check sizes and type"};
    if (inflater.followed()) return Error{"the gzip data are followed by bytes of another kind"};
    if (!inflater.ended()) return Error{"the gzip data end too early: their check sum is missing"};
    return bytes;
}

Result<std::string> unpackGzip(std::string_view packed, const std::string& name,
                               const ByteLimit& limit) {
    constexpr std::size_t kStep = std::size_t{1} << 20U;
    Inflater inflater(packed);
    std::string bytes;
    std::size_t made = kStep;
    while (made == kStep) {
        const std::size_t had = bytes.size();
        if (had > limit.bytes) return limit.exceededBy(name);
        bytes.resize(had + kStep);
        made = inflater.fill(bytes.data() + had, kStep);
        bytes.resize(had + made);
    }
    if (bytes.size() > limit.bytes) return limit.exceededBy(name);
    if (inflater.damaged())
        return Error{name + ": the gzip data are damaged: " + inflater.reason()};
    if (inflater.followed()) {
        return Error{name + ": byte " + std::to_string(packed.size() - inflater.rest()) +
                     ": the gzip data end here, and " + std::to_string(inflater.rest()) +
                     " bytes of another kind follow; remove them, or unpack the file with gunzip"};
    }
    if (!inflater.ended())
        return Error{name + ": the gzip data end too early; the file is cut short"};
    return bytes;
}

}  // namespace se
