#!/usr/bin/env bash
# Builds the program with its own Python: dist/glovetrack, with the licences of all its parts.
#
#   packaging/bundle.sh VENV [OUT]
#
# OUT is the folder that receives glovetrack/ (default: dist).
set -euo pipefail
cd "$(dirname "$0")/.."
source packaging/epoch.sh
python=$1/bin/python out=${2:-dist}
work=build/pyinstaller

if ! "$python" -c 'import PyInstaller' 2>/dev/null; then
    "$python" -m pip --disable-pip-version-check install --quiet --no-build-isolation \
        --editable ".[packaging]"
fi

make --no-print-directory firmware >/dev/null # its image is part of the bundle
packaging/kernels.sh "$1"
packaging/openxr_layer.sh "$1"
packaging/site.sh "$python" # the Help menu opens it
echo "Building $out/glovetrack (takes several minutes)"
nice "$python" -m PyInstaller --noconfirm --log-level ERROR \
    --distpath "$out" --workpath "$work" packaging/glovetrack.spec

inside=$out/glovetrack/_internal
# Symbol tables and debugging data are one seventh of the bundle. strip breaks the libraries that
# auditwheel has rewritten (those in *.libs folders), so they are excluded.
if command -v strip >/dev/null; then
    find "$inside" -type f \( -name '*.so' -o -name '*.so.[0-9]*' \) ! -path '*.libs/*' \
        ! -path '*/cv2/*' -exec strip --strip-unneeded {} +
fi

"$python" packaging/licences.py "$work/glovetrack" "$inside" >"$out/glovetrack/LICENCES.txt"
"$out/glovetrack/glovetrack" --version
du -sm "$out/glovetrack" | sed 's/\t.*/ MB/'
