#include "formats.h"

#include <algorithm>
#include <array>

#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/word_list.h"
#include "writers.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

// Series, captioned, transparent.
constexpr std::array kFormats{
    ExportFormat{".png", "Picture", FrameContent::Pixels, false, false, true, success,
                 openPngWriter},
    ExportFormat{".svg", "Drawing", FrameContent::Shapes, false, false, true, success,
                 openSvgWriter},
    ExportFormat{".html", "Page", FrameContent::BothThemes, true, false, false, success,
                 openPageWriter},
    ExportFormat{".gif", "Animation", FrameContent::Pixels, true, true, false, gifPossible,
                 openGifWriter},
    ExportFormat{".mp4", "Video", FrameContent::Pixels, true, true, false, mp4Possible,
                 openMp4Writer},
};

}  // namespace

std::span<const ExportFormat> exportFormats() { return kFormats; }

bool namesFolder(const fs::path& path) {
    std::error_code error;
    return path.filename().empty() || fs::is_directory(path, error);
}

const ExportFormat* exportFormatOf(const fs::path& path) {
    const std::string extension = namesFolder(path) ? ".png" : lowerExtension(path);
    const auto found =
        std::find_if(kFormats.begin(), kFormats.end(),
                     [&](const ExportFormat& each) { return each.extension == extension; });
    return found == kFormats.end() ? nullptr : &*found;
}

std::string exportExtensions() {
    std::vector<std::string> all;
    all.reserve(kFormats.size());
    for (const ExportFormat& each : kFormats) all.emplace_back(each.extension);
    return wordList(all, "or");
}

Status checkExport(const ExportOrder& order, bool cutOut) {
    const ExportFormat* format = exportFormatOf(order.path);
    if (format == nullptr)
        return Error{order.path.string() + ": expected a name that ends in " + exportExtensions()};
    if (namesFolder(order.path) && !order.several())
        return Error{order.path.string() + ": a folder is for several frames; name a file"};
    const bool page = format->content == FrameContent::BothThemes;
    if (order.program && !page)
        return Error{order.path.string() +
                     ": the program is a page; expected a name that ends in .html"};
    if (cutOut && !format->transparent)
        return Error{order.path.string() + ": has no transparent background; .png and .svg have"};
    if (const Status possible = format->possible(); !possible)
        return Error{order.path.string() + ": " + possible.error().message};
    if (!namesFolder(order.path)) return AtomicFile::check(order.path);
    const fs::path inside = order.path / "001.png";
    std::error_code error;
    if (fs::is_directory(order.path, error)) return AtomicFile::check(inside);
    return AtomicFile::check(fs::path(order.path).parent_path());
}

}  // namespace se::view
