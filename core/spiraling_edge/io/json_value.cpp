// JSON by recursive descent (RFC 8259), with a limit of levels so that no text exhausts the stack.
#include "spiraling_edge/io/json_value.h"

#include <algorithm>
#include <cmath>

#include "spiraling_edge/base/text_scan.h"

namespace se::io {
namespace {

constexpr int kMostLevels = 64;
constexpr std::size_t kMostValues = 2'000'000;  // About 250 MB of memory.

class JsonParser {
  public:
    JsonParser(std::string_view text, const std::string& name, std::size_t begin)
        : text_(text), name_(name), begin_(begin) {}

    Result<JsonValue> parse() {
        JsonValue root;
        if (!readValue(root, 0)) return problem_;
        skipBlanks();
        if (at_ < text_.size() && !fail("the JSON text goes on after its end")) return problem_;
        return root;
    }

  private:
    bool fail(const std::string& what) {
        problem_ = errorAt(name_, "byte " + std::to_string(begin_ + at_), what);
        return false;
    }
    bool failExpected(const char* what) {
        return fail(at_ >= text_.size() ? std::string("the JSON text ends within a value")
                                        : "expected " + std::string(what) + " in the JSON text");
    }
    void skipBlanks() {
        while (at_ < text_.size() && (isSpace(text_[at_]) || text_[at_] == '\n')) ++at_;
    }
    bool take(char c) {
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    bool readValue(JsonValue& value, int level) {
        skipBlanks();
        value.at = begin_ + at_;
        if (level > kMostLevels) return fail("the JSON text has more than 64 levels");
        if (++values_ > kMostValues) return fail("the JSON text has more than 2,000,000 values");
        if (take('{')) return readItems(value, JsonValue::Kind::Object, level);
        if (take('[')) return readItems(value, JsonValue::Kind::List, level);
        if (at_ < text_.size() && text_[at_] == '"') {
            value.kind = JsonValue::Kind::Text;
            return readText(value.text);
        }
        return readWord(value);
    }

    /// The rest of a list, or of an object, whose members have names.
    bool readItems(JsonValue& value, JsonValue::Kind kind, int level) {
        value.kind = kind;
        const bool named = kind == JsonValue::Kind::Object;
        const char end = named ? '}' : ']';
        skipBlanks();
        if (take(end)) return true;
        do {
            skipBlanks();
            if (named && !readText(value.names.emplace_back())) return false;
            // Members are looked up one by one.
            constexpr std::size_t kMostNames = 1000;
            if (value.names.size() > kMostNames)
                return fail("an object of the JSON text has more than 1,000 names");
            skipBlanks();
            if (named && !take(':')) return failExpected("\":\"");
            if (!readValue(value.items.emplace_back(), level + 1)) return false;
            skipBlanks();
        } while (take(','));
        return take(end) || failExpected(named ? "\",\" or \"}\"" : "\",\" or \"]\"");
    }

    bool readText(std::string& text) {
        if (!take('"')) return failExpected("a name in quotation marks");
        constexpr std::string_view kEscapes = "bfnrt";
        constexpr std::string_view kMeanings = "\b\f\n\r\t";
        while (at_ < text_.size() && text_[at_] != '"') {
            char c = text_[at_++];
            if (c == '\\' && at_ < text_.size()) {
                c = text_[at_++];
                const std::size_t known = kEscapes.find(c);
                if (known != std::string_view::npos) c = kMeanings[known];
                if (c == 'u') {
                    at_ = std::min(at_ + 4, text_.size());
                    c = '?';
                }
            }
            text += c;
        }
        return take('"') || failExpected("a quotation mark");
    }

    /// A number, or one of the three words.
    bool readWord(JsonValue& value) {
        const std::size_t end = std::min(text_.find_first_of(" \t\r\n,]}:[{\"", at_), text_.size());
        const std::string_view word = text_.substr(at_, end - at_);
        if (word == "null") {
            value.kind = JsonValue::Kind::Null;
        } else if (word == "true" || word == "false") {
            value.kind = JsonValue::Kind::Boolean;
            value.number = word == "true" ? 1.0 : 0.0;
        } else if (parseDouble(word, value.number) && std::isfinite(value.number)) {
            value.kind = JsonValue::Kind::Number;
        } else {
            return failExpected("a value");
        }
        at_ = end;
        return true;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t begin_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
    Error problem_;
};

const JsonValue kMissingJson{};

}  // namespace

const JsonValue& JsonValue::member(std::string_view name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? kMissingJson
                                : items[static_cast<std::size_t>(found - names.begin())];
}

const JsonValue& JsonValue::item(std::size_t i) const {
    return isList() && i < items.size() ? items[i] : kMissingJson;
}

Result<JsonValue> parseJson(std::string_view text, const std::string& name, std::size_t begin) {
    return JsonParser(text, name, begin).parse();
}

}  // namespace se::io
