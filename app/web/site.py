"""The page and its files from what the compiler has made: site.py BIN SITE ONE_FILE VERSION

SITE is a folder for any server that serves files; ONE_FILE is the same program as one page, which
opens from a disk."""

import base64
import hashlib
import json
import pathlib
import shutil
import sys
import zlib

page = pathlib.Path(__file__).resolve().parent / "page"
binaries, site, one_file = map(pathlib.Path, sys.argv[1:4])
version = sys.argv[4]
made = {f"viewer.{kind}": binaries / f"spiraling-edge-web.{kind}" for kind in ("js", "wasm", "data")}


def index(packed=""):
    """The page with its parts put in."""
    parts = {file.name: file.read_text() for file in page.iterdir() if file.suffix in (".css", ".js")}
    parts |= {"version": version, "packed": packed,
              "bytes": json.dumps({name: file.stat().st_size for name, file in made.items()})}
    text = (page / "index.html").read_text()
    for name, content in parts.items():
        text = text.replace("{{" + name + "}}", content.rstrip("\n"))
    assert "{{" not in text
    return text


def packed(file):
    """A file as text, for the page that holds all."""
    pack = zlib.compressobj(9, zlib.DEFLATED, -15)
    return base64.b64encode(pack.compress(file.read_bytes()) + pack.flush()).decode()


folder = site / version
shutil.rmtree(folder, ignore_errors=True)  # other versions stay
folder.mkdir(parents=True)
for name, file in made.items():
    shutil.copy(file, folder / name)
(folder / "index.html").write_text(index())
digest = hashlib.sha256(b"".join(file.read_bytes() for file in sorted(folder.iterdir()))).hexdigest()[:16]
(folder / "offline.js").write_text((page / "offline.js").read_text().replace("{{digest}}", digest))
(site / "index.html").write_text((page / "newest.html").read_text().replace("{{version}}", version))
one_file.write_text(index("\n".join(f'<script type="text/plain" id="packed-{name}">{packed(file)}</script>'
                                    for name, file in made.items())))
