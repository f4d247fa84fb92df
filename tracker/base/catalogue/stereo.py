"""Texts about the calibration of the camera."""

TEXTS = {
    "stereo.baseline_differs": (
        "The result places the lenses {found_mm:.1f} mm apart, but the known distance is "
        "{known_mm:.1f} mm. Measure a square of the board again."
    ),
    "stereo.views_disagree": (
        "The views do not fit one camera: corners are off by {rms_px:.1f} px. Check the "
        "numbers of squares, hold the board flat and still, and turn off autofocus."
    ),
    "stereo.coverage_low": (
        "The views cover only {covered_percent:.0f} % of the images. Show the board at "
        "the edges, too."
    ),
    "stereo.views_alike": (
        "The views are too similar: only {tilted} {tilted:shows|show} a tilted board, and"
        " the focal length is uncertain by {focal_percent:.1f} %. Tilt the board more."
    ),
    "stereo.refused": "{name} is not usable. {problems}",
    "stereo.not_finite": "The calibration contains values that are not numbers.",
    "stereo.one_mirrored": (
        "One camera is mirrored relative to the other. Turn off its mirror setting."
    ),
    "stereo.not_side_by_side": (
        "The cameras are above or behind each other, not side by side. Rotate the rig, or"
        " the images, by 90 degrees."
    ),
    "stereo.exchanged": (
        "Left and right are exchanged: the camera called left is on the right. Exchange "
        "the two images in the camera's set-up, or turn off mirroring, which looks the "
        "same."
    ),
    "stereo.baseline_impossible": (
        "The result places the cameras {found_mm:.1f} mm apart; {least_mm:.0f} to "
        "{most_mm:.0f} mm is possible. Check the size of a square, or the unit of the "
        "file."
    ),
    "stereo.offset_impossible": (
        "The result places one camera {above_mm:.0f} mm above and {before_mm:.0f} mm in "
        "front of the other. They must be side by side."
    ),
    "stereo.angle_impossible": (
        "The result has an angle of {angle_deg:.0f} degrees between the cameras. They must point "
        "in the same direction."
    ),
    "stereo.focal_impossible": (
        "The {lens:word} has a focal length of {focal_px:.0f} px for an image {width_px} "
        "px wide, which is not plausible."
    ),
    "stereo.pixels_not_square": (
        "The pixels of the {lens:word} are not square ({x_px:.0f} by {y_px:.0f})."
    ),
    "stereo.zoom_differs": (
        "The right lens magnifies {ratio:.2f} times as much as the left one. Check that "
        "the squares are the same for both and that neither lens is zoomed."
    ),
    "stereo.centre_off": (
        "The centre of the {lens:word} is {off_px:.0f} px from the middle of the image. "
        "Check whether the image is cropped or of another size."
    ),
    "stereo.distortion": (
        "The {lens:word} distorts the image's corners beyond recognition. Show the board "
        "in the corners too, or use a lens that is not a fisheye."
    ),
    "stereo.cover_empty": "Hold the board where the images are empty: {regions:word}.",
    "stereo.cover_tilt": "Tilt the board by 30 degrees: to the left, right, towards you and away.",
    "stereo.cover_distance": "Hold the board closer, then farther away.",
    "stereo.cover_more": "Show a few more views, each different from the others.",
    "stereo.unknown_file": (
        "{path} is not a stereo calibration: the file of a ZED ends in .conf, those of OpenCV and "
        "Kalibr in .yml or .yaml, and those of Anipose, FreeMoCap and Caliscope in .toml."
    ),
    "stereo.file_refused": "{path} is not usable. {why}",
    "stereo.not_opencv": "{path} is not a calibration that OpenCV can read.",
    "stereo.too_few_views": "There are only {usable} usable views; at least {needed} are required.",
    "stereo.no_solution": (
        "The views do not fit any camera. Check the board's kind and its numbers of squares."
    ),
    "stereo.matrix_missing": "{path} does not contain {key} ({names:or}).",
    "stereo.no_rotation": "{path}: R is not a rotation.",
    "stereo.not_matrix": "{path} contains a value that is not a matrix.",
    "stereo.matrix_shape": "{path}: {key} must be {shape} finite numbers.",
    "stereo.coefficients": (
        "{path}: the {side:word} camera has {count} distortion coefficients. OpenCV's models have "
        "5, 8, 12 or 14, a fisheye 4."
    ),
    "stereo.lens_model": (
        "{path}: the lens model of {camera} is {model}. Pinhole lenses with OpenCV's coefficients "
        "and equidistant fisheyes are supported."
    ),
    "stereo.mixed_lenses": (
        "One lens is a fisheye and the other is not. Both must be of the same kind."
    ),
    "stereo.baseline_negative": (
        "The stereo calibration has a baseline of {baseline_mm:.1f} mm: left and right "
        "are swapped, or this is not a stereo pair."
    ),
    "stereo.line_time": (
        "A line time of {line_time_us:g} µs is not plausible: an image is read within 0.1 s."
    ),
    "line_time.not_shown": (
        "The recording does not show the line time. Swing the hand faster, in all directions."
    ),
    "line_time.too_short": (
        "Too few markers are visible to estimate the line time. Record a swinging hand for 20 s."
    ),
    "stereo.matrices_differ": "The two rectified cameras must share one matrix P[:, :3].",
    "board.unknown_kind": 'A board is {kinds:or}, not "{kind}".',
    "board.square_count": (
        "A board has {least} to {most} squares in each direction, not {columns} by {rows}."
    ),
    "board.square_size": "A square of {square_mm:g} mm is not plausible. Measure one on the paper.",
    "board.symmetric": (
        "A chessboard of {columns} by {rows} squares looks the same upside down. One "
        "number must be even and the other odd."
    ),
    "board.parts_differ": "Both images must show the same part of the board.",
    "board.mirrored_side": (
        "The {side:word} image is mirrored. Turn off the camera's mirror setting."
    ),
    "board.not_seen_side": "The board is not visible in the {side:word} image.",
    "board.not_whole": "The whole board is not visible.",
    "board.not_whole_side": "The whole board is not visible in the {side:word} image.",
    "board.mirrored": "The image is mirrored. Turn off the camera's mirror setting.",
    "board.not_seen": "The board is not visible.",
    "verify.more_views": "{missing} more new {missing:view is|views are} required.",
    "verify.rows_bad": (
        "Rows differ by {rms_px:.2f} px and sizes by {size_percent:.1f} %. Calibrate "
        "again with more, and more varied, views."
    ),
    "verify.rows_fair": (
        "Rows differ by {rms_px:.2f} px and sizes by {size_percent:.1f} %. The "
        "calibration is usable; a new one would locate the hand more accurately."
    ),
    "verify.rows_good": "Rows agree to {rms_px:.2f} px and sizes to {size_percent:.2f} %.",
    "verify.corners_bad": (
        "Corners are off by {rms_px:.2f} px. Calibrate again with more, and more varied, views."
    ),
    "verify.corners_fair": (
        "Corners are off by {rms_px:.2f} px. The calibration is usable; a new one would "
        "locate the hand more accurately."
    ),
    "verify.corners_good": "Corners are accurate to {rms_px:.2f} px.",
}
