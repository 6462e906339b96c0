"""Mutation operators: the places of a C++ source where one small change can be switched on at run time.

A tokenizer that knows comments, strings, brackets and what a brace encloses is enough, because clang-format
writes binary operators, and only them, between spaces. Constant expressions keep their value.
"""
import re
import zlib
from dataclasses import dataclass

HEADER = r"""#pragma once
#if __cplusplus >= 202002L
#include <cstdio>
#include <cstdlib>
#include <type_traits>
namespace se_mutant {
/// Per mutant: 1 if the compiler met code to change, 2 if a test ran it.
inline char met[1 << 20];
inline const int active = std::getenv("SE_MUTANT") ? std::atoi(std::getenv("SE_MUTANT")) : -1;
struct Report {
    ~Report() {
        std::FILE* file = std::getenv("SE_MET") ? std::fopen(std::getenv("SE_MET"), "wb") : nullptr;
        if (file) std::fwrite(met, 1, sizeof met, file), std::fclose(file);
    }
};
inline Report report;
template <int N>
inline const bool compiled = (met[N] |= 1);
template <int N>
constexpr bool on() {
    if (std::is_constant_evaluated()) return false;
    (void)&compiled<N>;
    met[N] = 2;
    return active == N;
}
template <int N, class T>
constexpr T number(T value) {
    if constexpr (std::is_floating_point_v<T>) return on<N>() ? value == 0 ? T(1) : 2 * value : value;
    else return on<N>() ? T(value + 1) : value;
}
template <int N>
struct At {};
template <int N, class T>
struct Left { T value; };
// a + b is written a + At<N>{} + b: the same precedence, whatever the operands are.
// Computed floating-point numbers are hardly ever equal: their comparisons become the opposite.
#define SE_INFIX(OP, OTHER, OF_FLOATS)                                                            \
    template <int N, class T> constexpr Left<N, T> operator OP(T a, At<N>) { return {a}; }        \
    template <int N, class T, class U> constexpr auto operator OP(Left<N, T> a, U b) {            \
        if constexpr (std::is_floating_point_v<T> || std::is_floating_point_v<U>)                 \
            return on<N>() ? a.value OF_FLOATS b : a.value OP b;                                  \
        else if constexpr (requires { requires std::is_same_v<decltype(a.value OTHER b), decltype(a.value OP b)>; }) \
            return on<N>() ? a.value OTHER b : a.value OP b;                                      \
        else return a.value OP b;                                                                 \
    }
SE_INFIX(<, <=, >=) SE_INFIX(<=, <, >) SE_INFIX(>, >=, <=) SE_INFIX(>=, >, <)
SE_INFIX(+, -, -) SE_INFIX(-, +, +) SE_INFIX(*, /, /) SE_INFIX(/, *, *)
#undef SE_INFIX
}  // namespace se_mutant
#endif
"""
INFIX = {"<", "<=", ">", ">=", "+", "-", "*", "/"}
TOKEN = re.compile(
    r"""[ \t]*\#(?:\\\n|[^\n])*(?<!\\)$ | //[^\n]* | /\*.*?\*/ | R"(\w*)\(.*?\)\1" | "(?:\\.|[^"\\])*" | '(?:\\.|[^'\\])*'
    | [A-Za-z_]\w* | \.?\d(?:[eE][+-]|[\w.'])* | :: | -> | <=> | && | \|\| | [-+*/%&|^=!<>]= | \+\+ | -- | \S""",
    re.S | re.M | re.X)
NUMBER = re.compile(r"(?:\d[\d']*|\d*\.\d+(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)[uUlLf]*")
CONSTANT = re.compile(rf"constexpr [\w:]+ (k[A-Z]\w*) = -?{NUMBER.pattern};")
ENDS_TERM = {"&&", "||", ",", ";", "?", ":", "=", "+=", "|=", "&=", "return", "(", "[", "{", ")", "]", "}"}
FROZEN_TO_SEMICOLON = {"static_assert", "using", "template", "typedef", "requires", "enum"}
FROZEN_ARGUMENTS = {"assert", "noexcept", "decltype", "alignas"}
# Lines and constants that change time or memory alone.
UNSEEN = re.compile(r"\b(reserve|shrink_to_fit|prefetch|sizeof)\b")
UNSEEN_CONSTANT = re.compile(r"k\w*PerThread|kAhead")
NO_STATEMENT = {"return", "throw", "delete", "new", "if", "for", "while", "switch", "else", "do", "case", ";"}
BEFORE_BLOCK = {")", "]", "{", "}", ";", ":", "const", "noexcept", "override", "mutable", "else", "do", "try"}


