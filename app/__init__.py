"""The Glovetrack window: reads the engine's messages and never computes tracking."""

import os

from tracker.base.numeric_threads import limit_this_process

# pyqtgraph and superqt must both pick the one binding that is installed.
os.environ.setdefault("QT_API", "pyside6")
os.environ.setdefault("PYQTGRAPH_QT_LIB", "PySide6")

limit_this_process()  # before numpy is imported; processes that this one starts inherit it
