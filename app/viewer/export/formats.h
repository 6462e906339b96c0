/// Formats of an export. A new format is a row of the table and a file with its writer.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "frame.h"
#include "order.h"
#include "scene/palette.h"

namespace se::view {

/// What a writer gets in each frame.
enum class FrameContent : std::uint8_t { Pixels, Shapes, BothThemes };

/// A file to write.
struct ExportTarget {
    std::filesystem::path path;
    std::string name;        ///< Of the input, for titles.
    glm::ivec2 size{1};      ///< Pixels.
    std::size_t frames = 1;  ///< Number of frames that will come.
    bool several = false;    ///< Of a range or a lesson: also a single frame is numbered.
    bool captions = true;
    double perSecond = 2.0;
    Theme theme = Theme::Dark;
    bool cutOut = false;  ///< On no background.
};

/// Takes the frames of an export, one after the other. Nothing replaces the old file before
/// finish(); without it, files of an animation or a page are not written at all.
class FrameWriter {
  public:
    virtual ~FrameWriter() = default;
    /// Fails with a sentence.
    virtual Status add(const ExportFrame& frame) = 0;
    virtual Status finish() = 0;
};

/// One row of the table.
struct ExportFormat {
    std::string_view extension;
    std::string_view title;
    FrameContent content = FrameContent::Pixels;
    bool series = false;       ///< One file holds all frames; otherwise each has a file of its own.
    bool captioned = false;    ///< The caption is a part of the picture.
    bool transparent = false;  ///< The background can be left out.
    /// The reason why this machine cannot write it, and what to install.
    Status (*possible)();
    Result<std::unique_ptr<FrameWriter>> (*open)(const ExportTarget& target);

    /// Its frames follow each other in time.
    bool animated() const { return series && content == FrameContent::Pixels; }
};
std::span<const ExportFormat> exportFormats();
/// By the extension of a path; a folder is one of PNG. Null if there is none.
const ExportFormat* exportFormatOf(const std::filesystem::path& path);
/// ".png, .svg or .gif"
std::string exportExtensions();

/// Whether the path names a folder, to be filled with numbered files.
bool namesFolder(const std::filesystem::path& path);

/// Fails early, before any work: an unknown extension, a missing program, a place that cannot be
/// written, or no background where there must be one.
Status checkExport(const ExportOrder& order, bool cutOut);

}  // namespace se::view
