"""Texts about gloves, cameras, ports and firmware."""

TEXTS = {
    "plain": "{text}",
    "camera.swapped": (
        "The left and right images are swapped and not used. Exchange the two cameras."
    ),
    "camera.in_order": "The left and right images are in order again.",
    "camera.lens_moved": (
        "The two images are offset vertically by {apart_px:.1f} pixels: a lens has moved "
        "since the stereo calibration. Calibrate the camera again."
    ),
    "camera.fits_again": "The two images fit the stereo calibration again.",
    "camera.calibrate_again": (
        "The two images are offset vertically by {apart_px:.1f} pixels against the stereo "
        "calibration. Tracking corrects this, but distances may be wrong. Calibrate the camera "
        "again."
    ),
    "camera.lens_knocked": (
        "The images have moved relative to each other by {jump_px:.0f} pixels at once: a "
        "lens was knocked. If this does not recover, calibrate the camera again."
    ),
    "camera.moved": (
        "All markers have jumped by {jump_px:.0f} pixels at once: the camera was moved. "
        "Positions now refer to its new location."
    ),
    "camera.lamps_flicker": (
        "The lamps flicker at {lamp_hz} Hz, and the brightness of images varies by "
        "±{percent:.0f} %. Set the camera's power-line frequency to {mains_hz} Hz, or its exposure "
        "to a multiple of 1/{lamp_hz} s."
    ),
    "camera.lamps_steady": "The brightness of images no longer flickers.",
    "camera.connected": "The camera {camera} is connected.",
    "camera.silent": "The camera {camera} delivers no images. Waiting for it.",
    "camera.file_end": "The end of {camera} is reached.",
    "camera.size_misfit": (
        "The camera delivers images of {width} by {height} pixels, but its calibration is"
        " for {calibrated_width} by {calibrated_height}. Choose that size, or calibrate "
        "the camera again."
    ),
    "camera.side_size_misfit": (
        "The {side:word} camera delivers images of {width} by {height} pixels, but the "
        "calibration is for {calibrated_width} by {calibrated_height}. Choose that size, "
        "or calibrate the cameras again."
    ),
    "camera.black": (
        "The image of the {side:word} camera is black. Check whether the lens is covered."
    ),
    "camera.frozen": "The image of the {side:word} camera is frozen and not used.",
    "camera.torn": (
        "The image of the {side:word} camera is incomplete: a part of it did not arrive."
    ),
    "camera.image_back": "The image of the {side:word} camera is back.",
    "camera.slow": (
        "The camera delivers {rate_hz:.0f} images per second instead of {asked_hz:.0f}. "
        "The exposure is too long in poor light, or the USB port is too slow."
    ),
    "camera.slow_grant": (
        "The camera grants only {rate_hz:.0f} images per second at {width} × {height} pixels "
        "({format}) instead of {asked_hz:.0f}. Plug it into another USB port (USB 3, without a "
        "hub), or choose a smaller image size."
    ),
    "camera.lower_rate": (
        "The camera grants {rate_hz:.0f} images per second at {width} × {height} pixels "
        "({format}); {asked_hz:.0f} were requested."
    ),
    "camera.size_not_granted": (
        "The camera grants images of {width} × {height} instead of {asked_width} × "
        "{asked_height} pixels. Choose a size that the camera has and calibrate for it, or use "
        "another camera."
    ),
    "camera.not_fixed": (
        "The camera {camera} does not confirm these settings: {settings:words}. Set them with the "
        "camera's own program."
    ),
    "camera.one_for_two": (
        "The camera delivers one image, but the calibration is for two. Calibrate it as one camera."
    ),
    "camera.two_for_one": (
        "The camera delivers two images, but the calibration is for one camera. Calibrate"
        " both, or choose one camera in the camera's set-up."
    ),
    "camera.no_plugin": "There is no camera plug-in {name}. Install its package.",
    "camera.plugin_failed": "The camera plug-in {name} does not work: {why}",
    "camera.not_listed": (
        "The cameras of this system cannot be listed by name ({why}). Enter the camera's "
        "number under Set-up, Camera, Or number, file: 0 is the first one."
    ),
    "camera.not_there": "The camera {camera} cannot be opened: it is not connected.",
    "camera.not_opened": (
        "The camera {camera} cannot be opened: it is not connected, or another program uses it."
    ),
    "camera.lenses": 'lenses is "{lenses}"; it may be {known:or}.',
    "camera.one_is_left": "There is only one camera, which counts as the left one.",
    "camera.images_back": "The camera delivers usable images again.",
    "camera.no_images": "The camera has delivered no usable image for {silent_s:g} s.",
    "glove.wrong_hand": (
        "The glove {glove} is made for the {made_for:word} hand and cannot track the "
        "{side:word} one."
    ),
    "glove.packets_missing": (
        "No packets from the {side:word} glove: the hand follows the images alone."
    ),
    "glove.packets_back": "Packets from the {side:word} glove are arriving again.",
    "glove.other_hand": (
        "This looks like a glove for the {other:word} hand: its patches are mirrored. The"
        " file {glove} is for the {side:word} hand. Choose one for the {other:word} hand."
    ),
    "glove.markers_off": (
        "Markers {markers:list} of the {side:word} glove are about {offset_mm:.0f} mm from their "
        "positions in the glove file. Measure the glove again: record two minutes of free motion, "
        "then run glovetrack fit-glove."
    ),
    "glove.imu_off": (
        "The IMU {imu:word} of the {side:word} glove is rotated by about {angle_deg:.0f}° from its "
        "mounting in the glove file. Measure the glove again: record two minutes of free motion, "
        "then run glovetrack fit-glove."
    ),
    "glove.no_imu_on": "The glove {glove} has no IMU on {segment:word}.",
    "glove.port_not_opened": "The glove's port cannot be opened: {why}",
    "glove.port_busy": (
        "Another program has the glove's port open. Close it; the glove is then used automatically."
    ),
    "glove.port_denied": "The glove's port cannot be opened: {why}",
    "glove.twin_adapters": (
        "Another USB adapter has the same serial number as the glove's at {port}. Gloves are then "
        "recognised by their own number: give each a different one (glovetrack firmware write PORT "
        "--glove-id N)."
    ),
    "glove.reset_by_motor": (
        "The glove restarted when a motor started: the motor draws more current than the supply "
        "delivers. Charge the battery, or give the motors a supply and a capacitor of their own."
    ),
    "glove.brown_out": (
        "The glove restarts because its supply voltage drops. Charge the battery, use a shorter or "
        "thicker USB cable, and avoid unpowered hubs."
    ),
    "glove.cable_damaged": (
        "Bursts of damaged data arrive from the glove: its cable or a plug has a bad contact. Move "
        "the cable less, check the plugs, or replace the cable."
    ),
    "glove.imu_loose": (
        "IMU {imu} of the glove is lost again and again: its select line has a bad contact. Check "
        "the wires and solder joints of this IMU."
    ),
    "glove.usb_suspended": (
        "The system has suspended the glove's USB adapter to save power. Install the udev rule of "
        "the package, or run: echo on | sudo tee /sys/bus/usb/devices/*/power/control"
    ),
    "glove.wrong_baud": (
        "The data from the glove's port cannot be decoded at {baud} baud. Choose another "
        "speed under Set-up, Glove, or write the firmware for this speed."
    ),
    "glove.unplugged": "The glove was unplugged ({why}). It is used again as soon as it returns.",
    "glove.message": "Message from the glove: {text}",
    "glove.imu_count": (
        "This glove has {imus} IMUs but the glove file has {expected}. Choose the right glove file."
    ),
    "glove.back_at": "The glove is back, at {port}.",
    "glove.restarted": "The glove has restarted. Streaming is started again.",
    "glove.sends_again": "The glove is sending again.",
    "glove.packet_imu_count": (
        "Packets contain {imus} IMUs but the glove file has {expected}. Choose the right "
        "glove file."
    ),
    "glove.clock_jumped": (
        "The glove's clock jumped by {jump_s:+.3f} s. Its packets are synchronised again."
    ),
    "glove.no_hello": "The glove has not identified itself. Streaming is started anyway.",
    "glove.silent": "The glove has sent nothing for {silent_s:g} s.",
    "glove.pulse": "Pulse {number} on the glove",
    "glove.other_rate": (
        "The glove sends {rate_hz:.0f} packets per second instead of {asked_hz}. Their "
        "time stamps are still right."
    ),
    "glove.ranges_unknown": (
        "The glove has not reported its ranges, so its values are not used yet. Hold the "
        "hand still for a second, so that gravity reveals them."
    ),
    "glove.range_from_rest": (
        "At rest the glove's acceleration fits a range of {accel_g} g, which is used now."
        " For rotation, {gyro_dps} °/s is assumed, which may be wrong."
    ),
    "glove.battery_low": "The glove's battery is low ({volts:.2f} V). Charge it soon.",
    "glove.of_left": "Left glove: {what}",
    "glove.of_right": "Right glove: {what}",
    "glove.stranger": (
        "The glove at {port} is number {found}, but number {glove_id} is expected. To use"
        " another glove, choose it under Set-up, Glove."
    ),
    "glove.stranger_unknown": (
        "The device at {port} is not a glove, but glove number {glove_id} is expected. To"
        " use another glove, choose it under Set-up, Glove."
    ),
    "glove.chip_unknown": (
        "IMU {imu} of the glove has a chip of an unknown kind ({chip}). It passed its self-test "
        "and is used."
    ),
    "glove.chip_refused": (
        "IMU {imu} of the glove has a chip of an unknown kind ({chip}) that did not pass its "
        "self-test. It is not used: keep the glove still and restart it, or replace the IMU."
    ),
    "glove.imu_saturated": (
        "IMU {imu} of the glove is at the end of its range. These samples are not used; move "
        "more slowly, or protect the glove from impacts."
    ),
    "glove.imu_silent": "IMU {imu} of the glove is not responding.",
    "glove.imu_back": "IMU {imu} of the glove is responding again.",
    "glove.imu_stuck": (
        "IMU {imu} of the glove: axes that no longer change: {axes:list}. Restart the glove; if "
        "this persists, replace the IMU."
    ),
    "imu_axes.few_rests": (
        "The recording has {rests} rests; at least {fewest} in different positions are needed. Lay "
        "the glove still for two seconds on each side of a box."
    ),
    "imu_drift.no_temperatures": (
        "{path} has no temperatures of IMUs. Firmware 1.3 of the glove reports them."
    ),
    "imu_drift.other_glove": "{path} is a recording of another glove: it has the IMU {imu}.",
    "imu_drift.no_rest": (
        "The recordings have no rest of three seconds. Lay the glove down at the beginning and "
        "at the end."
    ),
    "glove.motor_run": (
        "Motor {motor} runs for {duration_ms} ms with amplitude {amplitude} of 255."
    ),
    "glove.file_vibration": "The noise of a vibration cannot be negative.",
    "imu_drift.learned": (
        "Glove {glove}: the change of the biases with the temperature was learned for {imus} IMUs; "
        "its uncertainty fell from {before:.3f} to {after:.3f} °/s per °C. {file} contains the "
        "result, which is used from the next start on."
    ),
    "imu_drift.contradicted": (
        "Glove {glove}: the biases of the IMUs {imus} do not change with the temperature as its "
        "file states, so nothing was learned. Lay the glove down for ten seconds before and "
        "after the next recording; if this message returns, remove the key drift from the file."
    ),
    "gloves.exchanged": (
        "The two gloves are exchanged: each uses the files of the other hand. Choose the "
        "hand of each in the gloves' set-up."
    ),
    "port.not_opened": "{port} cannot be opened: {why}.",
    "port.lost": "{port} was disconnected: {why}.",
    "port.not_glove": (
        "{port} sends {received_bytes} bytes that are not a glove's: it is another "
        "device, or its line is not set to {bauds:or} baud."
    ),
    "port.no_answer": "The device at {port} is not responding.",
    "port.latency_linux": (
        "The USB adapter at {port} holds bytes back for up to {latency_ms} ms. For faster"
        " tracking set it to 1 ms: echo 1 | sudo tee {setting}"
    ),
    "port.latency_windows": (
        "The USB adapter at {port} may hold bytes back for up to 16 ms. For faster "
        "tracking set 1 ms in the Device Manager: Ports, {port}, Port Settings, Advanced,"
        " Latency Timer."
    ),
    "images.crowded": "More than {limit} coloured patches in an image; {ignored} ignored so far.",
    "images.unequal_sequences": (
        "There are {left} left and {right} right images. A sequence requires as many of "
        "one as of the other."
    ),
    "images.no_halves": (
        "The stereo image is {width_px} pixels wide and cannot be split into two halves."
    ),
    "images.not_readable": "{path} is not an image that can be read.",
    "firmware.no_response": "The glove is not responding yet. Unplug it, then plug it in again.",
    "firmware.number": (
        "The number of a glove is 1 to {most}, not {number}. Two gloves need different numbers."
    ),
    "firmware.baud": "There is firmware for {bauds:or} baud, not for {baud}.",
    "firmware.not_readable": "{path} cannot be read as firmware: {why}",
    "firmware.line_damaged": "{path}: line {line} is damaged, so the file is not used.",
    "firmware.line_unknown": "{path}: line {line} has a gap or an unknown type of record.",
    "firmware.cut_off": "{path} ends before its last line: the file is incomplete.",
    "firmware.not_glove": "{path} is not firmware of a glove (version 1.1 or later).",
    "firmware.too_large": "{path} has {size_bytes} bytes; the chip has {chip_bytes}.",
    "firmware.no_avrdude": (
        "avrdude, which writes the firmware, is not installed. On Debian run: sudo "
        "apt-get install avrdude; for other systems see github.com/avrdudes/avrdude."
    ),
    "firmware.available": "Firmware {version} is available (installed: {installed}).",
    "firmware.flash_failed": "{port}: avrdude failed. (avrdude: {output})",
    "firmware.no_bootloader": (
        "{port}: the board is not responding as a bootloader. Try the other kind "
        "({others:list}), and press reset just before. (avrdude: {output})"
    ),
    "firmware.port_denied": (
        "{port}: you are not allowed to open the port. On Linux, join the group dialout. "
        "(avrdude: {output})"
    ),
    "firmware.port_busy": "{port}: another program uses the port. Close it. (avrdude: {output})",
    "firmware.port_absent": "{port}: no device is connected to the port. (avrdude: {output})",
    "firmware.not_verified": (
        "{port}: the chip's contents differ from what was written. Write the firmware "
        "again. (avrdude: {output})"
    ),
    "firmware.wrong_chip": "{port}: the chip is not an ATmega328P. (avrdude: {output})",
    "zed.height": "A ZED has no images {height_px} pixels high. Possible heights: {known:list}.",
    "zed.not_calibration": "{path} is not a calibration file of a ZED camera: {why}",
    "zed.missing_key": (
        "{path} has no {key} in [{section}]: the file is incomplete, or belongs to another camera."
    ),
    "zed.not_number": '{path}: {key} in [{section}] is "{text}", which is not a number.',
    "simulator.camera_not_started": "The simulated camera did not start.",
    "simulator.no_terminal": (
        "The simulated glove requires a pseudo-terminal, which this system does not have."
    ),
    "simulator.no_pipes": (
        "The simulated cameras require named pipes, which this system does not have."
    ),
    "image.format": (
        "An image must be in colour with 8 bits per channel, not of shape {shape} and type {type}."
    ),
    "simulator.glove_not_started": "The simulated glove did not start.",
    "glove.not_at_port": "No glove was found at {port}. {reasons}",
    "glove.not_at_usb": "No glove was found on any USB port. {reasons}",
    "camera.none_found": (
        "No camera was found. Plug in the stereo camera, then choose Search again. If this "
        "system lists no cameras, enter the number of yours under Set-up, Camera, Or number, "
        "file (0 is the first one)."
    ),
    "camera.not_among": (
        "The camera {camera} is not connected. Connected cameras: {connected:list}. Plug it "
        "in, or choose another one under Set-up, Camera."
    ),
    "camera.closed": "The camera was closed. Start glove and camera again.",
    # ---- what the window could not do
    "window.process_ended": ("The process ended unexpectedly. The computer may be out of memory."),
    "window.demo_camera": "The simulated camera did not start.",
    "window.no_devices": "{problems}",
    "window.no_glove": "No glove was found on any USB serial port. Plug it in, then try again.",
    "window.no_glove_because": "No glove was found. {reasons}",
    "window.imus_alone": "The hand is tracked by its IMUs alone, so its position is unknown.",
    "window.no_rig": (
        "The camera has no calibration yet. Make or import one under Set-up, Camera calibration."
    ),
    "window.glove_settings": "The glove's settings cannot be changed: {why}.",
    "window.no_folder": "The folder {folder} no longer exists.",
    "window.not_tracked": "{file} has not been tracked. Choose Track again first.",
    "window.settings_no_version": "they have no version number",
    "window.settings_later": "they were written by a later version of Glovetrack",
    "window.tags_too_large": "it is too large",
    "window.being_recorded": "{file} is being recorded.",
    "window.is_open": "{file} is open. Close it first (Ctrl+W).",
    "window.image_not_readable": "{file} is not a readable image.",
    "window.image_not_encoded": "{file}: the image could not be encoded.",
    "window.exists_again": "{file} exists again. It was not replaced by the removed file.",
    "window.not_removed": "{name} was not removed: {why}.",
    "window.tags_not_moved": "The tags of {file} were not moved with it: {why}.",
    "window.no_trash": "{file} cannot be moved to the trash.",
    "window.not_restored": "{file} exists again, so it was not restored from the trash.",
    "window.no_image_to_fit": "There is no image yet to fit the colours to.",
    "window.no_markers_to_fit": "No markers were tracked yet. Fit from the image alone first.",
    "window.other_hues": "{file} must have the hues {hues:words} for this glove.",
    "window.recording_folder": "Cannot record to {folder}: {why}.",
    "window.unknown_field": "A file name can contain {known}, not {field}.",
    "window.bad_template": (
        'The file name "{template}" is incomplete. It can contain text and {known}.'
    ),
}
