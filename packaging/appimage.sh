#!/usr/bin/env bash
# Packs the bundle that packaging/bundle.sh made as one file to run: an AppImage of type 2.
#
#   packaging/appimage.sh RUNTIME [FOLDER]
#
# RUNTIME is the small program in front of the image, which no package registry has: runtime-x86_64
# of github.com/AppImage/type2-runtime, downloaded or built there. FOLDER has glovetrack/ and gets
# the file (default: dist). Needs mksquashfs, Debian's squashfs-tools.
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
runtime=$(realpath "${1:?name the runtime: see packaging/README.md}") out=${2:-dist}
bundle=$out/glovetrack
refuse() { echo "$1" >&2 && exit 1; }
[ -x "$bundle/glovetrack" ] || refuse "$bundle is not built: run make package."
command -v mksquashfs >/dev/null || refuse "mksquashfs is missing: apt-get install squashfs-tools"
# The specification has these three bytes in the padding of the ELF header.
[ "$(head -c 11 "$runtime" | tail -c 3 | od -An -tx1 | tr -d ' ')" = 414902 ] ||
    refuse "$runtime is no AppImage runtime of type 2."

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

AppImage's runtime, in front of this program's files: MIT. It holds squashfuse (BSD-2-Clause),
libfuse (LGPL-2.1), zstd (BSD-3-Clause), zlib (Zlib) and mimalloc (MIT); its source and theirs:
https://github.com/AppImage/type2-runtime
LICENCES
nice mksquashfs "$root" "$work/image" -comp zstd -Xcompression-level 9 -b 1M -all-root -no-xattrs \
    -noappend -no-progress -quiet >/dev/null # its dates are SOURCE_DATE_EPOCH's
cat "$runtime" "$work/image" >"$out/$name"
chmod 755 "$out/$name"
du -m "$out/$name"
