/// Choices and progress of the dialog Export. No ImGui.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "export/formats.h"
#include "file_browser_state.h"

namespace se::view {

/// Frames that the dialog offers.
enum class ExportFrames : std::uint8_t {
    Picture,  ///< What the view shows.
    Pivot,    ///< All decisions of the pivot at the cursor.
    Range,    ///< `from` to `to`.
    Lesson,   ///< `steps` of the open lesson.
};

struct ExportForm : ChosenFormat<exportFormats, exportFormatOf> {
    ExportFrames frames = ExportFrames::Picture;
    std::string from;
    std::string to;
    FrameUnit unit = FrameUnit::SubStep;
    std::string steps;  ///< "2,4-6"; empty: all.
    std::string size = "1280x800";
    bool captions = true;
    std::string perSecond = "2";  ///< Frames of an animation.
    std::string path;             ///< The file to write.
    /// The export is to be made, or being made: it ends by itself, or when this is cleared.
    bool working = false;

    // Set by the export.
    std::size_t made = 0;
    std::size_t total = 0;  ///< 0: not known yet.
    std::string complaint;  ///< Reason why nothing was exported; empty: no problem.

    /// Clears the messages of the previous use of the dialog; choices stay.
    void open();
    /// Whether the format has captions with these frames, and frames that follow each other in
    /// time.
    bool hasCaptions() const;
    bool hasSpeed() const;
    /// The order of these choices, for `path`; `address`: of the cursor; `lesson`: the open one, or
    /// null. Fails with a sentence.
    Result<ExportOrder> order(const std::string& address,
                              const std::shared_ptr<const LessonFile>& lesson = nullptr) const;

  private:
    Status addFrames(ExportOrder& order, const std::string& address,
                     const std::shared_ptr<const LessonFile>& lesson) const;
};

}  // namespace se::view
