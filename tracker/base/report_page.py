"""HTML pages of reports: one style, tables, and a document that needs no other file."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 75em; padding: 0 1em;
  color: #222; background: #fff }
table { border-collapse: collapse; margin: .6em 0 1.4em; font-variant-numeric: tabular-nums }
th, td { padding: .15em .6em; text-align: right; border-bottom: 1px solid #ddd;
  white-space: nowrap }
th:first-child, td:first-child { text-align: left }
thead th { border-bottom: 2px solid #888; vertical-align: bottom }
.wide { overflow-x: auto } svg { max-width: 100%; height: auto } .note { color: #555 }
.key { display: inline-block; width: 1em; height: .9em; vertical-align: -.1em }
.quote { font-size: 1.15em; border-left: 4px solid #0072b2; padding: .3em 1em }
.warning { background: #f4e3b2; padding: .2em .8em }
@media print { .wide { overflow: visible } body { font-size: 10px } }
"""


def html_page(title: str, parts: Sequence[str]) -> str:
    """The document with these elements one after the other; the title is plain text."""
    body = "\n".join(parts)
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f"<title>{escape(title)}</title><style>{_STYLE}</style></head>\n"
        f"<body>{body}\n</body></html>\n"
    )


def html_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of plain texts, which scrolls sideways where the page is narrow."""
    top = "".join(f"<th>{escape(h)}</th>" for h in head)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(c)}</td>" for c in row) + "</tr>\n" for row in rows
    )
    return f'<div class="wide"><table><thead><tr>{top}</tr></thead>\n{body}</table></div>'
