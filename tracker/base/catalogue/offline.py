"""Texts about tracking, filling, cropping and simulating sessions."""

TEXTS = {
    "track.out_is_file": "{path} is a file. Name a folder for the results of several sessions.",
    "track.no_side": "{file} does not contain the side of its hand.",
    "track.other_hand": (
        "{file} is for the hand {hand} with the glove {glove}, which the session does not contain."
    ),
    "track.same_hand": "{files:words} are for the same hand. Give one file for each hand.",
    "track.same_side": "{files:words} are for the same side. Give one file for each hand.",
    "track.one_hand": "{files:words}: the session contains one hand. Give one file.",
    "track.some_failed": "{failed} of {count} sessions could not be tracked.",
    "crop.range": "A part must start before it ends, within the {duration_s:.2f} s of {file}.",
    "gaps.none_filled": "No gap of {file} could be filled: {why:word}.",
    "gaps.max_gap": "The longest gap to fill must be greater than 0 s, not {max_gap_s:g} s.",
    "gaps.no_such_gap": (
        "{file} has no gap of the {side:word} {part} from {start_s:.3f} s to {stop_s:.3f} s. "
        "List its gaps again."
    ),
    "gaps.not_list": "{path} is not a list written by glovetrack gaps --json.",
    "noise.no_samples": "The recording contains no IMU samples.",
    "noise.short_rest": (
        "The longest rest in the recording is {rest_s:.0f} s; at least {least_s:.0f} s are "
        "required, 10 minutes are recommended. Put the glove on a table and do not touch it."
    ),
    "noise.imu_missing": "The IMU {imu} is missing in {missing_percent:.0f} % of the rest.",
    "noise.unknown_imu": "The glove file has no IMU {names:list}.",
    "fit_glove.few_postures": (
        "The recording shows {postures} different postures; at least {least} are required. Move "
        "all fingers freely in front of the camera for two minutes."
    ),
    "fit_glove.not_fitted": (
        "The glove file cannot be fitted to this recording: the postures contradict each other, or "
        "markers are more than {most_mm:.0f} mm from their positions. Check that the file is of "
        "this glove."
    ),
    "fit_glove.no_table": (
        "The glove file has no table with an id or name for {names:list}, so it cannot be changed."
    ),
    "fit_glove.two_hands": ("{path} contains two hands. Record the glove alone, then fit it."),
    "fit_glove.both_targets": "Give --set or --name, not both.",
    "fit_glove.no_camera": (
        "{path} has no stereo camera, which is required to measure the markers."
    ),
    "track.hand_length": "A profile contains the length of the hand. Leave out --hand-length.",
    "simulate.fixed_camera": "The scene {scene} requires a camera that does not move.",
    "simulate.two_hands": (
        "Both hands are simulated with random postures in front of a fixed camera. Leave out "
        "--motion, --guided, --hand, --camera and --lenses none."
    ),
    "track.smooth_engine": "Smoothing requires the engine chain, not {engine}.",
    "track.smooth_lenses": "Smoothing requires both lenses. Leave out --smooth or --lenses.",
    "track.smooth_calibration": (
        "{path} changes its camera calibration; --smooth requires a single one."
    ),
    "track.settings_not_usable": "{why} Use the default settings: --settings default.",
    "simulate.no_fabric": (
        'The simulator has no fabric of the hue "{hue}". Available: {known:list}.'
    ),
    "simulate.desk_camera": "The desk requires a camera on a stand, not on the head.",
    "simulate.light_scene": "--light requires the scene desk, not {scene}.",
    "simulate.photo_scene": "The scene photo requires an image (--photo); other scenes have none.",
    "simulate.unknown_show": 'There is no show "{name}". Available: {known:list}.',
    "simulate.two_hands_scene": (
        "Two hands can be simulated in the scenes plain, painted and photo."
    ),
    "gaps.none_of_kind": "{file} has no gap to fill ({kinds:list}).",
    "gaps.all_longer": (
        "All {count} gaps of {file} that could be filled are longer than {max_gap_s:g} s. "
        "Choose a longer --max-gap."
    ),
    "gaps.no_estimates": "No gap of {file} has estimates on both sides.",
    "track.no_images": "{path} contains no images, so other colours cannot be used.",
    "track.no_blobs": "{path} contains neither detected markers nor images.",
}
