"""A simulated glove and camera that deliver in real time what a `Simulation` holds."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tracker.clock import nanoseconds, seconds
from tracker.messages import Event, ImuSample, StereoFrame
from tracker.simulation.scenario import Simulation


class SimulatedClock:
    """The simulation's time 0 on the host's monotonic clock, fixed when it is first asked."""

    def __init__(self) -> None:
        self._zero_ns: int | None = None

    @property
    def zero_ns(self) -> int:
        if self._zero_ns is None:
            self._zero_ns = time.monotonic_ns()
        return self._zero_ns

    def host(self, t: float) -> float:
        """A simulated time on the host's clock."""
        return seconds(nanoseconds(t) + self.zero_ns)

    def simulated(self, t: float) -> float:
        return seconds(nanoseconds(t) - self.zero_ns)

    def wait(self, t: float, timeout: float) -> bool:
        """Sleep until the host time ``t``, at most ``timeout`` s; whether it has come."""
        left = t - time.monotonic()
        if left > 0:
            time.sleep(min(left, timeout))
        return left <= timeout


class PacedGlove:
    """Packets of a simulation at the instants at which they arrive."""

    def __init__(self, samples: Iterator[ImuSample], clock: SimulatedClock) -> None:
        self._samples, self._clock = samples, clock
        self._next: ImuSample | None = next(samples, None)

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        """All packets that are due, after waiting for the first of them."""
        if self._next is None:
            time.sleep(timeout)
            return []
        if not self._clock.wait(self._clock.host(self._next.t_arrival), timeout):
            return []
        out: list[ImuSample | Event] = []
        now = time.monotonic()
        while self._next is not None and self._clock.host(self._next.t_arrival) <= now:
            out.append(self._on_host(self._next))
            self._next = next(self._samples, None)
        return out

    def _on_host(self, s: ImuSample) -> ImuSample:
        clock = self._clock
        return replace(s, t=clock.host(s.t), t_arrival=clock.host(s.t_arrival))

    def close(self) -> None:
        self._next = None


class PacedCamera:
    """Pictures of a simulation, rendered when they are due; late ones are skipped."""

    def __init__(self, simulation: Simulation, clock: SimulatedClock) -> None:
        self._simulation, self._clock = simulation, clock
        self._exposures = simulation.exposures()
        self._next = next(self._exposures, None)

    def read(self, timeout: float) -> StereoFrame | None:
        """The next picture pair at its arrival; None if none is due within ``timeout`` s."""
        while self._next is not None:
            index, t, arrival = self._next
            if self._clock.host(arrival) - time.monotonic() > timeout:
                time.sleep(timeout)
                return None
            self._next = next(self._exposures, None)
            if self._clock.host(arrival) < time.monotonic() - 1 / self._simulation.fps:
                continue
            return self._picture(index, t, arrival)
        time.sleep(timeout)
        return None

    def _picture(self, index: int, t: float, arrival: float) -> StereoFrame:
        """Rendered in the time between exposure and arrival, as a camera would be busy."""
        frame = self._simulation.renderer.frame(t, arrival, index)
        self._clock.wait(self._clock.host(arrival), 1.0)
        due = max(self._clock.host(arrival), seconds(time.monotonic_ns()))
        return replace(frame, t=self._clock.host(t), t_arrival=due)

    def take_events(self) -> Sequence[Event]:
        return ()

    def close(self) -> None:
        self._next = None
