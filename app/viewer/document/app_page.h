/// The program as one page that has a lesson or a run inside: it opens from a disk, and needs no
/// network.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run/packed_file.h"
#include "start_options.h"

namespace se::view {

/// Content of a page.
struct PageContent {
    Options options;                ///< Options with which the program in the page begins.
    std::string title;              ///< Of the lesson, or the name of the input.
    std::vector<PackedFile> files;  ///< Files that it opens, by their paths there.
};

/// The lesson or the run of an export, with all files that it reads. Fails with a sentence.
Result<PageContent> contentOf(const Options& options);

/// The page of the program, read from kPageName, with content inside. Fails if it is none.
Result<std::string> pageWith(const PageContent& content, std::string page);

/// The file kPageName: in the folder of the program, or in `../share/spiraling-edge/` beside it.
/// Fails with how to get it.
Result<std::filesystem::path> findPage(const std::filesystem::path& programFolder);

}  // namespace se::view
