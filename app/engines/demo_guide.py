"""The demo's wearer does what the guidance shows, as a real one would."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from app.engines.guide import HoldingEngine, WearersGuide
from tracker.simulation.asked import AHEAD, MOVE, Asked
from tracker.simulation.camera_device import DemoCamera
from tracker.simulation.demo import ask
from tracker.simulation.glove_process import GloveProcess
from tracker.simulation.guided import HeldHand, HoldParams
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for


class DemoGuide(WearersGuide):
    """Tells glove and camera alike. ``clock`` gives s of the simulation's time.

    How the wearer comes to touch his fingertips is found in a thread: that takes a moment.
    """

    def __init__(
        self,
        engine: HoldingEngine,
        simulation: Simulation,
        devices: tuple[DemoCamera, GloveProcess],
        clock: Callable[[], float],
    ) -> None:
        super().__init__(engine)
        self._simulation, self._clock = simulation, clock
        self._camera, self._worn = devices
        rng = rng_for(simulation.seed, "postures asked for")
        self._held = HeldHand(simulation.wearer, HoldParams(), rng)
        self._thread = ThreadPoolExecutor(1, "glovetrack-demo-guide")

    def show(self, pose: str) -> None:
        """He comes to it in about two seconds, or (empty) goes on as before."""
        self._thread.submit(self._ask, pose)

    def _ask(self, pose: str) -> None:
        then = self._clock() + AHEAD + MOVE
        angles = tuple(self._held.angles(pose, then).tolist()) if pose else ()
        asked = Asked(self._clock() + AHEAD, angles)
        ask(self._simulation, asked)
        self._worn.ask(asked)
        self._camera.ask(asked, pose)

    def close(self) -> None:
        """Nothing more is shown."""
        self._thread.shutdown(wait=True, cancel_futures=True)
