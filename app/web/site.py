"""The page and its files from what the compiler has made: site.py BIN SITE ONE_FILE VERSION [PROGRAM]

SITE is a folder for any server that serves files; ONE_FILE is the same program as one page, which
opens from a disk. PROGRAM, the native spiraling-edge beside its viewer, draws the pages before the program;
without it there are none."""

import base64
import hashlib
import json
import pathlib
import re
import shutil
import sys
import zlib

import pages

parts = {file.name: file.read_text().rstrip("\n") for file in (pathlib.Path(__file__).resolve().parent / "page").iterdir()}
binaries, site, one_file = map(pathlib.Path, sys.argv[1:4])
version = sys.argv[4]
program = sys.argv[5] if len(sys.argv) > 5 else None
made = {f"viewer.{kind}": binaries / f"spiraling-edge-web.{kind}" for kind in ("js", "wasm", "data")}


def filled(name, **more):
    """A file of page/ with its parts put in."""
    text = parts[name]
    for part, content in (parts | more).items():
        text = text.replace("{{" + part + "}}", content)
    assert "{{" not in text
    return text + "\n"


def linked(root="", link="", title="Spiraling Edge", body="<h1>Spiraling Edge</h1>", text=""):
    """The page with its files beside it, or in the folder `root`."""
    listed = f' <a href="{root}pages/">Pages with pictures</a> do not.' if program else ""
    return filled("index.html", link=link, title=title, body=body, text=text, packed="", list=listed,
                  style=f'<link rel="stylesheet" href="{root}page.css">', script=f'<script src="{root}page.js"></script>')


def packed(file):
    """A file as text, for the page that holds all."""
    pack = zlib.compressobj(9, zlib.DEFLATED, -15)
    return base64.b64encode(pack.compress(file.read_bytes()) + pack.flush()).decode()


folder = site / version
shutil.rmtree(folder, ignore_errors=True)  # other versions stay
folder.mkdir(parents=True)
for name, file in made.items():
    shutil.copy(file, folder / name)
code = filled("page.js", version=version, bytes=json.dumps({name: file.stat().st_size for name, file in made.items()}))
code = re.sub(r"^ *//.*\n", "", code, flags=re.MULTILINE)  # comments are a fifth of what is sent
(folder / "page.css").write_text(parts["page.css"] + "\n")
(folder / "page.js").write_text(code)
(folder / "index.html").write_text(linked())
digest = hashlib.sha256(b"".join(file.read_bytes() for file in sorted(folder.iterdir()))).hexdigest()[:16]
(folder / "offline.js").write_text(filled("offline.js", digest=digest))
(site / "index.html").write_text(filled("newest.html", version=version))
one_file.write_text(filled(
    "index.html", link="", title="Spiraling Edge", body="<h1>Spiraling Edge</h1>", text="", list="",
    style=f"<style>{parts['page.css']}</style>", script=f"<script>\n{code}</script>",
    packed="\n".join(f'<script type="text/plain" id="packed-{name}">{packed(file)}</script>' for name, file in made.items())))
if program:
    written = pages.write_pages(folder, program, one_file.parent / "pages", linked)
    (folder / "pages").mkdir()
    (folder / "pages" / "index.html").write_text(filled("pages.html", list="\n".join(
        f'<li><a href="../{page.path}">{page.title}</a>' for page in written)))
else:
    print("no pages before the program: there is no native one to draw them")
