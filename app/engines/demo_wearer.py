"""The demo's wearer follows the guidance, as a real one would."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from tracker.hand.names import FINGERS
from tracker.simulation.asked import AHEAD, MOVE, Asked
from tracker.simulation.camera_device import DemoCamera
from tracker.simulation.demo import ask
from tracker.simulation.gestures import gesture_angles
from tracker.simulation.glove_process import GloveProcess
from tracker.simulation.guided import HeldHand, HoldParams
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for

TURNING = 6.0  # s in which the wrist turns from one side to the other and back


class GuidedWearer:
    """Moves the hand that the simulated glove and camera see. ``clock`` gives s of simulated time.

    Poses are solved on a thread: a pinch takes about a second.
    """

    def __init__(
        self,
        simulation: Simulation,
        devices: tuple[DemoCamera, GloveProcess],
        clock: Callable[[], float],
    ) -> None:
        self._simulation, self._clock = simulation, clock
        self._camera, self._worn = devices
        rng = rng_for(simulation.seed, "postures asked for")
        self._held = HeldHand(simulation.wearer, HoldParams(), rng)
        self._gestures: dict[str, tuple[float, ...]] = {}
        self._thread = ThreadPoolExecutor(1, "glovetrack-demo-guide")

    def show(self, pose: str) -> None:
        """Take the pose within about two seconds; empty: resume the motion."""
        self._thread.submit(self._ask, pose)

    def show_gesture(self, gesture: str) -> None:
        """Make the gesture within about 2.5 s; empty: resume the motion."""
        self._thread.submit(self._ask_gesture, gesture)
        if not self._gestures:  # a pinch takes a second to solve: start before it is needed
            for finger in FINGERS:
                self._thread.submit(self._gesture, f"pinch_{finger}")

    def _gesture(self, name: str) -> tuple[float, ...]:
        """(J,) rad."""
        if name not in self._gestures:
            hand, wearer = self._simulation.hand, self._simulation.wearer
            angles = gesture_angles(hand, name, wearer)
            self._gestures[name] = tuple(angles.tolist())
        return self._gestures[name]

    def _ask_gesture(self, gesture: str) -> None:
        angles = self._gesture(gesture) if gesture else ()
        turning = TURNING if gesture == "turn" else 0.0
        self._send(Asked(self._clock() + AHEAD, angles, turning), gesture)

    def _ask(self, pose: str) -> None:
        then = self._clock() + AHEAD + MOVE
        angles = tuple(self._held.angles(pose, then).tolist()) if pose else ()
        self._send(Asked(self._clock() + AHEAD, angles), pose)

    def _send(self, asked: Asked, pose: str) -> None:
        ask(self._simulation, asked)
        self._worn.ask(asked)
        self._camera.ask(asked, pose)

    def close(self) -> None:
        """End the thread."""
        self._thread.shutdown(wait=True, cancel_futures=True)
