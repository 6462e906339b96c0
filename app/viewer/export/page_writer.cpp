// A page of one file, without the network: each frame is a step with its drawing in the colors of
// both themes, its text and its question. page.css and page.js are a part of it.

#include <fmt/format.h>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "formats.h"
#include "paint/svg_text.h"
#include "run/embedded_files.h"
#include "run/packed_file.h"
#include "spiraling_edge/base/atomic_file.h"
#include "spiraling_edge/base/files.h"
#include "spiraling_edge/base/lists.h"
#include "svg_frame.h"
#include "teach/result.h"

namespace se::view {

namespace {

using teach::TextBlock;
using teach::TextBlockKind;
using teach::TextSpan;

constexpr std::string_view kStepLink = "se:";

struct ImageKind {
    std::string_view extension;
    std::string_view type;
};
constexpr std::array kImageKinds{
    ImageKind{".png", "image/png"},     ImageKind{".jpg", "image/jpeg"},
    ImageKind{".jpeg", "image/jpeg"},   ImageKind{".gif", "image/gif"},
    ImageKind{".svg", "image/svg+xml"},
};

std::string linked(const TextSpan& span, const std::string& text, const PageLinks& links) {
    if (span.link.starts_with(kStepLink)) {
        const std::string address = span.link.substr(kStepLink.size());
        const auto step = links.steps.find(address);
        if (step != links.steps.end())
            return fmt::format("<a href=\"#{}\">{}</a>", step->second, text);
        if (links.toProgram) return linkToOutside(links.toProgram(address), text);
        return fmt::format("<span title=\"{}\">{}</span>", escapedXml(address), text);
    }
    if (!span.link.starts_with("https://") && !span.link.starts_with("http://")) return text;
    return linkToOutside(span.link, text);
}

std::string spansText(const TextBlock& block, const PageLinks& links) {
    std::string all;
    for (const TextSpan& span : block.spans) {
        std::string text = escapedXml(span.text);
        const auto wrap = [&](std::string_view tag) {
            text = fmt::format("<{0}>{1}</{0}>", tag, text);
        };
        if (span.code && block.kind != TextBlockKind::Code) wrap("code");
        if (span.strong) wrap("strong");
        if (span.emphasized) wrap("em");
        all += span.link.empty() ? text : linked(span, text, links);
    }
    return all;
}

std::string plainSpans(const TextBlock& block) {
    std::string text;
    for (const TextSpan& span : block.spans) text += span.text;
    return escapedXml(text);
}

/// An image of the lesson's folder; its description if it cannot be read.
std::string imageText(const TextBlock& block, const PageLinks& links) {
    const std::filesystem::path path = links.folder / block.image;
    const std::string extension = lowerExtension(path);
    const ImageKind* kind =
        rowWhere(kImageKinds, [&](const auto& each) { return each.extension == extension; });
    const Result<std::string> bytes = readBytes(path);
    if (kind == nullptr || !bytes) return "<p>" + plainSpans(block) + "</p>";
    return fmt::format("<img alt=\"{}\" src=\"data:{};base64,{}\">", plainSpans(block), kind->type,
                       base64Of(bytes.value()));
}

std::string_view tagOf(TextBlockKind kind) {
    switch (kind) {
        case TextBlockKind::Heading:
            return "h3";
        case TextBlockKind::Code:
            return "pre";
        case TextBlockKind::Quote:
            return "blockquote";
        case TextBlockKind::Item:
            return "li";
        case TextBlockKind::Paragraph:
        case TextBlockKind::Image:
            break;
    }
    return "p";
}

}  // namespace

std::string linkToOutside(const std::string& address, const std::string& text) {
    return fmt::format("<a href=\"{}\" rel=\"noopener noreferrer\" target=\"_blank\">{}</a>",
                       escapedXml(address), text);
}

std::string pageText(const std::vector<TextBlock>& blocks, const PageLinks& links) {
    std::string text;
    std::string_view list;  // The tag of the open list.
    for (const TextBlock& block : blocks) {
        const bool item = block.kind == TextBlockKind::Item;
        const std::string_view wanted = !item ? "" : block.number > 0 ? "ol" : "ul";
        if (wanted != list) {
            if (!list.empty()) text += fmt::format("</{}>", list);
            if (!wanted.empty()) text += fmt::format("<{}>", wanted);
            list = wanted;
        }
        if (block.kind == TextBlockKind::Image) {
            text += imageText(block, links);
            continue;
        }
        text += fmt::format("<{0}>{1}</{0}>\n", tagOf(block.kind), spansText(block, links));
    }
    if (!list.empty()) text += fmt::format("</{}>", list);
    return text;
}

namespace {

using Json = nlohmann::ordered_json;

/// JSON that may stand in an element of a script: nothing in it ends the element.
std::string scriptJson(const Json& value) {
    std::string text;
    for (const char sign : value.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        text += sign == '<' ? "\\u003c" : std::string(1, sign);
    }
    return text;
}

/// One step of the page.
struct PageStep {
    std::size_t number = 0;  ///< Of the lesson, or of the frame, from 1.
    std::string title;
    std::string caption;
    std::string address;
    std::string drawing;
    std::string after;  ///< Drawing of the answer; empty: none.
    std::string afterCaption;
    std::vector<teach::TextBlock> text;
    std::string question;                                 ///< Form; empty: none.
    std::function<std::string(const std::string&)> link;  ///< As ExportFrame::link.

