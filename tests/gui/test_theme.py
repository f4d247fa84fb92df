"""Dressing the application."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

COLLECTED_MEANWHILE = """
import gc
from PySide6.QtWidgets import QApplication, QLabel, QWidget
from app.window import theme

class Collector(QWidget):
    def changeEvent(self, event):
        if gc.isenabled():
            gc.collect()  # which an allocation may set off at any time
        super().changeEvent(event)

app = QApplication([])
collectors = [Collector() for _ in range(20)]
for widget in collectors:
    widget.show()
gc.set_threshold(1_000_000)
for _ in range(300):
    label = QLabel("in a ring that only the collector frees")
    label.ring = label
    label.show()
del label
theme.apply(app, "dark")
assert gc.isenabled()
assert len(app.allWidgets()) == 320
gc.collect()
print(len(app.allWidgets()))
"""


def test_the_garbage_collector_does_not_free_widgets_that_are_being_dressed():
    done = subprocess.run(
        [sys.executable, "-c", COLLECTED_MEANWHILE], cwd=ROOT, capture_output=True, text=True
    )  # the environment has QT_QPA_PLATFORM
    assert (done.returncode, done.stdout.strip()) == (0, "20"), done.stderr
