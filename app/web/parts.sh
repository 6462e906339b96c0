#!/usr/bin/env bash
# The libraries of the browser build, from Debian: headers as its packages install them, and the
# sources of those that have to be compiled. For build.sh.
#   parts.sh FOLDER     fills FOLDER with include/, sources/ and fonts/; returns quickly if it is full
set -euo pipefail
parts=$(realpath -m "${1:?}")
root=$(cd "$(dirname "$0")/../.." && pwd)
stamp=$parts/complete
wanted=$(cat "$0" "$root/app/web/subset_fonts.py" | sha256sum)
[ "$(cat "$stamp" 2>/dev/null)" != "$wanted" ] || exit 0

rm -rf "$parts"
mkdir -p "$parts"/{include,sources,fonts,apt/{parts,lists/partial}}

# Headers alone. Not all of /usr/include: it holds another C library.
for library in glm fmt CLI nlohmann toml++ stb GLFW; do
    cp -R "/usr/include/$library" "$parts/include/"
done

# Sources of the packages that are installed here, with their patches.
cd "$parts/apt"
cat >parts/sources.sources <<'SOURCES'
Types: deb-src
URIs: http://deb.debian.org/debian
Suites: bookworm
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
apt=(apt-get -qq -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$PWD/parts"
    -o "Dir::State::Lists=$PWD/lists" -o "Dir::Cache=$PWD" -o Acquire::Retries=3)
"${apt[@]}" update
for package in imgui zlib cmark; do
    "${apt[@]}" source "$package" >"$package.log" 2>&1 || { cat "$package.log" >&2; exit 1; }
    mv "$package"-*/ "$parts/sources/$package"
done

# Fonts: the characters of our own texts, and of names in Western Europe.
/usr/bin/python3 "$root/app/web/subset_fonts.py" "$parts/fonts" \
    /usr/share/fonts/opentype/inter/Inter-{Regular,SemiBold}.otf /usr/share/fonts/truetype/dejavu/DejaVuSans{,Mono}.ttf
rm -rf "$parts/apt"
echo "$wanted" >"$stamp"