    /// The address as HTML, a link if there is one.
    std::string addressText() const {
        return link && !address.empty() ? linkToOutside(link(address), escapedXml(address))
                                        : escapedXml(address);
    }
    std::string titleText() const { return title == address ? addressText() : escapedXml(title); }
};

/// The question of a step, for page.js.
Json questionJson(const FrameStep& step) {
    const teach::Question& question = *step.lesson.steps[step.step].question;
    Json names = Json::object();
    for (const PointName& each : step.names) names[each.name] = each.point;
    Json right = Json::object();
    const teach::Answer& answer = step.right->answer;
    if (answer.choice) {
        right["choice"] = teach::optionLetter(*answer.choice);
    } else if (answer.number) {
        right["number"] = *answer.number;
    } else if (question.kind != "play") {
        right["points"] = answer.points;
    }
    return {{"step", step.step + 1},    {"title", step.lesson.steps[step.step].title},
            {"kind", question.kind},    {"names", names},
            {"right", right},           {"within", question.within},
            {"text", step.right->text}, {"reason", step.right->reason}};
}

/// The form of a question.
std::string formOf(const FrameStep& step) {
    const teach::Question& question = *step.lesson.steps[step.step].question;
    std::string fields;
    if (question.kind == "choice") {
        for (std::size_t i = 0; i < question.options.size(); ++i) {
            const std::string letter = teach::optionLetter(i);
            fields += fmt::format(
                "<label><input type=\"radio\" name=\"q{0}\" value=\"{1}\"> {1}: {2}</label>\n",
                step.step + 1, letter, escapedXml(question.options[i]));
        }
    } else if (question.kind == "number") {
        fields = "<label>Number <input class=\"answer\" type=\"number\" step=\"any\"></label>\n";
    } else {
        const bool one = question.kind == "point";
        fields = fmt::format(
            "<label>{}: click in the picture, or type <input class=\"answer\" type=\"text\" "
            "autocomplete=\"off\"></label>\n",
            one ? "One point" : "Points");
    }
    // A pivot is played in the viewer; a page shows its moves.
    const bool plays = question.kind == "play";
    const std::string check = plays ? "" : "<button type=\"submit\">Check</button>";
    return "<form class=\"ask\">\n" + (plays ? "" : fields) + check +
           "<button type=\"button\" class=\"show\">Show the "
           "answer</button>\n<p class=\"says\" role=\"status\" "
           "aria-live=\"polite\"></p>\n</form>\n";
}

class PageWriter : public FrameWriter {
  public:
    explicit PageWriter(const ExportTarget& target)
        : target_(target), classes_(target.theme, true) {}

    Status add(const ExportFrame& frame) override {
        const std::string prefix = fmt::format("s{}{}-", steps_.size() + (frame.answer ? 0U : 1U),
                                               frame.answer ? "a" : "");
        Result<std::string> drawn = svgViews(frame, classes_, prefix);
        if (!drawn) return Error{target_.path.string() + ": " + drawn.error().message};
        const std::string svg = drawing(frame, drawn.value());
        if (frame.answer) {
            steps_.back().after = svg;
            steps_.back().afterCaption = frame.caption;
            return success();
        }
        PageStep step;
        step.number = steps_.size() + 1;
        step.title = frame.title.empty() ? frame.address : frame.title;
        if (step.title.empty()) step.title = "Start";
        step.caption = frame.caption;
        step.address = frame.address;
        step.drawing = svg;
        step.link = frame.link;
        if (frame.step != nullptr) addLesson(*frame.step, step);
        if (!step.address.empty()) links_.steps.emplace(step.address, steps_.size() + 1);
        steps_.push_back(std::move(step));
        return success();
    }

