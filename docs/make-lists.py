#!/usr/bin/env python3
"""Writes the parts of the pages here that the programs themselves print, the options in command-line.md and the keys
in viewer.md, and those that stand in the sources, the evidence in python.md: between lines `<!-- begin NAME -->` and
`<!-- end NAME -->`.

  docs/make-lists.py [--check] [PROGRAM]

PROGRAM is spiraling-edge; the lists of spiraling-edge-viewer need that program in the same folder,
and are left alone without it. --check writes nothing, prints what differs and fails if anything does.
"""
import difflib
import itertools
import pathlib
import re
import subprocess
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
SHARING = ["run", "why", "compare", "reduce"]  # the verbs of the section of shared options
LISTS = {"Classes:": "Classes:", "Terms of a LINE": "Terms of a LINE; all of them must hold:"}
RULES = "Rules ("
NAME_WIDTH = 28  # of the column of names in a help text


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def item(text):
    return textwrap.fill("- " + text, 118, subsequent_indent="  ", break_long_words=False,
                         break_on_hyphens=False)


def described(head):
    """`-k,--neighbors K:INT in [1 - 9] Excludes: --radius` as names, placeholder and notes."""
    notes = []
    head, _, needed = head.partition(" Needs: ")
    head, _, excluded = head.partition(" Excludes: ")
    if not excluded:
        needed, _, excluded = needed.partition(" Excludes: ")
    head = re.sub(r" ?\.\.\.$", "", head)
    if head.endswith(" REQUIRED"):
        head = head[: -len(" REQUIRED")]
        notes.append("required")
    limits = re.search(r":[A-Z]+ in \[(\S+) - (\S+)\]", head)
    if limits:
        notes.append(f"{limits[1]} to {limits[2]}")
        head = head.replace(limits[0], "")
    if ":POSITIVE" in head:
        notes.append("above 0")
    head = re.sub(r":POSITIVE|:\{.*\}", "", head)
    default = re.search(r"^([^ ]+ [A-Z]+)=(\w\S*)$", head)
    if default and default[2] != "VALUE" and "|" not in default[2]:
        notes.append(f"default {default[2]}")
        head = default[1]
    if needed:
        notes.append("with " + ", ".join(needed.split()))
    if excluded:
        notes.append("not with " + ", ".join(excluded.split()))
    names, _, rest = head.partition(" ")
    names = names.replace(",", ", ") + (" " + rest if rest else "")
    return f"`{names}`" + (f" ({'; '.join(notes)})" if notes else "")


def options(help_text):
    """(head, item) of every option; what follows `Options:` and groups of options."""
    found, lines = [], help_text.split("\n")
    for i, line in enumerate(lines):
        if not re.match(r" +--?\w", line):
            continue
        line = line.strip()
        below = lines[i + 1] if i + 1 < len(lines) else ""
        if below.startswith(" " * (NAME_WIDTH + 2)):
            head, text = line, below.strip()
        else:
            head, text = line[:NAME_WIDTH].strip(), line[NAME_WIDTH:].strip()
        if not head.endswith(("--help", "--version")):
            found.append((head, f"{described(head)}: {text}"))
    return found


def footer(help_text, heading):
    """The rows of a list that follows the options, `  name   text`, below a line that begins so."""
    rows = iter(help_text.split("\n"))
    if not any(row.startswith(heading) for row in rows):
        sys.exit(f"no help text has a list that begins with {heading!r}; see docs/make-lists.py")
    return [row.strip() for row in itertools.takewhile(str.strip, rows)]


def rows_of(title, names, rows):
    """A table with a row for each `name   Text.`."""
    cells = [re.match(r"(\S+) {2,}(.*)", row).groups() for row in rows]
    return [title, ""] + table(names, cells)


def table(names, rows):
    bars = [[cell.replace("|", "\\|") for cell in row] for row in rows]
    return [f"| {names[0]} | {names[1]} |", "|---|---|"] + [f"| `{name}` | {text} |" for name, text in bars]


def positionals(help_text):
    block = help_text.partition("Positionals:\n")[2].partition("\n\n")[0]
    rows = (re.match(r" +(\S+) TEXT(?: REQUIRED)? +(.*)", line) for line in block.split("\n"))
    return [f"`{row[1]}`: {row[2]}" for row in rows if row]


def verb_section(verb, help_text, shared):
    intro, usage = help_text.split("\n")[:2]
    page = [f"## {verb}", "", textwrap.fill(f"`{usage.replace('Usage: ', '')}`. {intro}", 118)]
    own = options(help_text)
    lines = positionals(help_text) if verb not in SHARING else []
    common = [option for option in own if option in shared]
    if common:
        which = "" if common == shared else \
            ": " + ", ".join(f"`{head.split()[0]}`" for head, _ in common)
        lines.append(f"the [shared options](#shared-options){which}")
    lines += [text for option, text in own if (option, text) not in shared]
    if len(lines) > 1 and lines[-2].startswith("`--json`") and lines[-1].startswith("`-q"):
        lines[-2:] = [f"{lines[-2]}; {lines[-1]}"]
    page += [item(text) for text in lines]
    for heading, title in LISTS.items():
        if "\n" + heading in help_text:
            page += [""] + rows_of(title, ("name", "meaning"), footer(help_text, heading))
    return page + [""]


