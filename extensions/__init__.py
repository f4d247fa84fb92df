"""Extensions of the program, one folder each: its engine side, its command, its panel, its tests.

An extension is attached through the registries that other packages use (`tracker.base.registry`).
The core (`tracker`, `app`) imports none of them, and works with any of these folders removed. Only
an extension's ``window`` folder imports Qt.
"""
