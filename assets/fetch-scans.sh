#!/usr/bin/env bash
# Takes scanned point sets with normals out of Debian's package libcgal-demo (24 MB) into
# assets/scans/, without installing it. See assets/README.md for what they are.
set -euo pipefail
cd "$(dirname "$0")"

# Here : in the package.
files=(
    kitten.xyz:data/points_3/kitten.xyz
    oni.xyz:data/points_3/oni.pwn
    sphere_even.xyz:data/points_3/sphere_1k.xyz
    sphere_noisy.xyz:data/points_3/sphere_20k_normal.xyz
    fin90.xyz:data/points_3/fin90_with_PCA_normals.xyz
    hippo.ply:data/points_3/hippo1.ply
)
archive=/usr/share/doc/libcgal-dev/data.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if [ ! -f "$archive" ]; then
    echo "fetching Debian's libcgal-demo (24 MB)"
    command -v apt-get >/dev/null || { echo "only Debian systems have this package" >&2; exit 1; }
    # apt wants to drop its rights to the user _apt, who may not write to our folder.
    (cd "$work" && apt-get -o APT::Sandbox::User=root -q download libcgal-demo)
    dpkg-deb -x "$work"/libcgal-demo_*.deb "$work"
    archive=$work/usr/share/doc/libcgal-dev/data.tar.gz
fi
mkdir -p "$work/data" scans
tar -xzf "$archive" -C "$work" "${files[@]#*:}"
for file in "${files[@]}"; do
    mv "$work/${file#*:}" "scans/${file%%:*}"
    echo "assets/scans/${file%%:*}"
done
