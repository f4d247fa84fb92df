#!/usr/bin/env bash
# Packs the bundle of packaging/bundle.sh as a type 2 AppImage: one executable file.
#
#   packaging/appimage.sh RUNTIME [FOLDER]
#
# RUNTIME is the small program in front of the image, which no package registry provides:
# runtime-x86_64 of github.com/AppImage/type2-runtime, downloaded or built from its source. FOLDER
# contains glovetrack/ and receives the file (default: dist). Requires mksquashfs (squashfs-tools).
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
runtime=$(realpath "${1:?the runtime is missing: see packaging/README.md}") out=${2:-dist}
bundle=$out/glovetrack
refuse() { echo "$1" >&2 && exit 1; }
[ -x "$bundle/glovetrack" ] || refuse "$bundle is not built: run make package."
command -v mksquashfs >/dev/null || refuse "mksquashfs is missing: apt-get install squashfs-tools"
# The specification requires these three bytes in the padding of the ELF header.
[ "$(head -c 11 "$runtime" | tail -c 3 | od -An -tx1 | tr -d ' ')" = 414902 ] ||
    refuse "$runtime is not a type 2 AppImage runtime."

version=$("$bundle/glovetrack" --version | cut -d' ' -f2)
name=Glovetrack-$version-$(uname -m).AppImage
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root
mkdir -p "$root/usr/share/icons/hicolor/256x256/apps"
echo "Packing $out/$name"
cp -a "$bundle" "$root/glovetrack"
find "$root/glovetrack" -name __pycache__ -prune -exec rm -rf {} +
ln -s glovetrack/glovetrack "$root/AppRun"
install -m644 packaging/debian/glovetrack.desktop resources/icons/glovetrack.svg -t "$root"
install -m644 resources/icons/glovetrack.png -t "$root/usr/share/icons/hicolor/256x256/apps"
ln -s usr/share/icons/hicolor/256x256/apps/glovetrack.png "$root/.DirIcon"
cat >>"$root/glovetrack/LICENCES.txt" <<'LICENCES'

AppImage's runtime, in front of this program's files: MIT. It contains squashfuse (BSD-2-Clause),
libfuse (LGPL-2.1), zstd (BSD-3-Clause), zlib (Zlib) and mimalloc (MIT); its source and theirs:
https://github.com/AppImage/type2-runtime
LICENCES
nice mksquashfs "$root" "$work/image" -comp zstd -Xcompression-level 9 -b 1M -all-root -no-xattrs \
    -noappend -no-progress -quiet >/dev/null # dates come from SOURCE_DATE_EPOCH
cat "$runtime" "$work/image" >"$out/$name"
chmod 755 "$out/$name"
du -m "$out/$name"
