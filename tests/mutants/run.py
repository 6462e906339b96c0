#!/usr/bin/env python3
"""Mutants of core: small changes, each of which some test of core must notice.

    tests/mutants/run.py --check                 each old text occurs exactly once (seconds)
    tests/mutants/run.py --list
    tests/mutants/run.py --work FOLDER [-j N] [--quick] [--only NAME]...

One build holds all mutants: a copy of the checkout in FOLDER/source, where each old text is replaced by
code that the environment variable SE_MUTANT=NAME switches on. A later run with the same FOLDER builds
only changed files, and begins with the test that killed a mutant before. An endless loop counts as killed.

The other files here are the tables: TABLE maps a file below core/spiraling_edge/ to rows
(name, old text, new text[, reason]). In the new text MUT is true if the mutant is on, and OLD stands for
the old text. A reason says why the change alters nothing that a test could see. The exit code is 1 if the
tables do not fit the sources, the tests fail without a mutant, or at least 3 % of the mutants survive
without a reason.
"""
import argparse
import importlib.util
import json
import os
import re
import resource
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CORE = Path("core/spiraling_edge")
# A room knows those before it (.ci/layers.sh): the tests of a room can notice mutants of these alone.
ROOMS = ["base", "points", "geometry", "mesh", "io", "stepper", "prepare", "doctor", "scenes", "replay", "explain"]
MOST_SURVIVORS = 0.03
QUICK_SECONDS = 0.25  # Test cases up to this long are tried first.
SLOWER = 5  # Tests that take this many times as long as without a mutant count as an endless loop.
HEADER = """#pragma once
#ifdef __cplusplus
#include <cstdlib>
#include <cstdint>
namespace se_mutant {
constexpr std::uint64_t hash(const char* text) {
    std::uint64_t h = 0xCBF29CE484222325U;
    for (; *text != 0; ++text) h = (h ^ static_cast<unsigned char>(*text)) * 0x100000001B3U;
    return h;
}
inline const std::uint64_t active = std::getenv("SE_MUTANT") ? hash(std::getenv("SE_MUTANT")) : 0;
template <std::uint64_t kName>
inline bool on() { return active == kName; }
}  // namespace se_mutant
#define SE_MUTANT(name) (::se_mutant::on<::se_mutant::hash(name)>())
#endif
"""


@dataclass
class Mutant:
    name: str
    file: Path
    old: str
    new: str
    reason: str
    table: str


def load_tables():
    mutants = []
    for path in sorted(HERE.glob("*.py")):
        if path == Path(__file__).resolve():
            continue
        spec = importlib.util.spec_from_file_location(path.stem, path)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        for file, rows in module.TABLE.items():
            mutants += [Mutant(r[0], CORE / file, r[1], r[2], r[3] if len(r) > 3 else "", path.stem)
                        for r in rows]
    return mutants


def check(mutants):
    """The problems of the tables, one a line."""
    problems = []
    names = [m.name for m in mutants]
    problems += [f"{name}: the name occurs twice" for name in sorted({n for n in names if names.count(n) > 1})]
    for file in sorted({m.file for m in mutants}):
        if not (ROOT / file).exists():
            problems.append(f"{file}: no such file")
            continue
        text = (ROOT / file).read_text()
        places = []
        for m in (m for m in mutants if m.file == file):
            if text.count(m.old) != 1:
                problems.append(f"{m.name}: old text found {text.count(m.old)} times in {file}")
                continue
            places.append((text.index(m.old), text.index(m.old) + len(m.old), m.name))
            if not re.search(r"\bMUT\b", m.new):
                problems.append(f"{m.name}: the new text has no MUT")
        places.sort()
        problems += [f"{a[2]} and {b[2]}: the old texts overlap"
                     for a, b in zip(places, places[1:]) if b[0] < a[1]]
    return problems


def with_mutants(text, mutants):
    """The text of a file with all its mutants, on the same number of lines as far as possible."""
    for m in sorted(mutants, key=lambda m: -text.index(m.old)):
        new = m.new.replace("OLD", m.old)
        new = re.sub(r"\bMUT\b", f'SE_MUTANT("{m.name}")', new)
        at = text.index(m.old)
        text = text[:at] + new + text[at + len(m.old):]
    return text


def write_if_changed(path, data):
    if path.exists() and path.read_bytes() == data:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data)


def copy_checkout(target, mutants):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                            capture_output=True).stdout.decode().split("\0")
    files = {name for name in listed if name and (ROOT / name).is_file()}
    for name in files:
        mine = [m for m in mutants if str(m.file) == name]
        data = (ROOT / name).read_bytes()
        write_if_changed(target / name, with_mutants(data.decode(), mine).encode() if mine else data)
    for path in target.rglob("*"):
        if path.is_file() and str(path.relative_to(target)) not in files:
            path.unlink()


def build(work, jobs):
    write_if_changed(work / "mutant.h", HEADER.encode())
    source, folder = work / "source", work / "build"
    environment = dict(os.environ, CCACHE_BASEDIR=str(source), CCACHE_NOHASHDIR="1")
    flags = f"-w -include {work / 'mutant.h'}"
    subprocess.run(["cmake", "--preset", "release", "-B", str(folder), "-DSPIRALING_EDGE_BUILD_TESTS=ON",
                    "-DSPIRALING_EDGE_BUILD_VIEWER=OFF", "-DSPIRALING_EDGE_BUILD_CLI=OFF",
                    f"-DCMAKE_CXX_FLAGS={flags}"], cwd=source, env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(folder), "--target", "core_tests", "-j", str(jobs)],
                   env=environment, check=True)
    return folder / "tests" / "core_tests"


