"""A hook of mkdocs: adds the pages of extensions (`extensions/NAME/docs`) to those of `docs`.

In the tree, a page links to another by its path, so that links work where the files are browsed.
The site has all pages in one folder, so such links are shortened.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parents[1]
PLACES = re.compile(r"(?:\.\./)+(extensions/\w+/docs|docs)/")


def on_files(files: Files, config: Any, **_unused: Any) -> Files:
    """Add the extensions' pages."""
    for page in sorted(ROOT.glob("extensions/*/docs/*")):
        files.append(File(page.name, str(page.parent), config.site_dir, config.use_directory_urls))
    return files


def on_page_markdown(markdown: str, page: Any, **_unused: Any) -> str:
    """Change links between folders of the tree to links within the site."""
    depth = page.file.src_uri.count("/")
    return PLACES.sub("../" * depth, markdown)
