"""Tracking in a process of its own, which the window uses like an engine in its own process.

All threads of a process share Python's lock, so a window that draws delays tracking, and tracking
delays the window. Here the devices, tracking and the recorder belong to a child process
(`child.serve`); the window has representatives of them (`setup.apart_setup`) behind the interfaces
of `app.engines.protocols`. The child sends every estimate at once, and what is shown besides
(images, packets, status) at the rate of the window. A recording is written by the child and does
not depend on the window.
"""
