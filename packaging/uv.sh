#!/usr/bin/env bash
# Runs `uv pip` for an interpreter, with the package indexes of pip's configuration.
#
#   packaging/uv.sh PYTHON install|compile ...
#
# Uses uv from the PATH, or installs it with pip in a temporary folder.
set -euo pipefail
python=$1
verb=$2

uv_command() {
    if command -v uv; then return; fi
    "$python" -m pip --disable-pip-version-check install --quiet --target "$tools" uv \
        >/dev/null 2>&1 && echo "$tools/bin/uv"
}

pips_settings() { # pip's settings as options of uv, one argument per line
    "$python" -m pip config list | "$python" -c '
import ast, sys
OPTIONS = {"index-url": "--default-index", "extra-index-url": "--index", "find-links": "--find-links"}
for line in sys.stdin:
    name, _, value = line.strip().partition("=")
    if name.rpartition(".")[2] == "no-index" and ast.literal_eval(value) not in ("0", "false"):
        print("--no-index")
    option = OPTIONS.get(name.rpartition(".")[2])
    for word in ast.literal_eval(value).split() if option else []:
        print(option, word, sep="\n")
'
}

tools=$(mktemp -d)
trap 'rm -rf "$tools"' EXIT
uv=$(uv_command)
mapfile -t options < <(pips_settings)
certificates=$("$python" -m pip config get global.cert 2>/dev/null || true)
if [ -n "$certificates" ]; then export SSL_CERT_FILE=${SSL_CERT_FILE:-$certificates}; fi
"$uv" pip "$verb" --quiet --python "$python" --index-strategy unsafe-best-match \
    "${options[@]}" "${@:3}"
