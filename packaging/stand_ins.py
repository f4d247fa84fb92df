"""Small libraries that stand in for large ones of which the program needs next to nothing.

    python packaging/stand_ins.py BUNDLE

``BUNDLE`` is the folder with the program's libraries (``_internal``). Two are replaced, 74 MB
together:

- ICU's data (``libicudata``): Qt has the languages' data itself and asks ICU for legacy text
  encodings and for sorting by a language's rules. ICU's own answer for programs without them is
  an empty table, "stubdata", which is what is built here.
- OpenCV's copy of OpenBLAS: the few functions that OpenCV calls are passed on to SciPy's copy,
  where each has the same name behind ``scipy_``.

Needs a C compiler, readelf and nm. Linux on x86-64 and arm64; elsewhere nothing is replaced.
"""

from __future__ import annotations

import platform
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path

JUMP = {"x86_64": "jmp {}@PLT", "aarch64": "b {}"}
"""How a function passes itself on, arguments and all, per processor."""

SCIPY = "scipy_"

ICU_DATA = """
#include <stdint.h>
/* ICU's common data format: a header (unicode/udata.h), then a table of contents of no entries. */
const struct {{
    uint16_t header_size;
    uint8_t magic[2];
    struct {{
        uint16_t size, reserved;
        uint8_t big_endian, charset, size_of_uchar, reserved_byte;
        uint8_t format[4], format_version[4], data_version[4];
    }} info;
    uint8_t padding[8];
    uint32_t count, reserved;
}} __attribute__((aligned(16))) icudt{version}_dat = {{
    32, {{0xda, 0x27}}, {{20, 0, 0, 0, 2, 0, "ToCP", {{1}}, {{0}}}}, {{0}}, 0, 0
}};
"""


def forwards(names: Iterable[str], machine: str) -> str:
    """Assembly in which each function jumps to SciPy's of the same name."""
    lines = [".text"]
    for name in sorted(names):
        jump = JUMP[machine].format(SCIPY + name)
        lines += [f".globl {name}", f".type {name}, %function", f"{name}: {jump}"]
    return "\n".join([*lines, '.section .note.GNU-stack, "", %progbits', ""])


def symbols(library: Path, defined: bool) -> set[str]:
    """Names that a library offers to others, or asks of them."""
    which = "--defined-only" if defined else "--undefined-only"
    shown = subprocess.run(
        ["nm", "-D", "--without-symbol-versions", which, str(library)],
        capture_output=True,
        text=True,
        check=True,
    )
    return {line.split()[-1] for line in shown.stdout.splitlines() if line}


def build(source: str, kind: str, target: Path, *more: str) -> None:
    """Compile ``source`` (its file ending is ``kind``) in place of the library ``target``."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"source.{kind}"
        file.write_text(source, "utf-8")
        made = Path(folder) / target.name
        flags = ["-shared", "-nostdlib", "-s", f"-Wl,-soname,{target.name}"]
        subprocess.run(["cc", *flags, "-o", str(made), str(file), *more], check=True)
        target.write_bytes(made.read_bytes())


def replace_icu_data(bundle: Path) -> None:
    """An empty table in place of ICU's data."""
    for target in bundle.glob("PySide6/Qt/lib/libicudata.so.*"):
        build(ICU_DATA.format(version=target.suffix[1:]), "c", target)


def replace_opencv_blas(bundle: Path, machine: str) -> None:
    """SciPy's OpenBLAS for OpenCV too; nothing happens where SciPy's lacks what OpenCV needs."""
    offered = sorted(bundle.glob("scipy.libs/libscipy_openblas-*.so"))
    module = sorted(bundle.glob("cv2/cv2*.so"))
    if len(offered) != 1 or len(module) != 1:
        return
    known, asked = symbols(offered[0], True), symbols(module[0], False)
    for target in bundle.glob("opencv_python_headless.libs/libopenblas*.so"):
        names = symbols(target, True) & asked
        if {SCIPY + n for n in names} <= known:
            rpath = f"-Wl,-rpath,$ORIGIN/../{offered[0].parent.name}"
            build(forwards(names, machine), "s", target, str(offered[0]), rpath)


def main(bundle: Path) -> int:
    """Replace what can be replaced; 0."""
    machine = platform.machine()
    if sys.platform.startswith("linux") and machine in JUMP:
        replace_icu_data(bundle)
        replace_opencv_blas(bundle, machine)
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
