"""A simulated stereo camera in real time: images arrive when those of a device would.

They are drawn in a separate process, comparable to a camera's own hardware, and transferred through
shared memory. It draws ahead of time where possible; an image that is not ready in time is dropped,
as by a camera, and leaves a gap in ``index``.
"""

from __future__ import annotations

import contextlib
import time
from collections import deque
from collections.abc import Sequence
from itertools import islice
from multiprocessing.connection import Connection
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.child import start_child
from tracker.base.clock import nanoseconds, seconds
from tracker.base.notices import warning
from tracker.base.shared_memory import attached, forget_name, new_memory
from tracker.messages import Event, StereoFrame
from tracker.sensors.sources import NoCamera
from tracker.simulation.demo import DemoSpec, ask, build_scene
from tracker.simulation.posture_requests import PostureRequest, request_event
from tracker.simulation.stamps import JitteredStamps

SLOTS = 6
READY = "ready"
AHEAD = 0.01  # s before their arrival, when images drawn in advance are sent
LATE = 0.06  # s after its arrival time, when an image is no longer drawn


class _Drawn(NamedTuple):
    """An image in shared memory. Times in s since the start of the simulation."""

    slot: int
    number: int
    t: float
    arrival: float


class SimulatedCamera:
    """Images of a `DemoSpec` in real time, from `begin` on. Raises NoSharedMemory.

    The process needs one or two seconds to get ready, during which others may start as well. With
    ``drawn`` it first draws that many images, sends these, which then costs no more than a hardware
    camera, and ends.
    """

    def __init__(
        self, spec: DemoSpec, width: int = 1280, height: int = 720, drawn: int = 0
    ) -> None:
        cameras = 1 if spec.one_camera else 2
        self._t_0, self._shape = 0.0, (drawn or SLOTS, cameras, height, width, 3)
        self._memory = new_memory(int(np.prod(self._shape)))
        self._events: list[Event] = []
        self._asked: deque[PostureRequest] = (
            deque()
        )  # requests of other threads, sent by the reading thread
        self._closed = False
        self._pipe, self._process = start_child(
            "glovetrack-camera", _draw_on_demand, spec, self._memory.name, self._shape, drawn
        )

    def wait_ready(self, timeout: float) -> bool:
        """Whether the first image was drawn within ``timeout`` s. Call it once."""
        try:
            return self._pipe.poll(timeout) and self._pipe.recv() == READY
        except (EOFError, OSError):
            return False

    def begin(self, t_0: float) -> None:
        """Set simulated time 0 to the host's ``t_0`` (s)."""
        self._t_0 = t_0
        with contextlib.suppress(OSError):
            self._pipe.send(t_0)

    def ask(self, request: PostureRequest, pose: str) -> None:
        """Make the wearer assume a posture, that of ``pose`` or (empty) their own; an event is
        recorded as part of the ground truth."""
        self._asked.append(request)
        self._events.append(request_event(request, pose, seconds(time.monotonic_ns())))

    def read(self, timeout: float) -> StereoFrame | None:
        """The next image pair at its time of arrival; None if none arrives within ``timeout``."""
        if self._closed:
            time.sleep(timeout)  # keeps callers from polling without pause
            return None
        try:
            while self._asked:
                self._pipe.send(self._asked.popleft())
            if not self._pipe.poll(timeout):
                return None
            drawn: _Drawn = self._pipe.recv()
        except (EOFError, OSError):
            self._lost()
            return None
        due = self._t_0 + drawn.arrival
        wait = due - time.monotonic()
        if wait > 0:
            time.sleep(min(wait, 1.0))
        frame = self._frame(drawn, max(due, seconds(time.monotonic_ns())))
        with contextlib.suppress(OSError):  # the process has ended: the next call reports it
            self._pipe.send(drawn.slot)
        return frame

    def _frame(self, drawn: _Drawn, arrival: float) -> StereoFrame:
        images = self._view()[drawn.slot]
        return StereoFrame(
            t=seconds(nanoseconds(self._t_0 + drawn.t)),
            t_arrival=seconds(nanoseconds(arrival)),
            left=images[0].copy(),
            right=images[1].copy() if len(images) == 2 else None,
            index=drawn.number,
        )

    def _view(self) -> NDArray[np.uint8]:
        return np.ndarray(self._shape, np.uint8, buffer=self._memory.buf)

    def _lost(self) -> None:
        if not self._closed:
            self._events.append(
                Event.of(seconds(time.monotonic_ns()), "device", warning("simulation.camera_ended"))
            )
            self.close()

    def drain_events(self) -> Sequence[Event]:
        out, self._events = self._events, []
        return out

    def close(self) -> None:
        """End the process and free the memory. Idempotent."""
        if self._closed:
            return
        self._closed = True
        self._pipe.close()
        self._process.terminate()
        self._process.join(5.0)
        forget_name(self._memory)  # if the process ended before it attached
        self._memory.close()