def command_line(program):
    verbs = re.findall(r"^  ([a-z]\w*) +[a-z]", output(program, "--help"), re.M)
    verbs = SHARING + [verb for verb in verbs if verb not in SHARING + ["view"]]
    helps = {verb: output(program, verb, "--help") for verb in verbs}
    shared = [option for option in options(helps["run"])
              if all(option in options(helps[verb]) for verb in SHARING)]
    page = ["## Shared options", "",
            "Of `" + "`, `".join(SHARING) + "`: how the input is prepared, and by which rules the run goes."]
    page += [item(text) for text in positionals(helps["run"])] + [item(text) for _, text in shared] + [""]
    for verb in verbs:
        page += verb_section(verb, helps[verb], shared)
    page += ["## Rules", "",
             "For `--rule NAME=VALUE`, by section of the paper; on or off where no other value is named.", ""]
    sections = {}
    for row in footer(helps["run"], RULES):
        name, section, text = row.split(None, 2)
        text = re.sub(r"a (whole )?number from", "", text.removesuffix(": on or off")).replace(":  ", ": ")
        sections.setdefault(section, []).append((name, text))
    for section, rows in sorted(sections.items()):
        page += [f"Section {section}:", ""] + table(("rule", "effect"), rows) + [""]
    return page


def view(program, viewer):
    shared = [re.findall(r"--[a-z-]+", head)[0] for head, _ in options(output(program, "run", "--help"))]
    help_text = output(viewer, "--help")
    own = options(help_text)
    intro = help_text.split("\n")[0]
    page = ["## view", "", textwrap.fill(f"`spiraling-edge view [OPTIONS] [FILE]`. {intro}", 118)]
    page += [item(text) for text in positionals(help_text)]
    page.append(item("the [shared options](#shared-options), but for `--crop`, `--thin`, `--scanner` and `--what-if`"))
    page += [item(text) for head, text in own if re.findall(r"--[a-z-]+", head)[0] not in shared]
    return page


def keys(viewer):
    """The actions that have a key; of those that go to a bookmark the first."""
    page = []
    for line in output(viewer, "--list-actions").rstrip("\n").split("\n"):
        keyless = re.match(r"\S+ {12,}\S", line) and not line[22:40].strip()
        if not keyless and not re.match(r"notes\.go\.([2-9]|10) ", line):
            page += textwrap.wrap(line, 118, subsequent_indent=" " * 40)
    return ["```text"] + page + ["```"]


def snake(name):
    return re.sub(r"(?<=[a-z])([A-Z])", r"_\1", name).lower()


def in_python(comment):
    """A comment of event.h without the names that only C++ has."""
    comment = re.sub(r":? (?:\(|see |in the order of )(?:Readings|RobustRules|PaperRules)::\w+[^).]*\)?", "", comment.replace("kNone", "None"))
    comment = re.sub(r"\b(?:\w+::)?([A-Z][a-z]+[A-Z][a-z]+)\b", lambda name: snake(name[1]).replace("_", " "), comment)
    return comment.strip().rstrip(".,")


def evidence():
    """A row for each struct of evidence in event.h: its members with their comments."""
    text = (HERE / "../core/spiraling_edge/stepper/event.h").read_text()
    rows = []
    for about, name, body in re.findall(r"((?:^///[^\n]*\n)*)^struct (\w+)Evidence \{\n(.*?)^\};", text, re.M | re.S):
        members, above = [], []
        for line in map(str.strip, body.split("\n")):
            member = re.match(r"[\w:]+ ([\w ,=.]+);(?: +///< (.*))?$", line)
            if line.startswith("///<"):
                members[-1][1] += " " + line[4:].strip()
            elif line.startswith("///"):
                above.append(line[3:].strip())
            elif member:
                keys = [snake(each.split("=")[0].strip()) for each in member[1].split(",")]
                members.append([", ".join(f"`{key}`" for key in keys), " ".join(above) or member[2] or ""])
                above = []
            else:
                above = []
        parts = [in_python(" ".join(line[3:].strip() for line in about.splitlines()))]
        parts += [f"{keys}: {in_python(comment)}" for keys, comment in members if comment and keys != "`verdict`"]
        rows.append([snake(name).replace("_", " "), ", ".join(keys for keys, _ in members), "; ".join(filter(None, parts))])
    return ["| decision | keys | meaning |", "|---|---|---|"] + ["| " + " | ".join(row) + " |" for row in rows]


def update(page, name, lines, check):
    """Puts `lines` between the marks, or says what differs. True if nothing does."""
    path = HERE / page
    text = path.read_text()
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->\n"
    if begin not in text or end not in text:
        sys.exit(f"docs/{page}: the marks `{begin.strip()}` and `{end.strip()}` are missing")
    head, rest = text.split(begin)
    old, tail = rest.split(end)
    new = "\n".join(line.rstrip() for line in "\n".join(lines).strip().split("\n")) + "\n"
    if not check:
        path.write_text(head + begin + new + end + tail)
    elif old != new:
        print(f"docs/{page} is not what the programs print; docs/make-lists.py makes it so:")
        print("\n".join(difflib.unified_diff(old.split("\n"), new.split("\n"), "page", "program",
                                              lineterm="", n=0)))
    return old == new


def main():
    arguments = [each for each in sys.argv[1:] if each != "--check"]
    check = "--check" in sys.argv[1:]
    program = pathlib.Path(arguments[0] if arguments else HERE / "../build/bin/spiraling-edge").resolve()
    viewer = program.parent / "spiraling-edge-viewer"
    same = update("command-line.md", "options", command_line(program), check)
    same &= update("python.md", "evidence", evidence(), check)
    if viewer.exists():
        same &= update("command-line.md", "options of view", view(program, viewer), check)
        same &= update("viewer.md", "actions", keys(viewer), check)
    return 1 if check and not same else 0


if __name__ == "__main__":
    sys.exit(main())
