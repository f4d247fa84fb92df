"""An OpenXR application for tests: it executes requests, one JSON object a line, on standard input.

It is another person's Python binding (pyopenxr) on the Khronos loader, in a process of its own, as
any application. ``python application.py debian`` takes the system's loader, ``own`` pyopenxr's.
"""

from __future__ import annotations

import ctypes
import json
import os
import sys
import time
import types
from collections.abc import Callable
from typing import Any


def use_system_loader() -> None:
    """Use the system's loader instead of pyopenxr's."""
    loader = ctypes.CDLL("libopenxr_loader.so.1")
    loader.xrLocateSpaces = loader["xrPollEvent"]  # OpenXR 1.1's, which pyopenxr binds; not called
    module = types.ModuleType("xr.library")
    module.openxr_loader_library = loader  # type: ignore[attr-defined]
    sys.modules["xr.library"] = module


LAYERS = os.environ.get("XR_API_LAYER_PATH")
if sys.argv[1] == "debian":
    use_system_loader()

import xr  # noqa: E402

if sys.argv[1] == "debian":
    del os.environ["XR_API_LAYER_PATH"]  # path of pyopenxr's own layers
    if LAYERS:
        os.environ["XR_API_LAYER_PATH"] = LAYERS

JOINTS = 26
HANDS = {"left": xr.HandEXT.LEFT, "right": xr.HandEXT.RIGHT}
SPACES = {
    "local": xr.ReferenceSpaceType.LOCAL,
    "view": xr.ReferenceSpaceType.VIEW,
    "stage": xr.ReferenceSpaceType.STAGE,
}
SOURCES = {"unobstructed": 1, "controller": 2}


