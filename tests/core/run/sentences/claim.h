/// A sentence taken apart: the points and numbers that it names, held against a Witness.
#pragma once

#include <charconv>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/run/sentences/witness.h"

namespace se::test::sentences {

/// The parts of `text` at the gaps of a form with "{}"; nothing if it has another form.
inline std::optional<std::vector<std::string>> partsOf(std::string_view text,
                                                       std::string_view form) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t gap = form.find("{}");
        const std::string_view literal = form.substr(0, gap);
        if (!text.starts_with(literal)) return std::nullopt;
        text.remove_prefix(literal.size());
        if (gap == std::string_view::npos) break;
        form.remove_prefix(gap + 2);
        const std::string_view after = form.substr(0, form.find("{}"));
        const std::size_t end = after.empty() ? text.size() : text.find(after);
        if (end == std::string_view::npos) return std::nullopt;
        parts.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return text.empty() ? std::optional(parts) : std::nullopt;
}

/// Angles are compared by cosine, with a tolerance that is widest where it is flat.
inline constexpr Real kSlackDegrees = 2e-4L;

class Claim {
  public:
    Claim(const Witness& witness, std::vector<std::string> parts)
        : w(witness), parts_(std::move(parts)) {}

    const Witness& w;
    std::string wrong;               ///< The first claim that does not hold.
    std::optional<Verdict> verdict;  ///< That the words state.

    void need(bool holds, std::string_view claim) {
        if (!holds && wrong.empty()) wrong = claim;
    }
    const std::string& word(std::size_t i) const { return parts_[i]; }
    const std::string& lastWord() const { return parts_.back(); }
    Index count(std::size_t i) const {
        Index value = kNone;
        const std::string& text = parts_[i];
        std::from_chars(text.data(), text.data() + text.size(), value);
        return value;
    }
    /// A point; that of a set, so that it may index one.
    Index point(std::size_t i) {
        const Index x = count(i);
        need(x < w.points.size(), "a point");
        return x < w.points.size() ? x : 0;
    }
    /// The number at the end of a part.
    Real number(std::size_t i) const {
        return std::strtold(parts_[i].c_str() + parts_[i].rfind(' ') + 1, nullptr);
    }
    /// A number with six digits; `scale`: of the lengths that it was made of.
    void same(std::size_t i, Real own, Real scale, std::string_view claim) {
        need(std::abs(number(i) - own) <= 5.1e-6L * std::abs(own) + 1e-9L * scale, claim);
    }
    /// An angle with one digit. Returns it, 0 as 360 where the sentence takes it so.
    Real degrees(std::size_t i, Real own, std::string_view claim) {
        const Real printed = number(i);
        if (printed - own > 180) own += 360;
        if (own - printed > 180) own -= 360;
        need(std::abs(printed - own) <= 0.05L + kSlackDegrees, claim);
        return own;
    }

  private:
    std::vector<std::string> parts_;
};

using C = Claim;  ///< Every check of every form takes one.
inline constexpr auto kNoVerdict = std::nullopt;

/// The sentences of one form, and the check of what they claim.
struct SentenceForm {
    Stage stage;
    std::optional<Verdict> verdict;  ///< Nothing: none, or that of the words in a gap.
    std::string_view form;
    void (*check)(Claim&);
};
/// Those of a pivot up to its triangles; of triangles and rings; after the last pivot.
std::span<const SentenceForm> pivotForms();
std::span<const SentenceForm> ringForms();
std::span<const SentenceForm> repairForms();

/// "1 triangle", "12 pivots".
inline bool counts(const Claim& c, std::size_t i, std::size_t count, std::string_view noun) {
    return c.word(i) == std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace se::test::sentences