@dataclass
class Site:
    """The change of the tokens `first` to `last`: texts before and after them, with N for the number."""
    operator: str
    first: int
    last: int
    before: str
    after: str
    path: str = ""
    place: str = ""  # line:column
    key: str = ""  # file, operator, text of the line, and its number among equals: outlives other changes

    def drawn(self, seed):
        """The number of 20 bits that only these decide."""
        return zlib.crc32(f"{seed} {self.key}".encode()) >> 12

    def __str__(self):
        return f"{self.path}:{self.place}\t{self.key.split(': ', 1)[1]}"


class Source:
    """A source as tokens: of each, its span, its partner if it is a bracket, and whether it can be changed."""

    def __init__(self, path, text):
        self.path, self.text = path, text
        found = [m for m in TOKEN.finditer(text) if not re.match(r"[ \t]*#|//|/\*", m[0])]
        self.tokens = [m[0] for m in found]
        self.spans = [m.span() for m in found]
        self.constants = {name for name in CONSTANT.findall(text) if not UNSEEN_CONSTANT.fullmatch(name)}
        self.match_brackets()
        self.freeze()

    def match_brackets(self):
        """Finds partners, the tokens in bodies of functions, and those of them that begin a statement."""
        self.partner, self.in_body, self.begins, stack, start = {}, [], [], [(-1, "namespace")], 0
        for i, token in enumerate(self.tokens):
            inner = next(kind for _, kind in reversed(stack) if kind in {"block", "class", "namespace"})
            self.in_body.append(inner == "block")
            self.begins.append(stack[-1][1] == "block" and self.follows_statement(i, start))
            if token in "([{":
                kind = self.brace_kind(i, start) if token == "{" else token
                stack.append((i, kind))
            elif token in ")]}":
                opening, kind = stack.pop()
                self.partner[opening], self.partner[i] = i, opening
            if token == ";" or (token in "{}" and kind != "value"):
                start = i + 1

    def follows_statement(self, i, start):
        """True if the token begins a statement, where `start` follows a semicolon or the brace of a block."""
        if self.tokens[i - 1] == ")":
            return self.tokens[self.partner[i - 1] - 1] in {"if", "for", "while", "constexpr"}
        return i == start or self.tokens[i - 1] == "else"

    def brace_kind(self, i, start):
        """What the brace opens: a namespace, class, block or value. Its statement begins at `start`."""
        words = set(self.tokens[start:i])
        if "namespace" in words:
            return "namespace"
        if {"class", "struct", "union", "enum"} & words and "(" not in words:
            return "class"
        has_result_type = {"->", ")"} <= words and "return" not in words
        return "block" if self.tokens[i - 1] in BEFORE_BLOCK or has_result_type else "value"

    def freeze(self):
        """Marks the tokens of constant expressions, and of what a release build leaves out."""
        self.frozen = [False] * len(self.tokens)
        for i, token in enumerate(self.tokens):
            end = i
            if token in FROZEN_ARGUMENTS or (token == "constexpr" and self.tokens[i - 1] == "if"):
                end = self.partner.get(i + 1, i)
            elif token in FROZEN_TO_SEMICOLON or (token == "constexpr" and self.in_body[i]):
                end = self.tokens.index(";", i)
            elif token == "case":
                end = self.tokens.index(":", i)
            self.frozen[i:end] = [True] * (end - i)

    def spaced(self, i):
        """True of binary operators."""
        (begin, end), text = self.spans[i], self.text
        return text[begin - 1].isspace() and text[end].isspace()

    def in_template(self, i):
        """True of the first and the last argument of a template."""
        return any(self.tokens[j] in "<>" and not self.spaced(j) for j in (i - 1, i + 1))

    def term(self, i, step):
        """The last token, in the direction of step, of the operand of the operator at i."""
        i += step
        while self.tokens[i] not in ENDS_TERM or (self.tokens[i] in ("([{" if step > 0 else ")]}")):
            i = self.partner.get(i, i) + step
        return i - step

    def statement_end(self, i):
        """The semicolon that ends a call or an assignment which begins at i, or None."""
        if not self.begins[i] or self.tokens[i] in NO_STATEMENT:
            return None
        first = i
        while self.tokens[i] in {"++", "--", "*"}:
            i += 1
        after_name = False
        while i < len(self.tokens):
            token = self.tokens[i]
            if token in "([" and after_name:
                i, after_name = self.partner[i], True
            elif re.match(r"[A-Za-z_]", token) and not after_name:
                after_name = True
            elif token in {".", "->", "::"} and after_name:
                after_name = False
            else:
                break
            i += 1
        changes = self.tokens[first] in {"++", "--"} or self.tokens[i - 1] == ")"
        if (self.tokens[i] == ";" and changes) or re.fullmatch(r"[-+*/%&|^]?=|\+\+|--", self.tokens[i]):
            return self.tokens.index(";", i)
        return None

    def sites_of_operator(self, i):
        """A comparison or sum of its operands changed; a comparison negated; a term of a condition left out."""
        token, left, right = self.tokens[i], self.term(i, -1), self.term(i, 1)
        if token in INFIX and '"' not in self.tokens[i - 1] + self.tokens[i + 1]:
            yield Site(token, i, i, "", f" se_mutant::At<N>{{}} {token}")
        elif token in {"==", "!="}:
            yield Site(token, left, right, "(se_mutant::on<N>() != (", "))")
        elif token in {"&&", "||"}:
            begin = "(se_mutant::on<N>() || (" if token == "&&" else "(!se_mutant::on<N>() && ("
            yield Site(token, i + 1, right, begin, "))")
            if self.tokens[left - 1] not in {"&&", "||"}:
                yield Site(token, left, i - 1, begin, "))")

    def sites_at(self, i):
        """The changes of the operator, condition, constant or statement at i."""
        token, before, end = self.tokens[i], self.tokens[i - 1], self.statement_end(i)
        if self.spaced(i):
            yield from self.sites_of_operator(i)
        if token in {"if", "while"} and i + 1 in self.partner:
            close = self.partner[i + 1]
            if not {";", "="} & set(self.tokens[i + 2:close]):
                yield Site("condition", i + 2, close - 1, "se_mutant::on<N>() != bool(", ")")
        elif token in {"true", "false"}:
            yield Site(token, i, i, "(se_mutant::on<N>() != ", ")")
        elif (NUMBER.fullmatch(token) or token in self.constants) and not self.in_template(i) and before != "::":
            yield Site("constant", i, i, "se_mutant::number<N>(", ")")
        elif token == "continue" or end:
            yield Site("statement", i, end or i, "if (se_mutant::on<N>()) {} else ", "")

    def sites(self):
        """All places of the source that can be changed."""
        seen, lines = {}, self.text.splitlines()
        for i in (i for i in range(1, len(self.tokens)) if self.in_body[i] and not self.frozen[i]):
            at = self.spans[i][0]
            number = self.text.count("\n", 0, at) + 1
            line = " ".join(lines[number - 1].split())
            for site in self.sites_at(i) if not UNSEEN.search(line) else ():
                key = f"{self.path}: {site.operator}: {line}"
                seen[key] = seen.get(key, 0) + 1
                site.key = f"{key} [{seen[key]}]"
                site.path, site.place = self.path, f"{number}:{at - self.text.rfind(chr(10), 0, at)}"
                yield site

    def mutated(self, numbered):
        """The text with the sites of the dictionary {number: site}."""
        inserts = []
        for number, site in numbered.items():
            begin, end = self.spans[site.first][0], self.spans[site.last][1]
            inserts.append((begin, 1, -end, number, site.before))
            inserts.append((end, 0, -begin, -number, site.after))
        text = self.text
        for at, _, _, number, new in sorted(inserts, reverse=True):
            text = text[:at] + new.replace("<N>", f"<{abs(number)}>") + text[at:]
        return text

