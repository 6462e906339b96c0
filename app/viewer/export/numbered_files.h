/// Names of the files of a range, one per frame, with their captions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "formats.h"

namespace se::view {

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

}  // namespace se::view
