#include "numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "spiraling_edge/base/atomic_file.h"

namespace se::view {

namespace fs = std::filesystem;

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

}  // namespace se::view
