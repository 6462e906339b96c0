#include "link.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "jobs/open_lesson.h"
#include "run/packed_file.h"
#include "run/sample_spec.h"
#include "run/strings.h"
#include "spiraling_edge/base/lists.h"
#include "spiraling_edge/base/number_text.h"
#include "spiraling_edge/base/outside_text.h"
#include "spiraling_edge/base/text_scan.h"
#include "spiraling_edge/base/word_list.h"
#include "spiraling_edge/scenes/scenes.h"
#include "spiraling_edge/spec/spec_fields.h"
#include "teach/embedded_lessons.h"
#include "teach/practice.h"

namespace se::view {

namespace {

using Text = std::optional<std::string>;

Text textIf(bool set, std::string_view text) {
    return set ? Text(std::string(text)) : std::nullopt;
}

Error expected(std::string_view what) { return Error{"expected " + std::string(what)}; }

// ---- percent coding ----

bool isPlainInLink(char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return letter || std::string_view("-._~,:/@=+*").find(c) != std::string_view::npos;
}

/// As few signs as %XX as addresses need.
void appendCoded(std::string& link, std::string_view text) {
    for (const char c : text) {
        if (isPlainInLink(c)) {
            link += c;
        } else {
            link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
}

Result<std::string> decoded(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            plain += text[i];
            continue;
        }
        const std::string_view digits = text.substr(i + 1, 2);
        unsigned byte = 0;
        const auto [end, problem] =
            std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
        if (problem != std::errc{} || end != digits.data() + 2)
            return Error{inQuotes(text.substr(i, 3)) +
                         " in the link is no byte: two hexadecimal digits follow a %."};
        if (byte < 32 || byte == 127)
            return Error{inQuotes(text.substr(i, 3)) + " in the link is a control character."};
        plain += static_cast<char>(byte);
        i += 2;
    }
    return plain;
}

// ---- input ----

template <typename Known>
Error notThere(std::string_view what, std::string_view id, const Known& known) {
    std::vector<std::string_view> ids;
    for (const auto& each : known) ids.push_back(each.id);
    return Error{"there is no " + std::string(what) + " of that name: did you mean " +
                 std::string(nearestWord(ids, id)) + "?"};
}

Status setScene(Options& o, std::string_view id) {
    if (findScene(id) == nullptr) return notThere("scene", id, scenes());
    o.input.source = sceneSource(id);
    return success();
}

Status setLesson(Options& o, std::string_view id) {
    if (teach::practiceSeed(id)) {
        o.lesson = id;
        return success();
    }
    if (teach::findEmbeddedLesson(id) == nullptr)
        return notThere("lesson", id, teach::embeddedLessons());
    o.lesson = embeddedLessonSource(id);
    return success();
}

Text lessonText(const Options& o) {
    if (teach::practiceSeed(o.lesson)) return o.lesson;
    const bool embedded = o.lesson.starts_with(kLessonPrefix);
    return textIf(embedded, embedded ? o.lesson.substr(kLessonPrefix.size()) : "");
}

Status setSample(Options& o, std::string_view line) {
    o.input.source = std::string(kSamplePrefix).append(line);
    const Result<SampleSpec> spec = sampleFromSource(o.input.source);
    return spec ? success() : Status(spec.error());
}

Text sampleText(const Options& o) {
    if (!isSample(o.input.source)) return std::nullopt;
    return o.input.source.substr(kSamplePrefix.size());
}

/// A packed session is read now; points and lessons are when they are opened.
Status setPack(Options& o, std::string_view line) {
    const std::string source = std::string(kPackPrefix).append(line);
    const Result<PackedFile> file = unpackedFile(source);
    if (!file) return file.error();
    const auto& [name, bytes] = file.value();
    if (isLesson(source)) {
        o.lesson = source;
        return success();
    }
    if (!name.ends_with(kSessionExtension) && !bytes.starts_with('{')) {
        o.input.source = source;
        return success();
    }
    Result<SessionFile> session = sessionFromJson(bytes, name, {});
    if (!session) return session.error();
    o.session = std::move(session.value());
    return success();
}

Text packText(const Options& o) {
    const std::string& source = o.lesson.empty() ? o.input.source : o.lesson;
    return isPacked(source) ? Text(source.substr(kPackPrefix.size())) : std::nullopt;
}

Status setFile(Options& o, std::string_view path) {
    if (path.empty()) return expected("a path or an address");
    if (isLesson(path)) {
        o.lesson = path;
    } else {
        o.input.source = path;
    }
    return success();
}

Text fileText(const Options& o) {
    const std::string& source = o.lesson.empty() ? o.input.source : o.lesson;
    const bool file = isFilePath(source) && (!isLesson(source) || isLessonFile(source));
    return textIf(file, source);
}

Status setLessonStep(Options& o, std::string_view text) {
    const auto step = numberIn<std::size_t>(text);
    if (!step || *step == 0) return expected("a whole number from 1 on");
    o.lessonStep = *step - 1;
    return success();
}

// ---- place ----

Status setGoTo(Options& o, std::string_view text) {
    if (text.empty()) return expected("an address such as 137.sphere.3");
    o.atDifference = text == "difference";
    o.goTo = o.atDifference ? "" : text;
    return success();
}

Text goToText(const Options& o) {
    if (o.atDifference) return "difference";
    return textIf(!o.goTo.empty(), o.goTo);
}

constexpr std::string_view kCameraForm =
    "six numbers separated by commas, X,Y,Z,DISTANCE,YAW,PITCH, then orthographic and an axis if "
    "they are meant";

Status setCamera(Options& o, std::string_view text) {
    CameraPose pose;
    // The words at the end, from the last.
    for (std::size_t comma = text.rfind(','); comma != std::string_view::npos;
         comma = text.rfind(',')) {
        const std::string_view word = text.substr(comma + 1);
        if (const auto up = upAxisFromName(word)) {
            pose.up = *up;
        } else if (word == "orthographic") {
            pose.orthographic = true;
        } else {
            break;
        }
        text = text.substr(0, comma);
    }
    const auto numbers = numbersIn(text, 6);
    if (!numbers) return expected(kCameraForm);
    std::array<float, 6> n{};
    for (std::size_t i = 0; i < n.size(); ++i) {
        if (std::abs((*numbers)[i]) > 1e6) return expected("numbers up to a million");
        n[i] = static_cast<float>((*numbers)[i]);
    }
    if (!(n[3] > 0.0F)) return expected("a distance above 0");
    pose.target = {n[0], n[1], n[2]};
    pose.distance = n[3];
    pose.yawDegrees = n[4];
    pose.pitchDegrees = n[5];
    o.camera = pose;
    return success();
}

Text cameraText(const Options& o) {
    if (!o.camera) return std::nullopt;
    const CameraPose& c = *o.camera;
    std::string text;
    for (const float each :
         {c.target.x, c.target.y, c.target.z, c.distance, c.yawDegrees, c.pitchDegrees})
        text.append(text.empty() ? "" : ",")
            .append(formatted("%.4g", each == 0.0F ? 0.0 : static_cast<double>(each)));
    if (c.orthographic) text += ",orthographic";
    if (c.up != UpAxis::Z) text.append(",").append(upAxisName(c.up));
    return text;
}

/// As on the command line: what it stands for is found when the input is known.
Status setWith(Options& o, std::string_view text) {
    if (text.empty()) return expected("options of a run, or a file");
    o.withText = text;
    return success();
}

/// Of the end of the run, as reports of runs have it.
Status setHash(Options& o, std::string_view text) {
    std::uint64_t hash = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
    if (error != std::errc{} || end != text.data() + text.size() || text.size() != 16)
        return expected("16 hexadecimal digits");
    o.stateHash = hash;
    return success();
}

Text hashText(const Options& o) {
    return o.stateHash ? Text(fmt::format("{:016x}", *o.stateHash)) : std::nullopt;
}

// ---- looks ----

Status setLayout(Options& o, std::string_view name) {
    o.layout = layoutPresetFromName(name);
    o.lessons = opensLessons(name);
    return o.layout ? success() : Status(expected("debug, learn, present or compare"));
}

Text layoutText(const Options& o) {
    if (o.lessons) return "learn";
    return o.layout ? Text(std::string(rowOf(*o.layout).name)) : std::nullopt;
}

Status setTheme(Options& o, std::string_view name) {
    o.theme = themeFromName(std::string(name));
    return o.theme ? success() : Status(expected("dark or light"));
}

Status setMeshStyle(Options& o, std::string_view name) {
    o.meshStyle = meshStyleFromName(std::string(name));
    return o.meshStyle ? success()
                       : Status(expected("faults, flat, shaded, wire, birth or component"));
}

Status setPointTint(Options& o, std::string_view name) {
    o.pointTint = pointTintFromName(std::string(name));
    return o.pointTint ? success() : Status(expected("status or margin"));
}

Status setPlay(Options& o, std::string_view text) {
    const auto seconds = numberIn<double>(text);
    if (!seconds || !(*seconds >= 1.0 && *seconds <= 3600.0))
        return expected("a number from 1 to 3600");
    o.playSeconds = *seconds;
    return success();
}

Text playText(const Options& o) {
    if (o.playSeconds <= 0.0) return std::nullopt;
    return plainNumber(o.playSeconds);
}

Status setFocus(Options& o, std::string_view text) {
    o.focus = true;
    return text.empty() ? success() : Status(expected("no value"));
}

using Kind = LinkPart::Kind;

// name, value
// help
// kind; set, text
const std::array kLinkParts{
    LinkPart{"scene", "ID", "Open this scene.", Kind::Input, setScene,
             [](const Options& o) {
                 const bool scene = o.lesson.empty() && isScene(o.input.source);
                 return textIf(scene, scene ? o.input.source.substr(kScenePrefix.size()) : "");
             }},
    LinkPart{"lesson", "ID", "Open this lesson, or practice:SEED, a pivot to play.", Kind::Input,
             setLesson, lessonText},
    LinkPart{"sample", "SHAPE,n=N", "Sample these points, as sample: does in Ctrl+O.", Kind::Input,
             setSample, sampleText},
    LinkPart{"pack", "NAME:BYTES", "Open a small file that the link contains.", Kind::Input,
             setPack, packText},
    LinkPart{"file", "PATH", "Open this file, which the link does not contain.", Kind::Input,
             setFile, fileText},
    LinkPart{"step", "N", "Begin with this step of the lesson, from 1.", Kind::Option,
             setLessonStep,
             [](const Options& o) {
                 return o.lessonStep ? Text(std::to_string(*o.lessonStep + 1)) : std::nullopt;
             }},
    LinkPart{"goto", "ADDRESS",
             "Start with a decision framed: PIVOT[.STAGE[.N]], for example 137.sphere.3, 50%, or "
             "p812, the first event about point 812; or, beside another run, difference.",
             Kind::Option, setGoTo, goToText},
    LinkPart{"alert", "CLASS[:N]",
             "Open on an alert: CLASS or CLASS:N as spiraling-edge why --failures lists them, or "
             "first; with an address, at that place of the run.",
             Kind::Option,
             [](Options& o, std::string_view text) {
                 o.alert = text;
                 return text.empty() ? Status(expected("a class of alerts")) : success();
             },
             [](const Options& o) { return textIf(!o.alert.empty(), o.alert); }},
    LinkPart{"camera", "X,Y,Z,DISTANCE,YAW,PITCH",
             "See it from there; orthographic and the axis that is up may follow.", Kind::Link,
             setCamera, cameraText},
    LinkPart{"with", "WHAT",
             "Compare with a run by the options that differ, as one word (\"--rules robust\"), or "
             "with a file: a mesh, or a trace (.setrace).",
             Kind::Option, setWith,
             [](const Options& o) { return textIf(!o.withText.empty(), o.withText); }},
    LinkPart{"hash", "HEX",
             "State hash of the end of the run; if it ends differently here, the program says so.",
             Kind::Link, setHash, hashText},
    LinkPart{"layout", "NAME",
             "Layout of the window: debug, present or compare; learn: the panel Lesson.",
             Kind::Option, setLayout, layoutText},
    LinkPart{"theme", "NAME", "Theme: dark or light.", Kind::Option, setTheme,
             [](const Options& o) {
                 return textIf(o.theme.has_value(), o.theme == Theme::Dark ? "dark" : "light");
             }},
    LinkPart{"mesh-style", "NAME",
             "Style of finished triangles: faults, flat, shaded, wire, birth or component.",
             Kind::Option, setMeshStyle,
             [](const Options& o) {
                 return o.meshStyle ? Text(std::string(rowOf(*o.meshStyle).name)) : std::nullopt;
             }},
    LinkPart{"point-tint", "NAME",
             "Color of points: status, or margin (the least of all tests of a point).",
             Kind::Option, setPointTint,
             [](const Options& o) {
                 return o.pointTint ? Text(std::string(rowOf(*o.pointTint).name)) : std::nullopt;
             }},
    LinkPart{"play", "SECONDS",
             "Play the run once, in about that time, from 1 to 3600; any key pauses.", Kind::Option,
             setPlay, playText},
    LinkPart{"focus", "", "Start with the pivot and its neighbors framed.", Kind::Option, setFocus,
             [](const Options& o) { return textIf(o.focus, ""); }},
};

Error unknownPart(std::string_view name) {
    std::vector<std::string_view> known;
    known.reserve(kLinkParts.size() + specFields().size());
    for (const LinkPart& each : kLinkParts) known.push_back(each.name);
    for (const SpecField& each : specFields()) {
        if (!each.key.empty()) known.push_back(each.key);
    }
    return Error{inQuotes(name) + " is no part of a link: did you mean " +
                 std::string(nearestWord(known, name)) + "?"};
}

/// What was read of a link so far.
struct LinkReading {
    Options options;
    std::vector<std::string_view> single;  ///< Names that may not come again.
    std::string input;                     ///< The name of its input.
};

/// Fails if a name that may stand once stands again.
Status takeOnce(LinkReading& reading, std::string_view name) {
    if (isAmong(name, reading.single)) return Error{inQuotes(name) + " stands twice in the link."};
    reading.single.push_back(name);
    return success();
}

Status readPart(LinkReading& reading, const LinkPart& part, std::string_view value) {
    if (const Status once = takeOnce(reading, part.name); !once) return once;
    if (part.kind == Kind::Input && !reading.input.empty())
        return Error{"A link has one input, not both " + reading.input + " and " +
                     std::string(part.name) + "."};
    if (part.kind == Kind::Input) reading.input = part.name;
    const Status set = part.set(reading.options, value);
    if (set) return set;
    return Error{"In the link, " + std::string(part.name) + "=" + excerpt(value) + ": " +
                 set.error().message};
}

Status readField(LinkReading& reading, const SpecField& field, std::string_view value) {
    if (!field.repeats) {
        if (const Status once = takeOnce(reading, field.key); !once) return once;
    }
    for (const FieldValue& each : reading.options.given) {
        if (!field.excludes.empty() && each.field->excludes == field.excludes)
            return Error{"A link has only one of " + std::string(each.field->key) + " and " +
                         std::string(field.key) + "."};
    }
    RunSpec tried = reading.options.input;
    if (const Status set = setField(field, tried, value); !set)
        return Error{"In the link, " + std::string(field.key) + "=" + excerpt(value) + ": " +
                     set.error().message};
    reading.options.given.push_back({&field, std::string(value)});
    return success();
}

/// Of several fields of a key the one that stands for the text.
const SpecField* fieldFor(std::string_view key, std::string_view text) {
    for (const SpecField& each : specFields()) {
        if (!key.empty() && each.key == key && each.flag == text) return &each;
    }
    return findSpecField(key);
}

/// Reads "name=value".
Status readPair(LinkReading& reading, std::string_view pair) {
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const Result<std::string> name = decoded(pair.substr(0, equals));
    if (!name) return name.error();
    const Result<std::string> value =
        decoded(equals < pair.size() ? pair.substr(equals + 1) : std::string_view{});
    if (!value) return value.error();
    if (const LinkPart* part = findNamed(kLinkParts, name.value()))
        return readPart(reading, *part, value.value());
    if (const SpecField* field = fieldFor(name.value(), value.value()))
        return readField(reading, *field, value.value());
    return unknownPart(name.value());
}

/// Applies the fields to the input, or to that of the packed session, in the order of their table.
Status applyFields(Options& o) {
    std::stable_sort(o.given.begin(), o.given.end(), [](const auto& a, const auto& b) {
        return a.field < b.field;  // Both of one array.
    });
    if (const Status set = applyChange(o.given, o.input); !set) return set;
    if (!o.session) return success();
    o.input = otherRun(o.session->input, o.given);
    if (!o.goTo.empty()) o.session->place.address = o.goTo;
    if (o.camera) o.session->place.camera = o.camera;
    return success();
}

/// Fails if parts do not fit each other.
Status requireFit(const LinkReading& reading) {
    const Options& o = reading.options;
    if (o.lessonStep && o.lesson.empty()) return Error{"In the link, step needs a lesson."};
    if (!o.given.empty() && !o.lesson.empty())
        return Error{"In the link, " + std::string(o.given.front().field->key) +
                     " does not go with a lesson, which has its own options."};
    if (!o.given.empty() && reading.input.empty())
        return Error{"In the link, " + std::string(o.given.front().field->key) +
                     " needs an input, such as scene=torus."};
    return success();
}

}  // namespace

std::span<const LinkPart> linkParts() { return kLinkParts; }

bool isLink(std::string_view given) {
    const std::string text = trimmed(given, kBlanks);
    const std::size_t hash = text.find('#');
    if (hash == std::string_view::npos) return false;
    const std::string_view parts = std::string_view(text).substr(hash + 1);
    const std::string_view name = parts.substr(0, parts.find_first_of("=&"));
    return hash == 0 || findNamed(kLinkParts, name) != nullptr || findSpecField(name) != nullptr;
}

Result<Options> optionsFromLink(std::string_view given) {
    const std::string whole = trimmed(given, kBlanks);
    std::string_view text = whole;
    if (const std::size_t hash = text.find('#'); hash != std::string_view::npos)
        text.remove_prefix(hash + 1);
    LinkReading reading;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('&'), text.size());
        if (end > 0) {
            if (const Status read = readPair(reading, text.substr(0, end)); !read)
                return read.error();
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (const Status fit = requireFit(reading); !fit) return fit.error();
    if (const Status applied = applyFields(reading.options); !applied) return applied.error();
    return std::move(reading.options);
}

std::string linkText(const Options& options) {
    std::string link;
    const auto addName = [&link](std::string_view name) {
        link.append(link.empty() ? "" : "&").append(name);
    };
    const auto addValue = [&link](std::string_view value) {
        link += '=';
        appendCoded(link, value);
    };
    const auto addPart = [&](const LinkPart& part) {
        const Text text = part.text(options);
        if (!text) return;
        addName(part.name);
        if (!part.value.empty()) addValue(*text);
    };
    for (const LinkPart& each : kLinkParts) {
        if (each.kind == Kind::Input) addPart(each);
    }
    for (const auto& [field, text] : valuesOf(options.input)) {
        if (field->key.empty()) continue;
        addName(field->key);
        addValue(text);
    }
    for (const LinkPart& each : kLinkParts) {
        if (each.kind != Kind::Input) addPart(each);
    }
    return link;
}

std::string_view webAddress() { return SE_WEB_ADDRESS; }

std::string_view linkBase() { return webAddress().empty() ? kPageName : webAddress(); }

}  // namespace se::view
