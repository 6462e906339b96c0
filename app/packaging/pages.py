#!/usr/bin/env python3
"""Writes the man pages and completions of a program, from the options that it lists itself.

  pages.py PROGRAM FOLDER

PROGRAM is spiraling-edge or spiraling-edge-viewer: `PROGRAM --help --json` prints its options and,
for each verb, a line with those of the verb. FOLDER gets man1/, and bash/, zsh/ and fish/ with a file
each. Equal programs give equal bytes.
"""
import gzip
import json
import pathlib
import re
import shlex
import subprocess
import sys

HELP = {"names": ["-h", "--help"], "help": "Print this and exit"}


def listed(program):
    """The object of the program, and those of its verbs by name."""
    text = subprocess.run([program, "--help", "--json"], check=True, capture_output=True, text=True).stdout
    first, *verbs = map(json.loads, text.splitlines())
    if not verbs:  # the program itself has options
        return first, {}
    listed_options = {each["name"].removeprefix(first["name"] + " "): each for each in verbs}
    first["options"] = [HELP, {"names": ["--version"], "help": "Print the version and exit"}]
    first["positionals"] = []
    # They are listed above as those of verbs are.
    first["footer"] = "\n\n".join(block for block in first["footer"].split("\n\n") if not block.startswith("  -"))
    pages = {}
    for verb in first["verbs"]:
        of_viewer = {"description": sentence(capitalized(verb["summary"])), "options": [HELP],
                     "positionals": [{"name": "FILE", "help": "As of spiraling-edge-viewer(1)"}],
                     "footer": "All options are those of spiraling-edge-viewer(1)."}
        pages[verb["name"]] = listed_options.get(verb["name"], of_viewer) | {"summary": verb["summary"]}
    return first, pages


def capitalized(text):
    return text[:1].upper() + text[1:]


def sentence(text):
    return text if text.endswith((".", ":")) else text + "."


def placeholder(option):
    """What stands for the value in help: K of `K:INT in [1 - 9]`. Empty for a flag."""
    value = re.sub(r":(\{|[A-Z]+( in |$)).*", "", option.get("value", ""))
    return value or ("VALUE" if "value" in option else "")


def choices(option):
    """The values of an option that takes some words only."""
    value = option.get("value", "")
    braces = re.search(r":\{([^}]*)\}", value)
    if braces:
        return braces[1].split(",")
    return value.split("|") if re.fullmatch(r"[a-z0-9]+(\|[a-z0-9]+)+", value) else []


def limits(option):
    """A sentence about what a value must be, beyond its help."""
    value = option.get("value", "")
    ends = re.search(r":[A-Z]+ in \[(\S+) - (\S+)\]", value)
    said = []
    if ends:
        said.append(f"From {ends[1]} to {ends[2]}.")
    if ":POSITIVE" in value:
        said.append("Above 0.")
    if choices(option) and ":" in value:
        said.append("One of " + ", ".join(choices(option)) + ".")
    if option.get("needs"):
        said.append("With " + ", ".join(option["needs"]) + ".")
    if option.get("excludes"):
        said.append("Not with " + ", ".join(option["excludes"]) + ".")
    if option.get("required"):
        said.append("Required.")
    return " ".join(said)


# Man pages


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.M)


def man_option(option):
    names = ", ".join(f"\\fB{roff(name)}\\fR" for name in option["names"])
    value = placeholder(option)
    head = names + (f" \\fI{roff(value)}\\fR" if value else "")
    return [".TP", head, roff(" ".join(filter(None, [sentence(option["help"]), limits(option)])))]


def man_footer(text):
    """Sections with what follows the options: paragraphs, and lists whose indented lines stay as they are."""
    lines = [".SH NOTES"]
    for block in re.split(r"\n\s*\n", text.strip("\n")):
        if block.startswith("Exit codes: "):
            lines += [".SH EXIT STATUS", roff(block.removeprefix("Exit codes: "))]
            continue
        plain = not re.search(r"^ ", block, re.M)
        lines += [".PP", roff(block)] if plain else [".PP", ".nf", roff(block), ".fi"]
    return lines


def man_page(name, page, version, summary, usage, verbs=(), see=()):
    lines = [f'.TH "{roff(name.upper())}" 1 "" "spiraling\\-edge {roff(version)}" "User Commands"',
             ".SH NAME", f"{roff(name)} \\- {roff(summary)}",
             ".SH SYNOPSIS", *usage,
             ".SH DESCRIPTION", roff(page["description"])]
    if verbs:
        lines.append(".SH VERBS")
        for verb in verbs:
            lines += [".TP", f"\\fB{roff(verb['name'])}\\fR",
                      f"{roff(sentence(capitalized(verb['summary'])))} See \\fB{roff(name + '-' + verb['name'])}\\fR(1)."]
    if page["positionals"]:
        lines.append(".SH ARGUMENTS")
    for each in page["positionals"]:
        lines += [".TP", f"\\fI{roff(each['name'])}\\fR", roff(" ".join(filter(None, [sentence(each["help"]), limits(each)])))]
    lines.append(".SH OPTIONS")
    for option in page["options"]:
        lines += man_option(option)
    if page["footer"].strip():
        lines += man_footer(page["footer"])
    if see:
        lines += [".SH SEE ALSO", ", ".join(f"\\fB{roff(other)}\\fR(1)" for other in see)]
    return "\n".join(lines) + "\n"


def usage_of(words, page):
    line = f"\\fB{roff(words)}\\fR [\\fIOPTIONS\\fR]"
    for each in page["positionals"]:
        name = f"\\fI{roff(each['name'])}\\fR"
        line += f" {name}" if each.get("required") else f" [{name}]"
    return [line]


