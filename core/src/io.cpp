#include "spiraling_edge/io.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "extension.h"
#include "io_formats.h"
#include "read_bytes.h"
#include "text_scan.h"

namespace se {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReadable =
    "PLY (ascii or binary), XYZ (x y z per line, then normals or colors), OBJ, OFF and PCD can be "
    "read; "
    "convert it to one of these, e.g. with MeshLab or CloudCompare";

/// The reason that the operating system gave for the last failure.
std::string systemReason() { return std::generic_category().message(errno); }

using ReadFunction = Result<PointFile> (*)(std::string_view, const std::string&);

bool isObjKeyword(std::string_view word) {
    constexpr std::array<std::string_view, 14> kKeywords{
        "v", "vn", "vt", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl", "mg", "cstype"};
    return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

/// A line of XYZ that begins with two slashes, as CloudCompare writes it.
bool isSlashComment(std::string_view line) { return io::Fields(line).next().starts_with("//"); }

/// The reader for what `bytes` seem to be; null if they seem to be nothing that can be read.
ReadFunction findReader(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || bytes.starts_with("ply "))
        return io::readPly;
    io::LineReader lines(bytes);
    while (lines.nextContent('#') && isSlashComment(lines.line())) {
    }
    const std::string_view word = io::Fields(lines.line(), ',', ';').next();
    if (word == "VERSION" || word == "FIELDS") return io::readPcd;
    if (io::isOffKeyword(word)) return io::readOff;
    if (isObjKeyword(word)) return io::readObj;
    double number = 0.0;
    if (!io::parseDouble(word, number)) return nullptr;
    // OFF may begin with its counts, which only the extension tells from a point.
    return lowerExtension(name) == ".off" ? io::readOff : io::readXyz;
}

/// Writes to an open file and closes it. False with errno set if that fails, as on a full disk.
bool writeAndClose(std::FILE* file, std::string_view bytes) {
    bool good = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    good = std::fflush(file) == 0 && good;
    const int reason = errno;
    good = std::fclose(file) == 0 && good;
    if (!good && reason != 0) errno = reason;
    return good;
}

Status cannotWrite(const fs::path& path) {
    return Error{path.string() + ": cannot be written: " + systemReason()};
}

Status writeDirectly(const fs::path& path, std::string_view bytes) {
    errno = 0;
    std::FILE* file = std::fopen(path.string().c_str(), "wb");
    if (file == nullptr || !writeAndClose(file, bytes)) return cannotWrite(path);
    return success();
}

/// Opens a new file beside `target` under a name that nobody uses, which goes to `path`.
std::FILE* openBeside(const fs::path& target, fs::path& path) {
    constexpr int kMostTries = 100;
    for (int i = 0; i < kMostTries; ++i) {
        path = target;
        path += ".part" + std::to_string(i);
        errno = 0;
        std::FILE* file = std::fopen(path.string().c_str(), "wbx");  // x: fails if it exists
        if (file != nullptr || errno != EEXIST) return file;
    }
    return nullptr;
}

/// An existing file that is write-protected must stay: renaming would not ask.
bool mayReplace(const fs::path& target) {
    errno = 0;
    std::FILE* file = std::fopen(target.string().c_str(), "r+b");
    if (file != nullptr) std::fclose(file);
    return file != nullptr;
}

Status replaceFile(const fs::path& target, bool exists, std::string_view bytes) {
    fs::path temporary;
    std::FILE* file = openBeside(target, temporary);
    if (file == nullptr) return cannotWrite(target);
    std::error_code problem;
    if (!writeAndClose(file, bytes)) {
        problem = {errno, std::generic_category()};
    } else {
        std::error_code ignored;  // other permissions than before are no reason to fail
        if (exists) fs::permissions(temporary, fs::status(target, ignored).permissions(), ignored);
        fs::rename(temporary, target, problem);
    }
    if (!problem) return success();
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return Error{target.string() + ": cannot be written: " + problem.message()};
}

}  // namespace

Result<std::string> readBytes(const fs::path& path) {
    const std::string name = path.string();
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return Error{name + ": there is no such file"};
    if (fs::is_directory(status)) return Error{name + ": is a folder; name a file in it"};
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{name + ": cannot be opened: " + systemReason()};
    std::string bytes;
    if (fs::is_regular_file(status)) {
        const std::uintmax_t size = fs::file_size(path, ignored);
        // One byte more than there should be, so that the end is seen without another round.
        if (!ignored) bytes.resize(static_cast<std::size_t>(size) + 1);
    }
    std::size_t filled = 0;
    while (stream) {
        constexpr std::size_t kLeastRoom = 1U << 16U;
        if (filled == bytes.size()) bytes.resize(std::max(kLeastRoom, 2 * bytes.size()));
        stream.read(bytes.data() + filled, static_cast<std::streamsize>(bytes.size() - filled));
        filled += static_cast<std::size_t>(stream.gcount());
    }
    if (stream.bad()) return Error{name + ": cannot be read: " + systemReason()};
    bytes.resize(filled);
    return bytes;
}

Result<PointFile> readPoints(const fs::path& path) {
    const Result<std::string> bytes = readBytes(path);
    if (!bytes) return bytes.error();
    return readPoints(bytes.value(), path.string());
}

Result<PointFile> readPoints(std::string_view bytes, const std::string& name) {
    if (bytes.empty()) return Error{name + ": is empty"};
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    const ReadFunction reader = findReader(bytes, name);
    if (reader == nullptr) return Error{name + ": is of no known kind. " + kReadable};
    return reader(bytes, name);
}

Status writeFileAtomically(const fs::path& path, std::string_view bytes) {
    std::error_code problem;
    const fs::file_status status = fs::status(path, problem);
    if (fs::is_directory(status)) return Error{path.string() + ": is a folder; name a file in it"};
    const bool exists = fs::exists(status);
    if (exists && !fs::is_regular_file(status)) return writeDirectly(path, bytes);
    const fs::path folder = path.parent_path();
    if (!folder.empty() && !fs::is_directory(folder, problem)) {
        return Error{path.string() + ": cannot be written: there is no folder " + folder.string() +
                     "; make it first"};
    }
    if (!exists) return replaceFile(path, false, bytes);
    if (!mayReplace(path)) return cannotWrite(path);
    const fs::path target = fs::canonical(path, problem);
    return replaceFile(problem ? path : target, true, bytes);
}

}  // namespace se
