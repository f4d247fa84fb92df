"""The filter's code and docs/chain.md refer to the same equations."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
FUSION = ROOT / "tracker" / "fusion"
BESIDE = ("kalman.py", "time/timeline.py", "output/output.py", "../online/rig_alignment.py")
BESIDE += ("../vision/finger_cloth.py", "../vision/cloth_depth.py")


def numbered_in_page() -> list[int]:
    """Numbers at the ends of lines within code blocks, in their order."""
    blocks = re.findall(r"^```\n(.*?)^```", (ROOT / "docs/chain.md").read_text(), re.M | re.S)
    return [int(n) for block in blocks for n in re.findall(r"\((\d+)\)$", block, re.M)]


def named_in_code() -> set[int]:
    out: set[int] = set()
    for path in [*(FUSION / "chain").rglob("*.py"), *(FUSION / name for name in BESIDE)]:
        text = re.sub(r"\s+#?\s*", " ", path.read_text())
        text = re.sub(r"Lemak et al\. 2020 \([^)]*\)", "", text)
        for first, word, last in re.findall(r"\beqs?\. (\d+)(?: (to|and) (\d+))?", text):
            ends = int(first), int(last or first)
            out |= set(range(ends[0], ends[1] + 1)) if word == "to" else set(ends)
    return out


def test_equations_of_the_page_are_numbered_in_order() -> None:
    numbers = numbered_in_page()
    assert numbers == list(range(1, len(numbers) + 1))


def test_code_refers_to_every_equation_except_the_notation() -> None:
    assert named_in_code() == set(numbered_in_page()) - {1}