    Status finish() override { return writeFileAtomically(target_.path, page()); }

  private:
    void addLesson(const FrameStep& from, PageStep& step) {
        const teach::Lesson& lesson = from.lesson;
        step.number = from.step + 1;
        if (steps_.empty()) step.text = teach::textBlocks(lesson.text);
        for (teach::TextBlock& each : teach::textBlocks(lesson.steps[from.step].text))
            step.text.push_back(std::move(each));
        hash_ = lesson.hash;
        links_.folder = from.folder;
        if (from.right == nullptr) return;
        step.question = formOf(from);
        questions_.push_back(questionJson(from));
    }

    std::string drawing(const ExportFrame& frame, const std::string& elements) {
        return fmt::format(
            "<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" aria-label=\"{2}\" {3}>"
            "{4}{5}</svg>\n",
            frame.size.x, frame.size.y, escapedXml(frame.caption), kSvgLook,
            svgBackground(frame, classes_), elements);
    }

    /// `address`: HTML.
    std::string captionOf(const std::string& address, const std::string& caption) const {
        if (!target_.captions) return {};
        return fmt::format("<figcaption>{}{}{}</figcaption>\n", address,
                           address.empty() ? "" : ": ", escapedXml(caption));
    }

    std::string sectionOf(const PageStep& step, std::size_t number) {
        links_.toProgram = step.link;
        std::string figures = "<div class=\"before\">" + step.drawing +
                              captionOf(step.addressText(), step.caption) + "</div>\n";
        if (!step.after.empty())
            figures += "<div class=\"after\" hidden>" + step.after +
                       captionOf("", step.afterCaption) + "</div>\n";
        return fmt::format(
            "<section class=\"step\" data-step=\"{0}\" data-title=\"{1}\" aria-label=\"{1}\">\n"
            "<h2>{2}. {3}</h2>\n<figure>{4}</figure>\n<div class=\"text\">{5}{6}</div>\n"
            "</section>\n",
            step.number, escapedXml(step.title), number, step.titleText(), figures,
            pageText(step.text, links_), step.question);
    }

    std::string page() {
        std::string sections;
        for (std::size_t i = 0; i < steps_.size(); ++i) sections += sectionOf(steps_[i], i + 1);
        const Json lesson{{"title", target_.name},
                          {"name", target_.path.stem().string()},
                          {"hash", hash_},
                          {"questions", questions_}};
        const bool dark = target_.theme == Theme::Dark;
        const std::string style = std::string(embeddedFile("page.css")) + classes_.sheet(dark) +
                                  "\n@media screen and (prefers-color-scheme: dark) {" +
                                  classes_.sheet(!dark) + "}\n";
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
               "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
               "<title>" +
               escapedXml(target_.name) + "</title>\n<style>\n" + style +
               "</style>\n</head>\n<body>\n<main>\n<h1>" + escapedXml(target_.name) + "</h1>\n" +
               sections + "</main>\n" + std::string(kBar) +
               "<script type=\"application/json\" id=\"lesson\">" + scriptJson(lesson) +
               "</script>\n<script>\n" + std::string(embeddedFile("page.js")) +
               "</script>\n</body>\n</html>\n";
    }

    static constexpr std::string_view kBar =
        "<nav id=\"steps\" hidden aria-label=\"Steps\">\n"
        "<button id=\"back\">Back</button><button id=\"next\">Next</button>\n"
        "<span id=\"where\" role=\"status\" aria-live=\"polite\"></span>\n"
        "<span class=\"keep\" id=\"keep\" hidden><input id=\"person\" aria-label=\"Name, if you "
        "like\" placeholder=\"Name, if you like\"><button id=\"save\">Save "
        "answers</button></span>\n"
        "</nav>\n";

    ExportTarget target_;
    SvgClasses classes_;
    PageLinks links_;
    std::vector<PageStep> steps_;
    Json questions_ = Json::array();
    std::string hash_;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openPageWriter(const ExportTarget& target) {
    return std::unique_ptr<FrameWriter>(std::make_unique<PageWriter>(target));
}

}  // namespace se::view
