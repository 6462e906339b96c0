// Blocks of CommonMark are found by cmark, with their lines; the text of a step is the source
// between them, so that it stays Markdown.
#include "lesson_read.h"

#include <algorithm>
#include <optional>

#include "file_bytes.h"
#include "lesson_keys.h"
#include "markdown_tree.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/text_scan.h"

namespace se::teach {
namespace {

/// The folder of a lesson; nothing for one that is not a file.
using Folder = std::optional<std::filesystem::path>;

std::string plainText(cmark_node* heading) {
    std::string text;
    visitNodes(heading, [&](cmark_node* node, cmark_event_type) { text += literalOf(node); });
    return text;
}

constexpr std::string_view kOutside = " is not in the folder of the lesson";

/// Why a lesson in `folder` may not name a path: a relative one that leads out of the folder, an
/// absolute one, a link out of it, or what isUnfit(). Empty if it may.
std::string_view refusalOf(std::string_view path, const Folder& folder) {
    const std::filesystem::path plain = std::filesystem::path(path).lexically_normal();
    if (plain.is_absolute() || (!plain.empty() && *plain.begin() == "..")) return kOutside;
    if (!folder || !isUnfitIn(*folder, *folder / plain)) return {};
    return isUnfit(*folder / plain) ? " is not a regular file in the folder of the lesson"
                                    : kOutside;
}

class LessonReader {
  public:
    LessonReader(std::string_view text, const std::string& name, Folder folder)
        : folder_(std::move(folder)) {
        lesson_.name = name;
        lesson_.hash = hashOfText(text);
        for (io::LineReader lines(text); lines.next();) {
            std::string_view rest = lines.line();
            if (rest.ends_with('\r')) rest.remove_suffix(1);
            // As cmark counts lines, which end at a lone carriage return as well.
            for (std::size_t end; (end = rest.find('\r')) != std::string_view::npos;
                 rest.remove_prefix(end + 1))
                lines_.push_back(rest.substr(0, end));
            lines_.push_back(rest);
        }
    }

    LessonReading read(cmark_node* root) {
        for (cmark_node* node = cmark_node_first_child(root); node != nullptr;
             node = cmark_node_next(node))
            take(node);
        finish();
        return {std::move(lesson_), std::move(faults_)};
    }

  private:
    static std::size_t lineOf(cmark_node* node) {
        return static_cast<std::size_t>(std::max(cmark_node_get_start_line(node), 0));
    }
    void add(std::size_t line, std::string key, std::string message) {
        faults_.push_back({line, std::move(key), std::move(message)});
    }

    void take(cmark_node* node) {
        const cmark_node_type type = cmark_node_get_type(node);
        const int level = type == CMARK_NODE_HEADING ? cmark_node_get_heading_level(node) : 0;
        if (level == 1 && lesson_.title.empty()) {
            lesson_.title = plainText(node);
        } else if (level == 2) {
            lesson_.steps.emplace_back();
            lesson_.steps.back().line = lineOf(node);
            lesson_.steps.back().lines.block = lineOf(node);
            lesson_.steps.back().title = plainText(node);
        } else if (type == CMARK_NODE_CODE_BLOCK && isLessonFence(node)) {
            takeBlock(node);
        } else {
            takeText(node);
        }
    }

    static bool isLessonFence(cmark_node* node) {
        const std::string_view info = cmark_node_get_fence_info(node);
        return info == "se" || info.starts_with("se ");
    }

    void takeBlock(cmark_node* node) {
        const std::string info = cmark_node_get_fence_info(node);
        const LessonBlock block{cmark_node_get_literal(node), lineOf(node)};
        if (!isClosed(node)) {
            add(block.line, "", "the block has no end: close it by a line ```");
            unclosed_ = true;
        } else if (std::string fault = misplacement(info); !fault.empty()) {
            add(block.line, "", std::move(fault));
        } else if (info == "se lesson") {
            readLessonBlock(block, lesson_, faults_);
        } else if (info == "se step") {
            readStepBlock(block, lesson_.steps.back(), faults_);
        } else {
            readAskBlock(block, lesson_.steps.back().question.emplace(), faults_);
        }
    }

    /// True if the last line of a fenced block is its closing fence, not the end of the text.
    bool isClosed(cmark_node* node) const {
        const std::size_t first = std::max<std::size_t>(lineOf(node), 1);
        const auto last = static_cast<std::size_t>(std::max(cmark_node_get_end_line(node), 0));
        if (last <= first || last > lines_.size()) return false;
        const auto opening = io::wordsIn(lines_[first - 1]);
        const auto closing = io::wordsIn(lines_[last - 1]);
        return closing.size() == 1 && closing.front().size() >= 3 &&
               closing.front().find_first_not_of(opening.front().front()) == std::string::npos;
    }

