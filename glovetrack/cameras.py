"""What a camera driver is made of: a plug-in under ``glovetrack.cameras``.

A `CameraDriver` lists cameras and opens one as an `ImageInput`, which gives a `Pair` of images at a
time; see ``docs/camera-plugins.md``. Trouble with a device is a `DeviceError` in words.
"""

from tracker.base.errors import DeviceError
from tracker.sensors.camera_plugins import CameraDriver
from tracker.sensors.image_input import CaptureFormat, ImageInput, Pair

__all__ = ["CameraDriver", "CaptureFormat", "DeviceError", "ImageInput", "Pair"]
