"""What a sheet of ``glovetrack print`` is made of: a plug-in under ``glovetrack.sheets``.

A `SheetKind` names a function from a hand, a glove and a paper to `Page`s and the title of the
file. A page is drawn in millimetres at true scale.
"""

from extensions.sheets.kinds import SheetKind
from extensions.sheets.page import MARGIN_MM, PAPERS_MM, Page
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

__all__ = ["MARGIN_MM", "PAPERS_MM", "GloveModel", "HandModel", "Page", "SheetKind"]
