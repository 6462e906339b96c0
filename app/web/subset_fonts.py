"""Fonts with the characters of the program's own texts alone: subset_fonts.py FOLDER FONT..."""

import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parents[2]
latin = set(map(chr, range(0x20, 0x100)))  # names of files


def characters_of(text):
    found = set(text)
    for run in re.findall(r"(?:\\x[0-9A-Fa-f]{2})+", text):
        found |= set(bytes.fromhex(run.replace("\\x", "")).decode(errors="ignore"))
    return found | {chr(int(code, 16)) for code in re.findall(r"\\u([0-9A-Fa-f]{4})", text)}


used = set(latin)
for folder in ("app", "core", "assets", "docs"):
    for file in sorted((root / folder).rglob("*")):
        if file.suffix in (".cpp", ".h", ".md", ".txt", ".toml"):
            used |= characters_of(file.read_text(errors="replace"))
used = {c for c in used if ord(c) >= 0x20 and c not in "\ufeff\ufffd"}

folder = pathlib.Path(sys.argv[1])
for font in sys.argv[2:]:
    target = folder / pathlib.Path(font).name
    subprocess.run([sys.executable, "-m", "fontTools.subset", font, "--text=" + "".join(sorted(used)),
                    "--layout-features=", "--no-hinting", "--desubroutinize", f"--output-file={target}"],
                   check=True)