class NoSimulatedCamera(NoCamera):
    """Replaces the camera if a wearer is simulated without one; reports the wearer's events."""

    def __init__(self) -> None:
        super().__init__()
        self._events: list[Event] = []

    def wait_ready(self, timeout: float) -> bool:
        """Returns True immediately."""
        return True

    def begin(self, t_0: float) -> None:
        """Does nothing."""

    def ask(self, request: PostureRequest, pose: str) -> None:
        """As `SimulatedCamera.ask`, for the recording only."""
        self._events.append(request_event(request, pose, seconds(time.monotonic_ns())))

    def drain_events(self) -> Sequence[Event]:
        out, self._events = self._events, []
        return out


DemoCamera = SimulatedCamera | NoSimulatedCamera


def _draw_on_demand(
    pipe: Connection, spec: DemoSpec, name: str, shape: tuple[int, ...], drawn: int
) -> None:
    """The other process: draws until the pipe is closed, or draws all images first."""
    memory = attached(name)
    try:
        images: NDArray[np.uint8] = np.ndarray(shape, np.uint8, buffer=memory.buf)
        (_draw_in_advance if drawn else _draw)(spec, images, pipe)
    except (EOFError, BrokenPipeError, ConnectionResetError, KeyboardInterrupt):
        return
    finally:
        del images
        memory.close()


def _draw(spec: DemoSpec, images: NDArray[np.uint8], pipe: Connection) -> None:
    sim = build_scene(spec)
    sim.renderer.images(0.1)  # compiles the kernels
    pipe.send(READY)
    t_0: float = pipe.recv()
    free = list(range(len(images)))
    stamps = JitteredStamps(sim.params.stamp_jitter, sim.seed)
    for index, t, arrival in sim.exposures():
        if time.monotonic() > t_0 + arrival + LATE:
            continue
        while not free or pipe.poll():
            item = pipe.recv()
            if isinstance(item, PostureRequest):
                ask(sim, item)
            else:
                free.append(item)
        slot = free.pop(0)
        if spec.right_late:
            sim.renderer.images(t + spec.right_late, list(images[slot]))
            images[slot][0] = sim.renderer.images(t)[0]
        else:
            sim.renderer.images(t, list(images[slot]))
        pipe.send(_Drawn(slot, index, stamps.stamp(t), arrival))


def _draw_in_advance(spec: DemoSpec, images: NDArray[np.uint8], pipe: Connection) -> None:
    """Draws as many images as there are buffers, then sends each at its time."""
    sim = build_scene(spec)
    stamps, drawn = JitteredStamps(sim.params.stamp_jitter, sim.seed), []
    for slot, (index, t, arrival) in enumerate(islice(sim.exposures(), len(images))):
        sim.renderer.images(t, list(images[slot]))
        drawn.append(_Drawn(slot, index, stamps.stamp(t), arrival))
    pipe.send(READY)
    t_0: float = pipe.recv()
    for one in drawn:
        time.sleep(max(t_0 + one.arrival - AHEAD - time.monotonic(), 0.0))
        while pipe.poll():
            pipe.recv()  # released buffers and requests, which are too late
        pipe.send(one)
