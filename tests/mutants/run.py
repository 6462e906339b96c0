#!/usr/bin/env python3
"""Mutants of core: small changes of the sources, each of which some test of core should notice.

    tests/mutants/run.py --list [--share X] [--seed N] [--only TEXT]...
    tests/mutants/run.py --work FOLDER [-j N] [--quick] [--share X] [--seed N] [--only TEXT]...

operators.py has the changes. They are made at a share of all places, drawn by a hash of the changed line:
other changes of the sources leave the draw as it is, and another seed draws others. One build, in FOLDER,
holds them all; the environment variable SE_MUTANT=NUMBER switches one on. A mutant meets the tests that run its
place: first the file that killed it before, then one file after the other, the quickest first. An endless
loop counts as killed. The exit code is 1 if a test fails without a mutant, or too many mutants survive.
"""
import argparse
import json
import os
import re
import resource
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
import operators  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent.parent
NOT_MUTATED = {"scenes"}  # Inputs of tests.
SHARE = 0.02
MOST_SURVIVORS = 0.22  # Of those drawn by seed 1, some of which change nothing that a test could see.
QUICK_SECONDS = 2.0
SLOWER = 5  # A file of tests that takes this many times as long as without a mutant is in an endless loop.


def draw(share, seed):
    """The sources of core by path, and their drawn sites by number."""
    sources, drawn = {}, {}
    for path in sorted((ROOT / "core" / "spiraling_edge").rglob("*.*")):
        if path.suffix in {".cpp", ".h"} and NOT_MUTATED.isdisjoint(path.parts):
            name = str(path.relative_to(ROOT))
            sources[name] = operators.Source(name, path.read_text())
            for site in sources[name].sites():
                number = site.drawn(seed)
                if number < share * 2**20:
                    drawn[next(n for n in range(number, 2**20) if n not in drawn)] = site
    return sources, drawn


def write_if_changed(path, text):
    if not path.exists() or path.read_bytes() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)


