#!/usr/bin/env bash
# Packs the bundle of packaging/bundle.sh as a Debian package and as a tar.gz to unpack anywhere.
#
#   packaging/debian.sh [FOLDER]
#
# FOLDER contains glovetrack/ and receives both files (default: dist).
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
out=${1:-dist}
ours=packaging/debian
bundle=$out/glovetrack
[ -x "$bundle/glovetrack" ] || { echo "$bundle is not built: run make package." >&2 && exit 1; }

version=$("$bundle/glovetrack" --version | cut -d' ' -f2)
architecture=$(dpkg --print-architecture)
name=glovetrack_${version}_$architecture
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
chmod 755 "$root" # mktemp makes it private, but it becomes the package's /

echo "Packing $out/$name.deb"
install -d "$root"/{DEBIAN,opt,usr/bin}
cp -a "$bundle" "$root/opt/glovetrack"
find "$root/opt" -name __pycache__ -prune -exec rm -rf {} +
ln -s /opt/glovetrack/glovetrack "$root/usr/bin/glovetrack"
install -Dm644 $ours/glovetrack.desktop -t "$root/usr/share/applications"
install -Dm644 $ours/glovetrack.xml -t "$root/usr/share/mime/packages"
install -Dm644 resources/udev/70-glovetrack.rules -t "$root/usr/lib/udev/rules.d"
install -Dm644 resources/icons/glovetrack.svg -t "$root/usr/share/icons/hicolor/scalable/apps"
install -Dm644 resources/icons/glovetrack.png -t "$root/usr/share/icons/hicolor/256x256/apps"
install -Dm644 "$bundle/LICENCES.txt" "$root/usr/share/doc/glovetrack/copyright"
install -Dm644 $ours/glovetrack.1 -t "$root/usr/share/man/man1"
gzip -9n "$root/usr/share/man/man1/glovetrack.1"
install -m755 $ours/postinst $ours/postrm -t "$root/DEBIAN"
sed -e "s/@VERSION@/$version/" -e "s/@ARCHITECTURE@/$architecture/" \
    -e "s/@SIZE_KB@/$(du -sk "$root/opt" | cut -f1)/" $ours/control >"$root/DEBIAN/control"
nice dpkg-deb --root-owner-group -Zzstd -z9 --build "$root" "$out/$name.deb" >/dev/null

echo "Packing $out/$name.tar.gz"
nice tar -C "$root/opt" --owner=0 --group=0 --sort=name --mtime="@$SOURCE_DATE_EPOCH" -c glovetrack |
    nice gzip -6 -n >"$out/$name.tar.gz"
du -m "$out/$name".*
