"""Applications of a tracked hand, and the public interface to write new ones.

An application receives a hand (`hand.HandSample`) and returns a drawing (`drawing`), events and
commands to devices (`interface`). It uses no thread, clock or window, so the same hands give the
same drawing bit for bit. See docs/applications.md in this folder.
"""
