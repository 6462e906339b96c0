"""The pages before the program: for each step of a lesson, figure and scene its picture, its sentence and the
way on. The pictures are those of the export as a page, which has the colors of both themes."""

import html
import json
import os
import pathlib
import re
import string
import subprocess
import typing

kMostBytes = 40000
kSize = "640x420"
kLook = ("fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray",
         "stop-color", "stop-opacity", "font-weight")
kLetters = string.ascii_letters + string.digits


class Page(typing.NamedTuple):
    """One page: its folder, the link that opens the program there, and what it shows."""
    path: str
    link: str
    title: str
    picture: str
    style: str
    sentence: str
    text: str


class Look:
    """Colors of the export by class, light and dark, and a short class for each and for the rest of a look."""

    def __init__(self, exported):
        sheet = exported[exported.index("\n.", exported.index("@media print")):exported.index("</style>")]
        light, dark = sheet.split("@media screen and (prefers-color-scheme: dark)")
        self.themes = [dict(re.findall(r"\.([\w-]+)\{([^}]*)\}", each)) for each in (light, dark)]
        for theme in self.themes:  # what is filled, as a line
            theme |= {name + "-dot": rule.replace("fill", "stroke") for name, rule in theme.items()}
        self.names = {}

    def round(self):
        """Fewer shades."""
        def shade(color):
            return "#" + "".join(f"{(int(color[0][i:i + 2], 16) + 8) // 17:x}" for i in (1, 3, 5))
        for theme in self.themes:
            theme |= {name: re.sub(r"#[0-9a-f]{6}", shade, rule) for name, rule in theme.items()}

    def name(self, look):
        count = len(self.names)
        return self.names.setdefault(look, kLetters[count % 52] + (kLetters[count // 52] if count > 51 else ""))

    def shorten(self, tag):
        """The tag with short classes in place of the attributes that a style can have."""
        values = dict(re.findall(r' ([\w-]+)="([^"]*)"', tag[0]))
        looks = values.pop("class", "").split()
        looks.append(";".join(f"{name}:{values.pop(name)}" for name in kLook if name in values))
        values.pop("data-point", None)
        names = " ".join(self.name((self.themes[0].get(each, each), self.themes[1].get(each, ""))) for each in looks if each)
        values = ({"class": names} if names else {}) | values
        return f"<{tag[1]}" + "".join(f' {name}="{value}"' for name, value in values.items()) + ("/>" if tag[0].endswith("/>") else ">")

    def sheet(self):
        """The style of all names."""
        return ("".join(f".{name}{{{light}}}" for (light, _), name in self.names.items()) + "@media(prefers-color-scheme:dark){" +
                "".join(f".{name}{{{dark}}}" for (_, dark), name in self.names.items() if dark) + "}")


def coarse(svg):
    """Paths in whole pixels, each corner from the one before; circles of one arc; small marks as they are."""
    def path(data):
        numbers = [float(each) for each in re.findall(r"-?[\d.]+", data[1])]
        if max(numbers) - min(numbers) < 24 or "a" in data[1]:
            return data[0]
        parts = []
        for outline in data[1].split("M")[1:]:
            corners = [(round(float(x)), round(float(y))) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", outline)]
            steps = " ".join(f"{x - a} {y - b}" for (a, b), (x, y) in zip(corners, corners[1:]))
            parts.append(f"M{corners[0][0]} {corners[0][1]}l{steps}" + "z" * outline.endswith("z"))
        return ' d="' + "".join(parts).replace(" -", "-") + '"'
    svg = re.sub(r"a([\d.]+) \1 0 1 1 [\d.]+ 0a[^z]*z", r"a\1 \1 0 1 1 0 .1z", svg)
    svg = re.sub(r' stroke-dashoffset="[^"]*"|(?<= stroke-dasharray="\d)\.\d', "", svg)
    return re.sub(r' d="(M[^"]*)"', path, svg)


def dots(svg):
    """Points as dots of one size, one path for each color, and no two of it in the same 8 x 8 pixels."""
    def group(points):
        places = {}
        for look, x, y, radius in re.findall(r'class="([\w-]+)"[^>]* d="M(-?[\d.]+) (-?[\d.]+)a([\d.]+) ', points[2]):
            at = round(float(x) + float(radius)), round(float(y))
            places.setdefault(look, {}).setdefault((at[0] // 8, at[1] // 8), at)
        def path(all_at):
            return "".join(f"m{x - a} {y - b}h0" for (a, b), (x, y) in zip([(0, 0), *all_at], all_at)).replace(" -", "-")
        return points[1] + "".join(f'<path class="{look}-dot" stroke-width="3" d="{path(sorted(each.values()))}"/>'
                                   for look, each in places.items()) + "</g>"
    return re.sub(r'(<g id="[\w-]*points">)(.*?)</g>', group, svg, flags=re.S)


def plain(svg):
    """All triangles with edges of one look."""
    edges = r' stroke-width="[^"]*"(?: stroke-opacity="[^"]*")?'
    def group(triangles):
        return triangles[1] + ' class="mesh-edge-line" stroke-width="1" stroke-opacity="0.6">' + re.sub(
            f'"mesh-edge-line (f\\d+)"{edges}', r'"\1"', triangles[2])
    return re.sub(r'(<g id="[\w-]*triangles")>(.*?</g>)', group, svg, flags=re.S)


def smallest(svg, exported, rest):
    """The picture and its style, with less detail where they would not fit beside the rest, in bytes."""
    look = Look(exported)
    for less in (lambda: svg, lambda: coarse(svg), lambda: dots(svg), lambda: look.round() or plain(svg)):
        svg = less()
        look.names = {}
        short = re.sub(r'<(\w+)((?: [\w-]+="[^"]*")*) ?/?>', look.shorten, svg)
        short = re.sub(r'(<path class="[^"]*" d=")([^"]*"/>(?:\1[^"]*"/>)+)',  # neighbors of one look
                       lambda all: all[1] + all[2].replace('"/>' + all[1], ""), short)
        short = re.sub(r'class="(\w+)"', r"class=\1", short)
        if len((short + look.sheet()).encode()) + rest < kMostBytes:
            break
    return short, look.sheet()


def pages_of(program, work):
    """All pages, in the order of reading: lessons, figures, scenes."""
    def listed(*words):
        return json.loads(subprocess.run([program, *words, "--json"], check=True, capture_output=True).stdout)

    def exported(path, name, *words):
        """The parts of an export of one frame: as a link opens it, not as the step before leaves the camera."""
        file = work / (path.strip("/").replace("/", "-") + ".html")
        if not file.exists() or file.stat().st_mtime < pathlib.Path(program + "-viewer").stat().st_mtime:
            subprocess.run([program, "export", name, *words, "-o", file, "--size", kSize, "--theme", "light"],
                           check=True, stdout=subprocess.DEVNULL)
        whole = re.sub(r"<form.*?</form>", "<p>The program asks for the answer.</p>", file.read_text(), flags=re.S)
        parts = re.search(r'data-title="([^"]*)".*?(<svg.*?</svg>)\n<figcaption>(?:([\w.]+): )?(.*?)</figcaption>.*'
                          r'<div class="text">(.*?)</div>', whole, re.S).groups()
        title, svg, address, sentence, text = parts
        return (title, address, *smallest(svg, whole, len((text + sentence).encode()) + 3000), sentence, text)

    work.mkdir(parents=True, exist_ok=True)
    for lesson in listed("lesson", "list"):
        steps = []
        for step in map(str, range(1, lesson["steps"] + 1)):
            path = f"lesson/{lesson['id']}/{step}/"
            title, _, *shown = exported(path, "lesson:" + lesson["id"], "--steps", step)
            steps.append(Page(path, f"lesson={lesson['id']}&step={step}", f"{html.escape(lesson['title'])}, step {step}: {title}", *shown))
        yield steps[0]
        # Each export begins with the text of the lesson.
        intro = "".join(os.path.commonprefix([each.text.splitlines(True) for each in steps]))
        yield from (each._replace(text=each.text.removeprefix(intro)) for each in steps[1:])
    for scene in sorted(listed("scenes"), key=lambda each: not each["id"].startswith("figure-")):
        path = re.sub("^scene/figure-", "figure/", f"scene/{scene['id']}/")
        _, address, *shown, _ = exported(path, "scene:" + scene["id"], "--goto", scene.get("address", "100%"))
        yield Page(path, f"scene={scene['id']}&goto={address}", html.escape(scene["title"]), *shown,
                   f"<p>{html.escape(scene['watch'])}</p>")


def body(page, before, after):
    """What a page has in place of the name of the program."""
    root = "../" * page.path.count("/")
    ways = [f'<a rel="prev" href="{root}{before.path}">Back</a>' if before else "", f'<a href="{root}pages/">All pages</a>',
            f'<a rel="next" href="{root}{after.path}">Next</a>' if after else ""]
    return (f'<article class="page">\n<h1>{page.title}</h1>\n<figure><div id="picture"><style>{page.style}</style>{page.picture}</div>\n'
            f'<figcaption>{page.sentence}</figcaption></figure>\n<nav>{" ".join(filter(None, ways))}</nav>\n</article>')


def write_pages(folder, program, work, template):
    """Writes all pages below a folder; template(root, link, title, body, text) is the page of the program."""
    pages = list(pages_of(program, work))
    for i, page in enumerate(pages):
        root = "../" * page.path.count("/")
        text = template(root, html.escape(page.link), page.title,
                        body(page, pages[i - 1] if i else None, pages[i + 1] if i + 1 < len(pages) else None),
                        f'<div class="page">{page.text}</div>')
        assert len(text.encode()) <= kMostBytes, f"{page.path}: {len(text.encode())} bytes, at most {kMostBytes}"
        (folder / page.path).mkdir(parents=True)
        (folder / page.path / "index.html").write_text(text)
    return pages
