#include "formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "render/context.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/word_list.h"

namespace se::view {

namespace {

namespace fs = std::filesystem;

// The three flags: series, captioned, transparent.
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

/// Pictures of pixels, a file per frame.
class PngWriter : public FrameWriter {
  public:
    explicit PngWriter(const ExportTarget& target) : files_(target) {}

    Status add(const ExportFrame& frame) override {
        return writePicture(files_.next(frame), frame.pixels);
    }
    Status finish() override { return files_.writeCaptions(); }

  private:
    NumberedFiles files_;
};

/// Whether the path names a folder, to be filled with numbered files.
bool namesFolder(const fs::path& path) {
    std::error_code error;
    return path.filename().empty() || fs::is_directory(path, error);
}

}  // namespace

std::span<const ExportFormat> exportFormats() { return kFormats; }

const ExportFormat* exportFormatOf(const fs::path& path) {
    const std::string extension = namesFolder(path) ? ".png" : lowerExtension(path);
    return rowWhere(kFormats,
                    [&](const ExportFormat& each) { return each.extension == extension; });
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

std::vector<fs::path> seriesFilesAt(const fs::path& path) {
    const ExportFormat* format = exportFormatOf(path);
    if (format != nullptr && format->series) return {path};
    const bool folder = namesFolder(path);
    const std::string stem = folder ? "" : path.stem().string() + "-";
    const std::string extension = folder ? ".png" : path.extension().string();
    const auto isOurs = [&](const std::string& name) {
        if (name == stem + "captions.txt") return true;
        if (name.size() <= stem.size() + extension.size() || !name.starts_with(stem) ||
            !name.ends_with(extension))
            return false;
        const auto number = std::string_view(name).substr(
            stem.size(), name.size() - stem.size() - extension.size());
        return number.find_first_not_of("0123456789") == std::string_view::npos;
    };
    const fs::path parent = folder ? path : path.parent_path();
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(parent.empty() ? "." : parent, error)) {
        if (isOurs(entry.path().filename().string())) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

Status NumberedFiles::makeFolder() const {
    std::error_code error;
    if (!namesFolder(target_.path) || fs::is_directory(target_.path, error)) return success();
    if (fs::create_directory(target_.path, error)) return success();
    return Error{"Cannot make the folder " + target_.path.string() + ": " + error.message() + "."};
}

fs::path NumberedFiles::next(const ExportFrame& frame) {
    ++count_;
    if (!target_.several) return target_.path;
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(target_.frames).size());
    const std::string number = fmt::format("{:0{}}", count_, digits);
    fs::path path = target_.path / (number + ".png");
    if (!namesFolder(target_.path)) {
        path = target_.path;
        path.replace_filename(target_.path.stem().string() + "-" + number +
                              target_.path.extension().string());
    }
    captions_ += fmt::format("{}\t{}\t{}{}{}\n", path.filename().string(), frame.address,
                             frame.title, frame.title.empty() ? "" : ": ", frame.caption);
    return path;
}

fs::path NumberedFiles::captionsPath() const {
    if (namesFolder(target_.path)) return target_.path / "captions.txt";
    fs::path path = target_.path;
    return path.replace_filename(target_.path.stem().string() + "-captions.txt");
}

Status NumberedFiles::writeCaptions() const {
    if (!target_.several || !target_.captions) return success();
    return writeFileAtomically(captionsPath(), captions_);
}

Result<std::unique_ptr<FrameWriter>> openPngWriter(const ExportTarget& target) {
    if (const Status made = NumberedFiles(target).makeFolder(); !made) return made.error();
    return std::unique_ptr<FrameWriter>(std::make_unique<PngWriter>(target));
}

}  // namespace se::view