class SourceInfo(ctypes.Structure):
    """XrHandTrackingDataSourceInfoEXT."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("next", ctypes.c_void_p),
        ("count", ctypes.c_uint32),
        ("sources", ctypes.POINTER(ctypes.c_int)),
    )


class SourceState(ctypes.Structure):
    """XrHandTrackingDataSourceStateEXT."""

    _fields_ = (
        ("type", ctypes.c_int),
        ("next", ctypes.c_void_p),
        ("is_active", ctypes.c_uint32),
        ("source", ctypes.c_int),
    )


class Application:
    """One instance and one headless session."""

    def __init__(self) -> None:
        self._spaces: dict[str, Any] = {}
        self._trackers: dict[str, Any] = {}

    def extensions(self) -> dict[str, int]:
        found = xr.enumerate_instance_extension_properties()
        return {e.extension_name.decode(): e.extension_version for e in found}

    def layers(self) -> list[str]:
        return [e.layer_name.decode() for e in xr.enumerate_api_layer_properties()]

    def open(self, extensions: list[str]) -> dict[str, object]:
        """An instance with these extensions; the system's properties."""
        info = xr.InstanceCreateInfo(
            application_info=xr.ApplicationInfo(
                application_name="Test application",
                api_version=xr.Version(1, 0, 20),
            ),
            enabled_extension_names=["XR_MND_headless", *extensions],
        )
        self._instance = xr.create_instance(info)
        self._system = xr.get_system(
            self._instance, xr.SystemGetInfo(xr.FormFactor.HEAD_MOUNTED_DISPLAY)
        )
        hands = xr.SystemHandTrackingPropertiesEXT()
        properties = xr.SystemProperties()
        if "XR_EXT_hand_tracking" in extensions:
            properties.next = ctypes.cast(ctypes.pointer(hands), ctypes.c_void_p)
        function = ctypes.cast(
            xr.get_instance_proc_addr(self._instance, "xrGetSystemProperties"),
            xr.PFN_xrGetSystemProperties,
        )
        check(function(self._instance, self._system, ctypes.byref(properties)))
        return {"supports": bool(hands.supports_hand_tracking)}

    def begin(self) -> list[int]:
        """A session that runs; the states through which it came."""
        self._session = xr.create_session(self._instance, xr.SessionCreateInfo(0, self._system))
        states = self.states()
        xr.begin_session(
            self._session, xr.SessionBeginInfo(xr.ViewConfigurationType.PRIMARY_STEREO)
        )
        for name, kind in SPACES.items():
            try:
                self._spaces[name] = xr.create_reference_space(
                    self._session, xr.ReferenceSpaceCreateInfo(kind)
                )
            except xr.ReferenceSpaceUnsupportedError:
                continue
        return states + self.states()

    def states(self) -> list[int]:
        """States of the session that are reported now."""
        out = []
        while True:
            try:
                event = xr.poll_event(self._instance)
            except xr.EventUnavailable:
                return out
            changed = ctypes.cast(
                ctypes.byref(event), ctypes.POINTER(xr.EventDataSessionStateChanged)
            ).contents
            out.append(int(changed.state))

    def track(self, hand: str, sources: list[str] | None = None) -> None:
        """A hand tracker, which accepts ``sources`` if there are any."""
        info = xr.HandTrackerCreateInfoEXT(HANDS[hand], xr.HandJointSetEXT.DEFAULT)
        if sources is not None:
            numbers = (ctypes.c_int * len(sources))(*(SOURCES[s] for s in sources))
            accepted = SourceInfo(1000428000, None, len(sources), numbers)
            info.next = ctypes.cast(ctypes.pointer(accepted), ctypes.c_void_p)
        handle = xr.HandTrackerEXT()
        function = self._function("xrCreateHandTrackerEXT", xr.PFN_xrCreateHandTrackerEXT)
        check(function(self._session, ctypes.byref(info), ctypes.byref(handle)))
        self._trackers[hand] = handle

    def locate(
        self,
        hand: str,
        time: int | None = None,
        base: str = "local",
        state: bool = False,
        velocities: bool = True,
        joints: int = JOINTS,
        repeat: int = 1,
    ) -> dict[str, object]:
        """The joints at an instant of CLOCK_MONOTONIC, ns (default: now); of the last of several
        calls, with the time s of each."""
        places = (xr.HandJointLocationEXT * joints)()
        moving = (xr.HandJointVelocityEXT * joints)()
        velocity = xr.HandJointVelocitiesEXT(joint_velocities=moving)
        found = SourceState(1000428001, None, 7, 7)
        locations = xr.HandJointLocationsEXT(joint_locations=places)
        chain = ctypes.cast(ctypes.pointer(found), ctypes.c_void_p) if state else None
        if velocities:
            velocity.next = chain
            chain = ctypes.cast(ctypes.pointer(velocity), ctypes.c_void_p)
        locations.next = chain
        function = self._function("xrLocateHandJointsEXT", xr.PFN_xrLocateHandJointsEXT)
        at = self._time(time)
        info = xr.HandJointsLocateInfoEXT(self._spaces[base], at)
        took = []
        for _ in range(repeat):
            began = monotonic_ns()
            result = function(self._trackers[hand], ctypes.byref(info), ctypes.byref(locations))
            took.append(1e-9 * (monotonic_ns() - began))
            check(result)
        return {
            "active": bool(locations.is_active),
            "flags": [int(j.location_flags) for j in places],
            "position": [list(vector(j.pose.position)) for j in places],
            "orientation": [[*vector(j.pose.orientation), j.pose.orientation.w] for j in places],
            "radius": [j.radius for j in places],
            "moving": [int(j.velocity_flags) for j in moving],
            "linear": [list(vector(j.linear_velocity)) for j in moving],
            "angular": [list(vector(j.angular_velocity)) for j in moving],
            "source": [found.is_active, found.source],
            "took": took,
        }

    def untrack(self, hand: str) -> None:
        function = self._function("xrDestroyHandTrackerEXT", xr.PFN_xrDestroyHandTrackerEXT)
        check(function(self._trackers.pop(hand)))

    def close(self) -> None:
        """Everything in order."""
        for hand in list(self._trackers):
            self.untrack(hand)
        for space in self._spaces.values():
            xr.destroy_space(space)
        xr.destroy_session(self._session)
        xr.destroy_instance(self._instance)

    def _time(self, t: int | None) -> int:
        """XrTime of an instant of the monotonic clock, ns; 1 where it is not converted."""
        t = monotonic_ns() if t is None else t
        try:
            function = self._function(
                "xrConvertTimespecTimeToTimeKHR", xr.PFN_xrConvertTimespecTimeToTimeKHR
            )
        except (xr.exception.XrException, AttributeError):
            return t
        spec, out = xr.timespec(*divmod(t, 10**9)), ctypes.c_int64()
        check(function(self._instance, ctypes.byref(spec), ctypes.byref(out)))
        return out.value

    def _function(self, name: str, kind: Any) -> Callable[..., int]:
        return ctypes.cast(xr.get_instance_proc_addr(self._instance, name), kind)


def vector(v: Any) -> tuple[float, float, float]:
    return v.x, v.y, v.z


def monotonic_ns() -> int:
    return time.monotonic_ns()


def check(result: Any) -> None:
    """Raises for an error's number."""
    number = int(getattr(result, "value", result))
    if number < 0:
        raise RuntimeError(f"XrResult {number}")


def main() -> None:
    application = Application()
    for line in sys.stdin:
        request = json.loads(line)
        try:
            answer = {"answer": getattr(application, request.pop("do"))(**request)}
        except Exception as error:  # noqa: BLE001  whatever it is, the test shows it
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