def copy_checkout(target, sources, drawn):
    """Copies the checkout with the mutants."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    files = {name for name in listed if name and (ROOT / name).is_file()}
    for name in files:
        mine = {number: site for number, site in drawn.items() if site.path == name}
        write_if_changed(target / name,
                         sources[name].mutated(mine).encode() if mine else (ROOT / name).read_bytes())
    for path in target.rglob("*"):
        if path.is_file() and str(path.relative_to(target)) not in files:
            path.unlink()


def build(work, jobs):
    """Builds the tests of core and returns their program."""
    source, folder = work / "source", work / "build"
    environment = dict(os.environ, CCACHE_BASEDIR=str(source), CCACHE_NOHASHDIR="1")
    flags = f"-w -Wno-narrowing -include {work / 'mutant.h'}"
    subprocess.run(["cmake", "--preset", "release", "-B", str(folder), "-DSPIRALING_EDGE_BUILD_TESTS=ON",
                    "-DSPIRALING_EDGE_BUILD_VIEWER=OFF", "-DSPIRALING_EDGE_BUILD_CLI=OFF",
                    f"-DCMAKE_CXX_FLAGS={flags}"], cwd=source, env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(folder), "--target", "core_tests", "-j", str(jobs)],
                   env=environment, check=True)
    return folder / "tests" / "core_tests"


def begin_test(seconds):
    # A shell's background jobs ignore the last two, nohup the first.
    for number in (signal.SIGHUP, signal.SIGINT, signal.SIGQUIT):
        signal.signal(number, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Tests:
    """The files of tests: how long each takes, and which mutants it runs."""

    def __init__(self, program, work, quick):
        self.program, self.work, self.quick = program, work, quick
        self.seconds, self.runs, self.compiled = {}, {}, set()

    def run(self, file, mutant=-1, limit=3600):
        """The name of the test that failed, or None."""
        environment = dict(os.environ, SE_MUTANT=str(mutant), SE_MET=str(self.work / "met") if mutant < 0 else "")
        try:
            done = subprocess.run([str(self.program), "-nc", "--abort-after=1", f"-sf=*/{file}"], cwd=self.work,
                                  env=environment, preexec_fn=lambda: begin_test(limit), timeout=100 * limit,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        except subprocess.TimeoutExpired:
            return "(endless)"
        found = re.findall(r"^TEST CASE:  *(.*?) *$", done.stdout.decode(errors="replace"), re.M)
        return (found or ["(crash)"])[-1] if done.returncode else None

    def measure(self, drawn):
        """Runs all tests without a mutant; None, or the one that fails."""
        memory = self.work / "seconds.json"
        known = json.loads(memory.read_text()) if memory.exists() else {}
        for path in sorted((ROOT / "tests" / "core").rglob("*_test.cpp")):
            file = str(path.relative_to(ROOT / "tests"))
            if self.quick and known.get(file, 0) > QUICK_SECONDS:
                continue
            before = cpu_seconds()
            if failed := self.run(file):
                return f"{file}: {failed}"
            known[file] = self.seconds[file] = cpu_seconds() - before
            met = (self.work / "met").read_bytes()
            self.compiled = {number for number in drawn if met[number] > 0}
            self.runs[file] = {number for number in drawn if met[number] > 1}
            memory.write_text(json.dumps(known, indent=1))
        return None

    def killer(self, mutant, before):
        """The file and the test that fails with the mutant, or None and what is known instead."""
        files = [file for file, runs in self.runs.items() if mutant in runs]
        for file in sorted(files, key=lambda file: (file != before, self.seconds[file])):
            if failed := self.run(file, mutant, int(SLOWER * self.seconds[file]) + 10):
                return file, failed
        return None, "survives" if files else "is run by no test"


def judge(tests, chosen, jobs):
    """Prints the fate of each mutant; returns the number of survivors."""
    memory = tests.work / "killers.json"
    killers = json.loads(memory.read_text()) if memory.exists() else {}

    def survives(item):
        number, site = item
        file, test = tests.killer(number, killers.get(site.key))
        if file:
            killers[site.key] = file
            memory.write_text(json.dumps(killers, indent=1, sort_keys=True))
        print(f"{site}\t{file}: {test}" if file else f"{site}\t{test}", flush=True)
        return not file

    with ThreadPoolExecutor(jobs) as pool:
        return sum(pool.map(survives, chosen.items()))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--work", type=Path)
    parser.add_argument("--quick", action="store_true", help="without the slow files of tests")
    parser.add_argument("--only", action="append", default=[], metavar="TEXT", help="part of a line of the list")
    parser.add_argument("--share", type=float, default=SHARE, help=f"of all places, {SHARE}")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-j", "--jobs", type=int, default=1)
    options = parser.parse_args()
    if not options.work and not options.list:
        parser.error("--work FOLDER is missing")
    return options


def main():
    options = arguments()
    sources, drawn = draw(options.share, options.seed)
    chosen = {number: site for number, site in drawn.items()
              if not options.only or any(text in str(site) for text in options.only)}
    if options.list:
        print(*chosen.values(), sep="\n")
        return 0
    work = options.work.resolve()
    write_if_changed(work / "mutant.h", operators.HEADER.encode())
    copy_checkout(work / "source", sources, drawn)
    tests = Tests(build(work, options.jobs), work, options.quick)
    if failed := tests.measure(drawn):
        print(f"{failed}\nthe tests fail without a mutant")
        return 1
    print(f"{len(tests.seconds)} files of tests pass in {sum(tests.seconds.values()):.0f} s", flush=True)
    chosen = {number: site for number, site in chosen.items() if number in tests.compiled}
    count, survivors = len(chosen), judge(tests, chosen, options.jobs)
    share = survivors / max(1, count)
    print(f"{count} mutants: {count - survivors} killed, {survivors} survived ({100 * share:.1f} %)")
    return 1 if share > MOST_SURVIVORS else 0


if __name__ == "__main__":
    sys.exit(main())
