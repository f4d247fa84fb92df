"""Applications of a tracked hand, and the public interface to write new ones.

An application takes a hand (`hand.HandSample`) and returns what is to be drawn (`drawing`), what
happened and what devices are to do (`interface`). It knows no thread, no clock
and no window, so the same hands give the same drawing bit for bit. See docs/applications.md here.
"""
