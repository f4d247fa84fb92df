"""The Glovetrack window: reads the engine's messages and never computes tracking."""

import os

# pyqtgraph and superqt must both pick the one binding that is installed.
os.environ.setdefault("QT_API", "pyside6")
os.environ.setdefault("PYQTGRAPH_QT_LIB", "PySide6")