def man_pages(program, verbs):
    name = program["name"]
    if not verbs:
        yield name, man_page(name, program, program["version"], program["description"].rstrip("."),
                             usage_of(name, program), see=["spiraling-edge"])
        return
    usage = [f"\\fB{roff(name)}\\fR \\fIVERB\\fR [\\fIOPTIONS\\fR]", ".br", f"\\fB{roff(name)}\\fR \\fIFILE\\fR"]
    yield name, man_page(name, program, program["version"], program["description"].rstrip("."), usage, program["verbs"],
                         [f"{name}-{verb}" for verb in verbs] + ["spiraling-edge-viewer"])
    for verb, page in verbs.items():
        see = [name] + (["spiraling-edge-viewer"] if verb in ("view", "render", "export") else [])
        yield f"{name}-{verb}", man_page(f"{name}-{verb}", page, program["version"], page["summary"],
                                         usage_of(f"{name} {verb}", page), see=see)


# Completions


def bash(program, verbs):
    name = program["name"]
    function = "_" + name.replace("-", "_")
    pages = verbs or {"": program}
    words = " ".join([*verbs, *(n for option in program["options"] for n in option["names"])]) if verbs else ""
    lines = [f"# Completion of {name} for bash. Made by app/packaging/pages.py.", f"{function}() {{",
             '    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} options="" values=""',
             "    COMPREPLY=()"]
    if verbs:
        lines += ["    if [ \"$COMP_CWORD\" = 1 ]; then",
                  f"        mapfile -t COMPREPLY < <(compgen -W {shlex.quote(words)} -- \"$word\")", "        return", "    fi"]
    verb_word = "${COMP_WORDS[1]}" if verbs else ""
    lines.append(f'    case "{verb_word}" in')
    for verb, page in pages.items():
        all_names = " ".join(n for option in page["options"] for n in option["names"])
        lines += [f'        "{verb}")', f"            options={shlex.quote(all_names)}", '            case "$before" in']
        for option in page["options"]:
            if choices(option):
                lines.append(f"                {'|'.join(option['names'])}) values={shlex.quote(' '.join(choices(option)))} ;;")
        lines += ["            esac", "            ;;"]
    lines += ["    esac",
              '    if [ -n "$values" ]; then mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")',
              '    elif [[ $word == -* ]]; then mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word"); fi',
              "}", f"complete -o bashdefault -o default -F {function} {name}"]
    return "\n".join(lines) + "\n"


def first_sentence(text):
    """Enough for a line of a list."""
    return re.split(r"(?<=[a-z)])[.;:] |\n", text)[0].rstrip(".")


def zsh_text(text):
    return re.sub(r"([\[\]:\\])", r"\\\1", first_sentence(text))


def zsh(program, verbs):
    name = program["name"]

    def arguments(page):
        for option in page["options"]:
            value = ""
            if placeholder(option):
                action = f"({' '.join(choices(option))})" if choices(option) else "_files"
                value = f":{zsh_text(placeholder(option))}:{action}"
            group = f"({' '.join(option['names'])})" if len(option["names"]) > 1 else ""
            for one in option["names"]:
                yield shlex.quote(f"*{one}[{zsh_text(option['help'])}]{value}" if not group else
                                  f"{group}{one}[{zsh_text(option['help'])}]{value}")
        yield shlex.quote("*:file:_files")

    lines = [f"#compdef {name}", "# Made by app/packaging/pages.py."]
    if not verbs:
        return "\n".join(lines + ["_arguments \\\n    " + " \\\n    ".join(arguments(program))]) + "\n"
    lines += ["if (( CURRENT == 2 )); then", "    local -a verbs=("]
    lines += ["        " + shlex.quote(f"{verb['name']}:{zsh_text(verb['summary'])}") for verb in program["verbs"]]
    lines += ["    )", "    _describe verb verbs", "    _arguments " + " ".join(
        shlex.quote(f"{one}[{zsh_text(option['help'])}]") for option in program["options"] for one in option["names"]),
        "    _files", "    return", "fi", "local verb=$words[2]", "shift words", "(( CURRENT-- ))", "case $verb in"]
    for verb, page in verbs.items():
        lines += [f"    {verb})", "        _arguments \\\n            " + " \\\n            ".join(arguments(page)), "        ;;"]
    return "\n".join(lines + ["esac"]) + "\n"


def fish_quote(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish(program, verbs):
    name = program["name"]
    lines = [f"# Completion of {name} for fish. Made by app/packaging/pages.py."]

    def options(page, condition):
        for option in page["options"]:
            line = f"complete -c {name}{condition}"
            for one in option["names"]:
                line += f" -l {one[2:]}" if one.startswith("--") else f" -s {one[1:]}"
            if placeholder(option):
                line += " -x -a " + fish_quote(" ".join(choices(option))) if choices(option) else " -r"
            yield line + " -d " + fish_quote(first_sentence(option["help"]))

    for verb in program.get("verbs", []):
        lines.append(f"complete -c {name} -n __fish_use_subcommand -a {verb['name']} -d " + fish_quote(verb["summary"]))
    lines += options(program, " -n __fish_use_subcommand" if verbs else "")
    for verb, page in verbs.items():
        lines += options(page, f" -n '__fish_seen_subcommand_from {verb}'")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, verbs = listed(sys.argv[1])
    folder = pathlib.Path(sys.argv[2])
    name = program["name"]
    files = {f"bash/{name}": bash(program, verbs), f"zsh/_{name}": zsh(program, verbs), f"fish/{name}.fish": fish(program, verbs)}
    files = {path: text.encode() for path, text in files.items()}
    for page, text in man_pages(program, verbs):  # packed as Debian asks, without a time
        files[f"man1/{page}.1.gz"] = gzip.compress(text.encode(), 9, mtime=0)
    for path, content in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)


if __name__ == "__main__":
    main()
