#!/usr/bin/env bash
# Checks for the system packages that Glovetrack needs and that pip cannot install.
#
#   packaging/system_libraries.sh [app] [firmware] [firmware-tests] [openxr] [openxr-tests]
#
# As root on Debian or Ubuntu, it installs missing packages; otherwise it prints the command to run.
# It fails only if an essential package is still missing: without the packages marked "display", the
# application still runs off-screen, and without those marked "tests", some tests are skipped.
set -euo pipefail
PATH=$PATH:/usr/sbin:/sbin # location of ldconfig, which is not on every user's PATH

# probe                            package              needed
app_needs='
lib:libEGL.so.1                    libegl1              essential
lib:libEGL_mesa.so.0               libegl-mesa0         essential
lib:libGL.so.1                     libgl1               essential
lib:libGLX_mesa.so.0               libglx-mesa0         essential
lib:libX11.so.6                    libx11-6             essential
lib:libdbus-1.so.3                 libdbus-1-3          essential
lib:libfontconfig.so.1             libfontconfig1       essential
lib:libglib-2.0.so.0               libglib2.0-0         essential
lib:libstdc++.so.6                 libstdc++6           essential
lib:libxkbcommon.so.0              libxkbcommon0        essential
font:any                           fonts-dejavu-core    essential
lib:libX11-xcb.so.1                libx11-xcb1          display
lib:libxcb-cursor.so.0             libxcb-cursor0       display
lib:libxcb-icccm.so.4              libxcb-icccm4        display
lib:libxcb-image.so.0              libxcb-image0        display
lib:libxcb-keysyms.so.1            libxcb-keysyms1      display
lib:libxcb-randr.so.0              libxcb-randr0        display
lib:libxcb-render-util.so.0        libxcb-render-util0  display
lib:libxcb-shape.so.0              libxcb-shape0        display
lib:libxcb-xkb.so.1                libxcb-xkb1          display
lib:libxkbcommon-x11.so.0          libxkbcommon-x11-0   display
'
firmware_needs='
command:avr-gcc                    gcc-avr              essential
file:/usr/lib/avr/include/avr/io.h avr-libc             essential
file:/usr/include/simavr/sim_avr.h libsimavr-dev        essential
file:/usr/include/libelf.h         libelf-dev           essential
command:cc                         gcc                  essential
file:/usr/include/stdio.h          libc6-dev            essential
'
firmware_test_needs="${firmware_needs//essential/tests}
command:avrdude                    avrdude              tests
"

openxr_needs='
command:c++                        g++                  essential
file:/usr/include/openxr/openxr.h  libopenxr-dev        essential
'
validation=/usr/share/openxr/1/api_layers/explicit.d/XrApiLayer_core_validation.$HOSTTYPE-linux-gnu.json
openxr_test_needs="${openxr_needs//essential/tests}
lib:libopenxr_loader.so.1 libopenxr-loader1 tests
file:$validation openxr-layer-corevalidation tests
"

libraries=$(ldconfig -p 2>/dev/null || true)

is_there() { # kind:name
    local what=${1#*:}
    case $1 in
    lib:*) [[ $libraries == *"$what "* ]] ;;
    command:*) command -v "$what" >/dev/null ;;
    file:*) [ -e "$what" ] ;;
    font:*) [ -n "$(find -L /usr/share/fonts /usr/local/share/fonts ~/.fonts ~/.local/share/fonts \
        -name '*.[ot]t[fc]' -print -quit 2>/dev/null)" ] ;;
    esac
}

missing() { # table, level: prints one package per line
    local probe package needed
    while read -r probe package needed; do
        if [ "$needed" = "$2" ] && ! is_there "$probe"; then echo "$package"; fi
    done <<<"$(grep . <<<"$1")"
}

missing_of_any_level() {
    local level
    for level in essential display tests; do missing "$needs" $level; done | sort -u
}

install() { # packages
    export DEBIAN_FRONTEND=noninteractive
    apt-get update -qq && apt-get install -y -qq --no-install-recommends "$@"
}

needs=
for group in "${@:-app}"; do
    case $group in
    app) needs+=$app_needs ;;
    firmware) needs+=$firmware_needs ;;
    firmware-tests) needs+=$firmware_test_needs ;;
    openxr) needs+=$openxr_needs ;;
    openxr-tests) needs+=$openxr_test_needs ;;
    *) echo "unknown group $group: see the usage in $0" >&2 && exit 2 ;;
    esac
done

mapfile -t lacking < <(missing_of_any_level)
[ ${#lacking[@]} -eq 0 ] && exit 0

if [ "$(id -u)" -eq 0 ] && command -v apt-get >/dev/null; then
    echo "Installing system packages: ${lacking[*]}"
    install "${lacking[@]}" >/dev/null || echo "apt-get could not install the packages." >&2
    libraries=$(ldconfig -p 2>/dev/null || true)
    mapfile -t lacking < <(missing_of_any_level)
    [ ${#lacking[@]} -eq 0 ] && exit 0
fi

essential=$(missing "$needs" essential)
if [ -n "$essential" ]; then
    echo "System packages are missing. Run this command, then run make again:" >&2
elif [ -n "$(missing "$needs" display)" ]; then
    echo "The window needs more system packages (not needed off-screen):" >&2
else
    echo "Some tests need more system packages and are skipped without them:" >&2
fi
echo "    sudo apt-get update && sudo apt-get install -y --no-install-recommends ${lacking[*]}" >&2
[ -z "$essential" ]
