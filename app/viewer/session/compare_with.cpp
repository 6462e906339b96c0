#include "compare_with.h"

#include <filesystem>

#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/spec/run_spec.h"
#include "teach/trace/setrace.h"

namespace se::view {

std::string runTitle(const RunSpec& spec) {
    RunSpec paper;
    paper.source = spec.source;
    const std::string text = differenceText(paper, spec);
    return spec.rules == paper.rules ? "paper rules" + (text == kNoDifference ? "" : ", " + text)
                                     : text;
}

RunSpec usualOther(RunSpec spec) {
    const char* other = spec.rules == "robust" ? "paper" : "robust";
    return withSet(std::move(spec), other);
}

std::string fileTitle(const CompareWith& with) {
    return std::filesystem::path(with.path).filename().string();
}

bool isTraceFile(std::string_view path) {
    return lowerExtension(std::filesystem::path(path)) == teach::kTraceExtension;
}

Result<CompareWith> compareWithFromText(const std::string& text, const RunSpec& base) {
    if (!text.starts_with('-')) return CompareWith::otherFile(text);
    const Result<SpecChange> change = changeFromWords(io::wordsIn(text));
    if (!change) return Error{change.error().message + "."};
    return CompareWith::otherRun(otherRun(base, change.value()));
}

CompareWith CompareWith::otherFile(std::string path) {
    return isTraceFile(path) ? otherTrace(std::move(path)) : otherMesh(std::move(path));
}

}  // namespace se::view
