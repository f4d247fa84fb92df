#!/usr/bin/env bash
# Builds the documentation as a static site; a broken internal link stops the build.
#
#   packaging/site.sh PYTHON [OUT]
#
# mkdocs is installed in a separate environment, build/docs-env, as the program does not need it.
set -euo pipefail
cd "$(dirname "$0")/.."
python=$1 out=$(realpath -m "${2:-build/site}") environment=build/docs-env

if ! "$environment/bin/python" -c "import mkdocstrings" 2>/dev/null; then
    "$python" -m venv --clear $environment
    $environment/bin/python -m pip --disable-pip-version-check install --quiet "mkdocs==1.6.1" \
        "mkdocstrings==1.0.8" "mkdocstrings-python==2.0.11"
fi
$environment/bin/mkdocs --quiet build --strict --clean --site-dir "$out"
# Pages opened from disk can load scripts, but not JSON (docs/site/search_from_disk.js).
{ printf 'window.glovetrackIndex = ' && cat "$out/search/search_index.json"; } >"$out/search/index_on_disk.js"
echo "The documentation: $out/index.html"
