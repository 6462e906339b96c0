/// Formats of an export. A new format is a row of the table and a file with its writer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "order.h"
#include "paint/painter.h"
#include "rows/pivot_dial.h"
#include "run/model.h"
#include "scene/camera.h"
#include "scene/draw_list.h"
#include "scene/palette.h"
#include "scene/picture.h"
#include "session/compare_with.h"
#include "teach/lesson_runs.h"
#include "teach/lesson_text.h"

namespace se::view {

// One frame of an export: its pixels, its shapes and its words.

/// What is drawn in a frame, for formats of shapes. It refers to what it was made from.
struct FrameShapes {
    const DrawList& list;
    const DrawList* other = nullptr;  ///< The same frame in the other theme; null: not needed.
    const Model& model;
    std::span<const Triangle> triangles;  ///< Finished ones, from the first.
    CameraMatrices camera;
    glm::vec2 size{1.0F};  ///< Pixels.
    float em = 16.0F;      ///< Pixels.
    std::span<const DrawnLabel> labels{};
    glm::vec2 corner{0.0F};  ///< Upper left one of the view in the frame.
    Theme theme = Theme::Dark;
    Rect bar{};                            ///< Of `title`, in the frame.
    const ComparedTitle* title = nullptr;  ///< Of one of two views; null: there is one.
};

/// The dial of the pivot, beside the view.
struct FrameDial {
    Dial dial;
    Rect area;  ///< In the frame.
    std::span<const PointName> names;
};

/// The step of a lesson that a frame shows.
struct FrameStep {
    const teach::Lesson& lesson;
    std::size_t step = 0;  ///< From 0.
    std::vector<PointName> names;
    std::filesystem::path folder;               ///< Of the lesson's images.
    const teach::RightAnswer* right = nullptr;  ///< Of its question; null: none.
};

/// One frame, valid while it is added to a file.
struct ExportFrame {
    std::string address;  ///< Of the decision; empty: the start of the run.
    std::string title;    ///< Of a step of a lesson; else empty.
    std::string caption;  ///< Sentence of the decision.
    Picture pixels;       ///< Empty for formats of shapes.
    /// One view, or two that are compared; empty for formats of pixels.
    std::span<const FrameShapes> shapes{};
    const FrameDial* dial = nullptr;  ///< Null: not in the frame, or formats of pixels.
    glm::vec2 size{1.0F};             ///< Pixels, for formats of shapes.
    bool answer = false;              ///< The answer to the question of the frame before.
    const FrameStep* step = nullptr;  ///< Null: of a run.
    /// The link to the program at an address of the run; null: there are no links.
    std::function<std::string(const std::string& address)> link;
};

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

/// Fails early, before any work: an unknown extension, a missing program, a place that cannot be
/// written, or no background where there must be one.
Status checkExport(const ExportOrder& order, bool cutOut);

// The writers of the table of formats, each in a file of its own.

Result<std::unique_ptr<FrameWriter>> openPngWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openSvgWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openPageWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openGifWriter(const ExportTarget& target);
Result<std::unique_ptr<FrameWriter>> openMp4Writer(const ExportTarget& target);
/// The reason why this machine cannot write them.
Status gifPossible();
Status mp4Possible();

// Names of the files of a range, one per frame, with their captions.

/// Files of frames: the path itself for one frame; of several, `name-001.png` beside it or
/// `001.png` in a folder, and `captions.txt` (`name-captions.txt`).
class NumberedFiles {
  public:
    explicit NumberedFiles(const ExportTarget& target) : target_(target) {}

    /// Makes the folder, if the path names one that is not there. Fails with a sentence.
    Status makeFolder() const;
    /// The path of the next frame, whose words go to the captions.
    std::filesystem::path next(const ExportFrame& frame);
    /// Writes the captions of several frames, if they are wanted.
    Status writeCaptions() const;

  private:
    std::filesystem::path captionsPath() const;

    ExportTarget target_;
    std::size_t count_ = 0;
    std::string captions_;
};

/// The files that an export of several frames to `path` may replace: `path` if one file holds them
/// all, else all existing ones with such numbers, ascending, since the number of frames is not
/// known before the run.
std::vector<std::filesystem::path> seriesFilesAt(const std::filesystem::path& path);

// Text of lessons as HTML, with everything escaped.

/// Where links and images of a text lead.
struct PageLinks {
    std::map<std::string, std::size_t> steps;  ///< Number of the step that shows an address.
    std::filesystem::path folder;              ///< Of the lesson's images.
    /// The link to the program at an address that no step shows; null: there is none.
    std::function<std::string(const std::string& address)> toProgram;
};

/// A link that opens in a window of its own. `text` is HTML.
std::string linkToOutside(const std::string& address, const std::string& text);

/// The blocks as paragraphs, lists, code and images; images are put into the text. Links lead to
/// steps of the page, to the program and to the web, no others.
std::string pageText(const std::vector<teach::TextBlock>& blocks, const PageLinks& links);

// The colors of an animation as GIF, which has at most 256: those of the palette, with what light
// and transparency make of them.

/// Bytes of the colors of a theme, red, green and blue in turn; fewer than 256 colors, so that one
/// is left for pixels that do not change.
std::vector<std::uint8_t> gifPalette(Theme theme);

/// Finds the nearest color of a palette.
class NearestColor {
  public:
    explicit NearestColor(std::span<const std::uint8_t> palette);

    std::uint8_t of(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

  private:
    std::span<const std::uint8_t> palette_;
    std::vector<std::int16_t> known_;  ///< By the upper six bits of each component; -1: not yet.
};

}  // namespace se::view
