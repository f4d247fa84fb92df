#!/usr/bin/env bash
# Builds the program without a need for Python: dist/glovetrack with the licences of all its parts.
#
#   packaging/bundle.sh VENV [OUT]
#
# OUT is the folder that gets glovetrack/ (default: dist).
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
python=$1/bin/python out=${2:-dist}
work=build/pyinstaller

if ! "$python" -c 'import PyInstaller' 2>/dev/null; then
    "$python" -m pip --disable-pip-version-check install --quiet --no-build-isolation \
        --editable ".[packaging]"
fi

make --no-print-directory firmware >/dev/null # its image goes along
packaging/kernels.sh "$1"
packaging/site.sh "$python" # Help shows it
echo "Building $out/glovetrack (some minutes)"
nice "$python" -m PyInstaller --noconfirm --log-level ERROR \
    --distpath "$out" --workpath "$work" packaging/glovetrack.spec

inside=$out/glovetrack/_internal
# Symbol tables and debugging data make a seventh of the bundle. The libraries that auditwheel has
# rewritten (those in *.libs folders) do not survive strip, so they are left alone.
if command -v strip >/dev/null; then
    find "$inside" -type f \( -name '*.so' -o -name '*.so.[0-9]*' \) ! -path '*.libs/*' \
        ! -path '*/cv2/*' -exec strip --strip-unneeded {} +
fi

"$python" packaging/licences.py "$work/glovetrack" "$inside" >"$out/glovetrack/LICENCES.txt"
"$out/glovetrack/glovetrack" --version
du -sm "$out/glovetrack" | sed 's/\t.*/ MB/'
