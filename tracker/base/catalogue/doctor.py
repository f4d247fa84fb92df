"""Texts of ``glovetrack doctor``: what was found, and what to do about it."""

TEXTS = {
    "doctor.check_failed": "The check itself failed: {why}.",
    "doctor.attach_report": "Attach this report to a bug report.",
    "doctor.in_use": "{device} is in use by this window and was not tested.",
    # ---- the computer
    "doctor.system": "Glovetrack {version}, Python {python}, {platform}.",
    "doctor.machine": "{cores} cores, {memory_gb:.1f} GB of memory.",
    "doctor.larger_machine": "Use a computer with at least {cores} cores and 4 GB.",
    "doctor.compiled": "The program's numerical code is compiled.",
    "doctor.not_compiled": (
        "The program's numerical code is compiled while it runs (by {compiler})."
    ),
    "doctor.reinstall": "The first start takes minutes. Reinstall the package to avoid this.",
    "doctor.load": "Other programs use {load_percent:.0f} % of all cores.",
    "doctor.close_programs": "Close other programs before you start tracking.",
    "doctor.tracking_load": (
        "Tracking at {fps:.0f} images per second takes {share_percent:.0f} % of a core at the "
        "present load: {detection_percent:.0f} % for the images, {filter_percent:.0f} % for the "
        "filter."
    ),
    "doctor.urgent": "Tracking runs before other programs (real-time priority).",
    "doctor.not_urgent": "Tracking waits for other programs: this user has no real-time priority.",
    "doctor.allow_urgent": (
        'If other programs run during recordings, add the line "USER - rtprio 1" with your user '
        "name to /etc/security/limits.d/glovetrack.conf, and log in again."
    ),
    "doctor.lower_rate": "Close other programs, and choose 30 images per second.",
    "doctor.disk_speed": (
        "The disk of {folder} takes {disk_mb_s:.0f} MB/s; a recording needs up to "
        "{needed_mb_s:.0f} MB/s."
    ),
    "doctor.other_disk": "Record to another disk, or record without images.",
    "doctor.other_folder": "Choose another folder for recordings.",
    "doctor.disk_room": (
        "{free_gb:.0f} GB are free: at least {minutes:.0f} minutes of recording with images."
    ),
    "doctor.free_disk": "Delete or move old recordings.",
    "doctor.no_graphics": "There is no graphics card: the processor draws the 3D view.",
    "doctor.graphics_driver": "Install the card's driver. Tracking itself does not need one.",
    "doctor.graphics": "Graphics card {name}.",
    "doctor.graphics_refused": "This user may not use the graphics card {name}.",
    "doctor.graphics_group": (
        "Add yourself to its group (sudo usermod -aG render,video $USER) and log in again."
    ),
    "doctor.opengl": "OpenGL uses the graphics card: {renderer}.",
    "doctor.opengl_slow": "OpenGL uses the processor: {renderer}.",
    "doctor.no_opengl": "OpenGL does not work.",
    "doctor.opengl_driver": (
        "Install the graphics card's driver; until then the 3D view is simpler."
    ),
    # ---- permissions
    "doctor.refused": "This user may not open {device}.",
    "doctor.join_group": (
        "Add yourself to the group {group} (sudo usermod -aG {group} $USER) and log in again, or "
        "install the udev rule {rule} of the package."
    ),
    "doctor.replug": "Unplug the device, then plug it in again.",
    "doctor.allowed": "This user may open all {devices} device files.",
    "doctor.no_rule": "The udev rule {rule} is not installed.",
    "doctor.install_rule": (
        "Install the package, or copy the rule to /etc/udev/rules.d: it gives access to new "
        "devices and sets the latency timer of USB adapters."
    ),
    "doctor.no_pkexec": (
        "pkexec is not installed. Copy the rule to {target} as an administrator, then run: "
        "udevadm control --reload"
    ),
    "doctor.rule_not_authorized": "The rule was not installed: the request was not authorized.",
    "doctor.rule_failed": "The rule was not installed: {why}",
    # ---- gloves
    "doctor.no_port": "There is no USB serial port.",
    "doctor.plug_glove": "Plug the glove in.",
    "doctor.no_glove": "No glove responds on any port.",
    "doctor.check_cable": "Check the cable, or write the firmware.",
    "doctor.close_port": "Close the other program, then check again.",
    "doctor.write_if_glove": "If a glove is connected there, write its firmware.",
    "doctor.twin_adapters": "Two USB adapters have the same serial number.",
    "doctor.number_gloves": (
        "Gloves are then recognised by their own number: give each a different one (glovetrack "
        "firmware write PORT --glove-id N)."
    ),
    "doctor.other_baud": "The glove at {port} sends at {baud} baud, which Glovetrack does not use.",
    "doctor.write_at_baud": (
        "Write the firmware again: glovetrack firmware write {port} --baud {baud}."
    ),
    "doctor.not_decoded": "{port} sends bytes that cannot be decoded at {bauds:or} baud.",
    "doctor.if_glove": (
        "If it is a glove, its firmware has another baud rate or the cable is damaged: write the "
        "firmware again. Otherwise ignore this line."
    ),
    "doctor.no_answer": "The glove at {port} sends samples but does not answer.",
    "doctor.glove": "Glove {glove} at {port}: {imus} IMUs, firmware {firmware}, {baud} baud.",
    "doctor.write_firmware": "Run glovetrack firmware write {port}.",
    "doctor.no_samples": "The glove at {port} answers but sends no samples.",
    "doctor.replug_or_write": (
        "Unplug it, then plug it in again. If this does not help, write the firmware."
    ),
    "doctor.packets": (
        "{rate_hz:.1f} packets per second, {lost_percent:.1f} % lost, {damaged} damaged."
    ),
    "doctor.shorter_cable": (
        "Use a shorter cable and another USB port, without a hub, and check the plugs."
    ),
    "doctor.packet_rate": "{rate_hz} were requested: write the current firmware.",
    "doctor.battery": "The glove's battery has {volts:.2f} V.",
    "doctor.charge": "Charge the glove.",
    "doctor.imus_absent": "IMUs that do not respond: {imus:list}.",
    "doctor.imu_wires": "Check the wires of these IMUs: supply, clock, data and select line.",
    "doctor.imus": "All {imus} IMUs respond.",
    "doctor.selftest_again": "Keep the glove still and restart it; otherwise replace the IMU.",
    "doctor.imu": "IMU {imu}: {chip}, self-test {selftest:word}.",
    "doctor.imu_warm": ("IMU {imu}: {chip}, self-test {selftest:word}, {temperature_c:.1f} °C."),
    "doctor.imu_stuck": "IMU {imu}: axes that do not change: {axes:list}.",
    "doctor.replace_imu": "Replace the IMU.",
    "doctor.imu_saturated": "IMU {imu}: {samples} samples at the end of the range.",
    "doctor.move_slowly": "Move the glove more slowly. If it is at rest, replace the IMU.",
    "doctor.arrivals": "The delay of 90 % of the packets varies by {spread_ms:.1f} ms.",
    "doctor.latency_timer": "Set the adapter's latency timer to 1 ms, and avoid USB hubs.",
    "doctor.clock": "The glove's clock differs by {skew_ppm:+.0f} ppm.",
    "doctor.replace_board": "Replace the board: its crystal is out of tolerance.",
    # ---- cameras
    "doctor.no_camera": "There is no camera.",
    "doctor.plug_camera": "Plug the camera in.",
    "doctor.camera_busy": "Close other programs that use it, or plug it in again.",
    "doctor.camera": "{camera}: {measured_fps:.1f} images per second of {width} × {height} pixels.",
    "doctor.camera_grant": "{camera}: {what}",
    "doctor.camera_slow": (
        "{camera}: {measured_fps:.0f} images per second arrive instead of the {granted_fps:.0f} "
        "granted."
    ),
    "doctor.more_light": "Add light or shorten the exposure; otherwise use another USB port.",
    "doctor.no_images": "{camera} opens but no images arrive.",
    "doctor.other_port": (
        "Plug it into another USB port; another camera on the same hub may use its bandwidth."
    ),
    "doctor.black": "{camera}: the image is black.",
    "doctor.uncover": "Take the cover off the lens.",
    "doctor.no_exposure": (
        "{camera} has no exposure control: its automatic exposure cannot be verified."
    ),
    "doctor.constant_light": "Keep the light constant, or use a camera with a manual exposure.",
    "doctor.exposure_unverified": "{camera} does not confirm that its exposure is locked.",
    "doctor.own_program": (
        "Check the exposure in the camera's own program, and keep the light constant."
    ),
    "doctor.exposure": "{camera}: the exposure can be locked.",
    "doctor.stamps": (
        "{camera}: the driver stamps images with {stamp_jitter_ms:.1f} ms of jitter; they arrive "
        "with {arrival_jitter_ms:.1f} ms."
    ),
    "doctor.no_stamps": (
        "{camera}: the driver does not stamp images; they arrive with {arrival_jitter_ms:.1f} ms "
        "of jitter."
    ),
    "doctor.no_hub": "Use another USB port without a hub, and close other programs.",
}