def begin_test():
    # A shell's background jobs ignore the last two, nohup the first.
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT):
        signal.signal(number, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def pattern(name):
    """A test's name for a filter of doctest, where commas separate names."""
    return re.sub(r"[,\\*\"]", "?", name)


class Tests:
    def __init__(self, program, work, quick):
        self.quick = quick
        self.program = program
        self.work = work
        self.seconds = {}

    def run(self, arguments, mutant="", limit=3600):
        """(passed, output)"""
        environment = dict(os.environ, SE_MUTANT=mutant)
        try:
            done = subprocess.run([str(self.program), "-nc", *arguments], cwd=self.work, env=environment,
                                  preexec_fn=begin_test, timeout=limit, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
        except subprocess.TimeoutExpired:
            return False, "TEST CASE:  (time limit)"
        return done.returncode == 0, done.stdout.decode(errors="replace")

    def slow_ones(self):
        return ",".join(pattern(n) for n, s in self.seconds.items() if s > QUICK_SECONDS)

    def measure(self):
        """Runs all tests without a mutant; None if they pass, else the output."""
        memory = self.work / "seconds.json"
        if self.quick and memory.exists():
            self.seconds = json.loads(memory.read_text())
        passed, output = self.run(["-d", "-tce=" + self.slow_ones()])
        for seconds, name in re.findall(r"^([0-9.]+) s: (.*)$", output, re.M):
            self.seconds[name] = float(seconds)
        memory.write_text(json.dumps(self.seconds, indent=1))
        self.total = sum(self.seconds.values())
        self.slow = self.slow_ones()
        self.quick_total = sum(s for s in self.seconds.values() if s <= QUICK_SECONDS)
        return None if passed else output

    def killer(self, mutant, before):
        """The test that fails with the mutant, or None."""
        room = mutant.file.parts[2]
        later = [*ROOMS[ROOMS.index(room) + 1:], "sampling", "scenarios"]
        folders = ["-sf=" + ",".join(f"*/core/{name}/*" for name in names) for names in ([room], later)]
        passes = [(SLOWER * self.quick_total + 10, [folder, "-tce=" + self.slow]) for folder in folders]
        if self.slow and not self.quick:
            passes += [(SLOWER * self.total + 10, [folder, "-tc=" + self.slow]) for folder in folders]
        if before in self.seconds:
            passes.insert(0, (SLOWER * self.seconds[before] + 10, ["-tc=" + pattern(before)]))
        for limit, arguments in passes:
            passed, output = self.run(["--abort-after=1", *arguments], mutant.name, limit)
            if not passed:
                found = re.findall(r"^TEST CASE:  (.*)$", output, re.M)
                return found[-1].strip() if found else "(crash)"
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--work", type=Path)
    parser.add_argument("--quick", action="store_true", help="without the slow tests")
    parser.add_argument("--only", action="append", default=[], metavar="NAME", help="its beginning, or a table")
    parser.add_argument("-j", "--jobs", type=int, default=1)
    options = parser.parse_args()
    mutants = load_tables()
    if options.list:
        for m in mutants:
            print(f"{m.name}\t{m.file}" + (f"\t{m.reason}" if m.reason else ""))
        return 0
    problems = check(mutants)
    print(*problems, sep="\n", end="\n" if problems else "")
    if problems or options.check:
        print(f"{len(mutants)} mutants, {len(problems)} problems")
        return 1 if problems else 0
    if not options.work:
        parser.error("--work FOLDER is missing")
    chosen = [m for m in mutants if not options.only or any(o == m.table or m.name.startswith(o) for o in options.only)]
    work = options.work.resolve()
    copy_checkout(work / "source", mutants)
    tests = Tests(build(work, options.jobs), work, options.quick)
    problem = tests.measure()
    if problem is not None:
        found = re.search(r"^TEST CASE:  (?:(?!^TEST CASE)[\s\S])*?ERROR[\s\S]{0,800}", problem, re.M)
        print(found.group(0) if found else problem[-4000:], "\nthe tests fail without a mutant")
        return 1
    print(f"{len(tests.seconds)} tests pass in {tests.total:.0f} s", flush=True)
    memory = work / "killers.json"
    killers = json.loads(memory.read_text()) if memory.exists() else {}

    def judge(m):
        test = tests.killer(m, killers.get(m.name))
        killers[m.name] = test
        memory.write_text(json.dumps(killers, indent=1, sort_keys=True))
        verdict = f"killed by {test}" if test else "survived" + (f", reason: {m.reason}" if m.reason else "")
        print(f"{m.name}: {verdict}", flush=True)
        return test

    with ThreadPoolExecutor(options.jobs) as pool:
        found = list(pool.map(judge, chosen))
    survivors = [m for m, test in zip(chosen, found) if not test]
    open_ones = [m for m in survivors if not m.reason]
    share = len(open_ones) / max(1, len(chosen))
    print(f"{len(chosen)} mutants: {len(chosen) - len(survivors)} killed, {len(survivors) - len(open_ones)} "
          f"survived with a reason, {len(open_ones)} without ({100 * share:.1f} %)")
    for m, test in zip(chosen, found):
        if test and m.reason:
            print(f"{m.name} is killed: its reason is wrong")
    return 1 if share >= MOST_SURVIVORS else 0


if __name__ == "__main__":
    sys.exit(main())