    /// Why a block may not stand here; empty if it may.
    std::string misplacement(const std::string& info) const {
        if (info == "se lesson") {
            if (lesson_.lines.block != 0) return "a second `se lesson`: a file has one";
            return lesson_.steps.empty() ? "" : "`se lesson` stands before the first step";
        }
        if (info != "se step" && info != "se ask")
            return "expected `se lesson`, `se step` or `se ask`";
        if (lesson_.steps.empty())
            return "`" + info + "` before the first step: begin one with `## Title`";
        const LessonStep& step = lesson_.steps.back();
        if (info == "se step" && step.lines.block != step.line)
            return "a second `se step` in this step: begin another with `## Title`";
        if (info == "se ask" && step.question)
            return "a second question in this step: begin another with `## Title`";
        return {};
    }

    void takeText(cmark_node* node) {
        std::string& text = lesson_.steps.empty() ? lesson_.text : lesson_.steps.back().text;
        const std::size_t first = std::max<std::size_t>(lineOf(node), 1);
        const int end = cmark_node_get_end_line(node);
        const std::size_t last =
            std::min(static_cast<std::size_t>(std::max(end, 0)), lines_.size());
        if (!text.empty()) text += '\n';
        for (std::size_t i = first; i <= last; ++i) text.append(lines_[i - 1]) += '\n';
        takeLinks(node, first);
    }

    /// Links to decisions, and images, which must not leave the folder.
    void takeLinks(cmark_node* block, std::size_t line) {
        visitNodes(block, [&](cmark_node* node, cmark_event_type event) {
            if (event != CMARK_EVENT_ENTER) return;
            const cmark_node_type type = cmark_node_get_type(node);
            const std::string_view url = urlOf(node);
            if (type == CMARK_NODE_LINK && url.starts_with("se:") && !lesson_.steps.empty())
                lesson_.steps.back().links.push_back({line, std::string(url.substr(3))});
            if (type != CMARK_NODE_IMAGE) return;
            const bool isAddress = url.find(':') != std::string_view::npos;
            const std::string_view refusal = isAddress ? kOutside : refusalOf(url, folder_);
            if (!refusal.empty()) add(line, "", "the image " + excerpt(url) + std::string(refusal));
        });
    }

    void requireInside(const std::string& input, std::size_t line) {
        if (input.starts_with("scene:") || input.empty()) return;
        const std::string_view refusal = refusalOf(input, folder_);
        if (!refusal.empty())
            add(line, "input", excerpt(input) + std::string(refusal) + ": copy it there");
    }

    void finish() {
        if (lesson_.title.empty()) lesson_.title = lesson_.name;
        if (unclosed_) return;  // All after it stands in the block.
        if (lesson_.lines.block == 0)
            add(0, "", "no block `se lesson`: see docs/lessons.md, or spiraling-edge lesson new");
        if (lesson_.steps.empty()) add(0, "", "no step: begin one with `## Title`");
        if (lesson_.steps.size() > kMaxLessonSteps) {
            add(lesson_.steps[kMaxLessonSteps].line, "", "over 200 steps: write two lessons");
            lesson_.steps.resize(kMaxLessonSteps);
        }
        requireInside(lesson_.input, lesson_.lines.of("input"));
        for (const LessonStep& step : lesson_.steps)
            requireInside(step.input, step.lines.of("input"));
        if (lesson_.lines.block != 0) {
            for (LessonFault& each : syntaxFaults(lesson_)) {
                const bool isKnown =
                    std::any_of(faults_.begin(), faults_.end(), [&](const LessonFault& other) {
                        return other.line == each.line &&
                               (other.key == each.key || other.key.empty());
                    });
                if (!isKnown) faults_.push_back(std::move(each));
            }
        }
        std::stable_sort(
            faults_.begin(), faults_.end(),
            [](const LessonFault& a, const LessonFault& b) { return a.line < b.line; });
    }

    std::vector<std::string_view> lines_;
    Folder folder_;
    Lesson lesson_;
    bool unclosed_ = false;  ///< The last block has no closing fence.
    std::vector<LessonFault> faults_;
};

/// A reading that has one fault alone.
LessonReading refused(const std::string& name, std::size_t line, std::string message) {
    LessonReading reading;
    reading.lesson.name = name;
    reading.faults.push_back({line, "", std::move(message)});
    return reading;
}

LessonReading parsedLesson(std::string_view text, const std::string& name, const Folder& folder) {
    if (text.size() > kLongestLesson)
        return refused(name, 0, "over 1 MB; a lesson is text, its images are files beside it");
    if (const std::size_t line = lineOfBadByte(text); line > 0)
        return refused(name, line, "not UTF-8; save the file as UTF-8");
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const auto lines = std::count(text.begin(), text.begin() + static_cast<long>(zero), '\n');
        return refused(name, static_cast<std::size_t>(lines) + 1, "a zero byte; expected text");
    }
    const MarkdownTree tree = markdownTree(text);
    return LessonReader(text, name, folder).read(tree.get());
}

}  // namespace

LessonReading readLesson(std::string_view text, const std::string& name) {
    return parsedLesson(text, name, std::nullopt);
}

Result<LessonReading> readLessonFile(const std::filesystem::path& path) {
    const Result<std::string> bytes =
        readBytes(path, {kLongestLesson, "a lesson is text, its images are files beside it"});
    if (!bytes) return bytes.error();
    return parsedLesson(bytes.value(), path.string(), path.parent_path());
}

}  // namespace se::teach
