#!/usr/bin/env python3
"""Copies the pages here with links to the program: figures of the paper, scenes and lessons that a
page names open in the viewer's page.

  docs/link-pages.py URL FOLDER [PROGRAM]

URL: where links begin, the address of the viewer's page (docs/web.md); empty: FOLDER gets the pages
as they are. PROGRAM is spiraling-edge, whose verb `figures` has the scene and the address of each.
"""
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
# What stays as it is, blocks, links and comments; then what becomes a link.
PARTS = re.compile(r"(?P<kept>```.*?^```|!?\[[^]]*\]\([^)]*\)|<!--.*?-->)"
                   r"|`(?P<kind>scene|lesson):(?P<id>[a-z0-9-]+)`"
                   r"|\bFigure (?P<figure>\d+)"
                   r"|^\| (?P<row>(?P<first>\d+)[0-9, ]*) \| (?P<at>\d+\.[a-z]+\.\d+)", re.M | re.S)


def figures(program):
    """By the number of each figure the end of its link."""
    text = subprocess.run([program, "figures"], check=True, capture_output=True, text=True).stdout
    found = re.findall(r"^Figure (\d+):.*?^  open +scene:(\S+)(?: --goto (\S+))?", text, re.M | re.S)
    return {number: f"#scene={scene}" + (f"&goto={at.replace('%', '%25')}" if at else "")
            for number, scene, at in found}


def linked(text, url, places):
    def link(match):
        if match["kind"]:
            return f"[{match[0]}]({url}#{match['kind']}={match['id']})"
        place = places.get(match["figure"] or match["first"])
        if match["kept"] or place is None:
            return match[0]
        if match["figure"]:
            return f"[{match[0]}]({url}{place})"
        return f"| {match['row']} | [{match['at']}]({url}#scene=figure-{match['first']}&goto={match['at']})"
    return PARTS.sub(link, text)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    url, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    program = sys.argv[3] if len(sys.argv) == 4 else HERE / "../build/bin/spiraling-edge"
    shutil.copytree(HERE, folder, dirs_exist_ok=True)
    places = figures(program) if url else {}
    for page in folder.glob("*.md") if url else ():
        page.write_text(linked(page.read_text(), url, places))


if __name__ == "__main__":
    main()
