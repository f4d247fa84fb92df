"""Texts about tracking, engines and calibration of the hand."""

TEXTS = {
    "tracking.abandoned": (
        "Tracking stopped: the detected markers do not match the glove file. Fit the "
        "colours, or check whether two of the hues are exchanged."
    ),
    "tracking.searching": "Looking for the hand.",
    "tracking.tracked": "The hand is tracked.",
    "tracking.coasting": "The hand is out of sight; its position is extrapolated.",
    "tracking.lost": "The position of the hand is lost; finger angles are still measured.",
    "tracking.side_searching": "Looking for the {side:word} hand.",
    "tracking.side_tracked": "The {side:word} hand is tracked.",
    "tracking.side_coasting": "The {side:word} hand is out of sight; its position is extrapolated.",
    "tracking.side_lost": (
        "The position of the {side:word} hand is lost; finger angles are still measured."
    ),
    "pose_reset.not_supported": (
        "Pose reset: the engine {engine} does not support it. Choose the engine chain or inertial."
    ),
    "pose_reset.searching": (
        "Pose reset, {side:word} hand: not possible before the hand is tracked."
    ),
    "pose_reset.bent": (
        "Pose reset, {side:word} hand: not done, because fingers are bent. Hold the hand "
        "flat and try again."
    ),
    "pose_reset.steep": (
        "Pose reset, {side:word} hand: not done, because the fingers point up or down. "
        "Hold the hand level and try again."
    ),
    "pose_reset.done": (
        "Pose reset, {side:word} hand: joints corrected by up to {joints_deg:.0f}°. The "
        "heading is measured by the camera."
    ),
    "pose_reset.done_heading": (
        "Pose reset, {side:word} hand: joints corrected by up to {joints_deg:.0f}°, "
        "heading by {heading_deg:.0f}°."
    ),
    "pose_reset.asked": "Pose reset: hand flat, fingers straight ahead.",
    "wrist_pose.not_used": (
        "The pose of the wrist from another tracking system is ignored: this engine uses the "
        "camera. Choose the engine inertial to use it."
    ),
    "wrist_pose.misaligned": (
        "{side:word} hand: the pose of the wrist from another tracking system disagrees with "
        "gravity by more than 30° and is ignored. Align the tracker with the hand."
    ),
    "guided.not_learned": "The engine {engine} does not learn from guided poses.",
    "guided.unknown": 'There is no guided pose "{pose}". It is ignored.',
    "guided.no_phase": 'The guided pose "{pose}" neither begins nor ends. It is ignored.',
    "guided.pose": "{instruction:word}",
    "engine.needs_camera": (
        "The engine {engine} requires a camera with a stereo calibration. Without one, "
        "choose the engine {other}, which shows the hand by its IMUs."
    ),
    "engine.needs_both_lenses": (
        "The engine {engine} requires both lenses. With one lens, choose the engine chain."
    ),
    "engine.needs_root_imu": (
        "The engine {engine} requires an IMU and markers on the {segment:word}."
    ),
    "engine.vist_gaps": (
        "The engine vist requires an IMU on every segment of a chain; the glove {glove} "
        "has none on {segments:list}."
    ),
    "engine.vist_extra": (
        "The engine vist requires one IMU per segment; the glove {glove} has more."
    ),
    "engine.no_wearer": "This engine does not use a wearer's profile. Choose the engine chain.",
    "engine.finger_estimator": 'There is no finger estimator "{name}". Available: {known:list}.',
    "engine.process_ended": "The process that tracks has ended.",
    "engine.process_silent": "The process that tracks does not answer.",
    "engine.changed": "The engine is now {engine}.",
    "load.view_slower": "System overloaded: 3D view frame rate reduced.",
    "load.no_overlays": "System overloaded: camera images are shown without overlays.",
    "load.narrow_search": "System overloaded: images are searched only where markers are expected.",
    "load.fewer_images": (
        "System overloaded: fewer images are searched. All packets of the glove are still used."
    ),
    "load.recovered": "The system is no longer overloaded: full 3D view frame rate.",
    "load.overlays_back": "Camera images are shown with overlays again.",
    "load.full_search": "Whole images are searched again.",
    "load.all_images": "All images are searched again.",
    "thread.failed": "The {thread} thread failed: {type}: {why}.",
    "calibration.no_segment": 'There is no segment "{segment}" whose calibration is estimated.',
    "calibration.hand_length": (
        "A hand is {least_mm:.0f} to {most_mm:.0f} mm long, from the crease of the wrist "
        "to the tip of the middle finger; {length_mm:.0f} mm is not plausible. Measure it"
        " again."
    ),
    "wearer.invalid": "{file} is not a profile of a wearer: {why}",
    "wearer.other_hand": (
        "{file} is for the hand {hand} with the glove {glove}; this is the hand "
        "{our_hand} with the glove {our_glove}."
    ),
    "wearer.damaged": "{file} is not a profile of a wearer, or it is damaged.",
    "listener.failed": "The listener {name} failed and was removed: {why}",
    "still.too_short": "Only {seconds:.1f} s of samples arrived; {needed_s:g} s are required.",
    "still.moved": "The hand moved ({moving:list}). Lay it flat on the table, palm down, and wait.",
    "still.imu_silent": "is not responding",
    "still.imu_moves": "moves ({rate_dps:.1f} °/s)",
    "still.imu_biased": "turns, or its gyroscope is off by {bias_dps:.0f} °/s",
    "still.imu_gravity": (
        "measures {gravity:.1f} m/s² of gravity, so its accelerometer is inaccurate"
    ),
    "still.imu": "{imu:word} {what}",
    "still.imus": "{imus:list}.",
    "wiggle.hand": (
        "Rest your forearm and tip your whole hand up and down, with the fingers stretched."
    ),
    "wiggle.thumb": "Bend and stretch your thumb a few times; keep everything else still.",
    "wiggle.finger": "Bend and stretch your {finger:word} finger a few times, in all its joints.",
    "wiggle.nothing_moved": "Nothing moved. {instruction}",
    "wiggle.silent": "It did not respond in any step.",
    "wiggle.still": "It never moved. Check whether it is loose or broken.",
    "wiggle.unclear": "It moved in several steps. Repeat them.",
    "wiggle.elsewhere": (
        "It is on the {found:word}, but according to the glove file it belongs on the "
        "{expected:word}."
    ),
    "wiggle.turned": "It is in its position, but rotated by about {angle_deg:.0f}°. Remount it.",
    "wiggle.right": "Its position matches the glove file.",
    "wiggle.all_right": "The positions of all IMUs match the glove file.",
    "wiggle.exchanged": (
        "Exchanged: {first:word} and {second:word}. Exchange their plugs, or choose a "
        "glove file with that order."
    ),
    "wiggle.look_at": "Check {imus:list}.",
    "wiggle.imu": "{imu:word} ({state:word})",
    "track.packets_repeated": (
        "{count} repeated {count:packet|packets} of the {side:word} glove {count:was|were} ignored."
    ),
    "track.gaps_dropped": (
        "{count} interpolated {count:gap|gaps} of {file} {count:was|were} not used: "
        "tracking starts from the sensors."
    ),
    "track.settings_unused": (
        "This version cannot use these settings of {file}: {settings:list}. They were "
        "ignored; the other recorded settings were used."
    ),
    "track.settings_unused_more": (
        "This version cannot use these settings of {file}: {settings:list} and {more} "
        "more. They were ignored; the other recorded settings were used."
    ),
    "track.state_unused": (
        "{file} was recorded by version {version} in the middle of tracking. The recorded"
        " tracking state was not used, so the first seconds may differ."
    ),
    "track.state_of_version": (
        "{file} was recorded by version {version}. Tracking continues from its recorded state; the "
        "results may differ slightly from those of that version."
    ),
    "simulation.camera_ended": "The simulated camera has ended.",
    "simulation.pose_shown": "The simulated wearer is asked for the pose {pose:word}.",
    "simulation.pose_over": "The simulated wearer is not asked for a pose any more.",
    # ---- colours and light
    "colours.no_pixels": 'No pixels are marked for the hue "{hue:word}".',
    "colours.every_hue": 'The pixels marked for "{hue:word}" cover all hues. Mark only one cloth.',
    "colours.followed": "Colours adapted to the light.",
    "colours.no_glove_seen": (
        "Nothing was fitted: no glove was recognised with certainty. Hold your hand flat "
        "in front of the camera, in more or whiter light."
    ),
    "colours.points_missing": "Point at a marker of each hue first. Missing: {hues:words}.",
    "colours.only_points_learned": (
        "Only the pixels that you pointed at were learned: no glove was recognised around"
        " them. Hold your hand flat and point at the centre of a patch of each hue."
    ),
    "colours.learned_worse": (
        "The colours are unchanged: the learned ones find {found} of {picked} markers and"
        " {others} other objects, the current ones {found_before} and {others_before}. "
        "Point at markers of a flat hand, in more light."
    ),
    "colours.fitted_worse": (
        "The colours are unchanged: the fitted ones find {found} patches of the glove and"
        " {others} other objects, the current ones {found_before} and {others_before}."
    ),
    "colours.unfit": (
        "The colours find {patches} patches, none of which fit the glove. Fit the colours."
    ),
    "colours.fit_again": "The colours no longer find too many patches, or the hand was found.",
    "colours.too_many_hues": (
        "The colour profile {profile} has {hues} hues; at most {most} can be distinguished."
    ),
    "colours.fitted_themselves": "The colours showed no hand, so they were fitted automatically.",
    "colours.exchanged": (
        "The names of these hues are exchanged in the colour profile: {hues:words}. Fit the "
        "colours."
    ),
    "colours.exchanged_here": (
        "The names of these hues are exchanged in the colour profile: {hues:words}. Tracking uses "
        "the right ones; fit the colours to correct the profile."
    ),
    "colours.exchanged_corrected": (
        "The names of these hues were exchanged in the colour profile and are corrected: "
        "{hues:words}."
    ),
    "colours.no_hand": "No hand is visible. {why}",
    "light.too_bright": (
        "The {hues:words} markers are too bright. Shorten the exposure, or move the lamp away."
    ),
    "light.clipped": (
        "{share_percent:.0f} % of the image is white. Keep the window and the screen out "
        "of the image, or shorten the exposure."
    ),
    "light.dark": "The markers are dark. Put more light on the hand, or lengthen the exposure.",
    "light.noisy": "The image is noisy. Use more light and less gain.",
    "light.warm": (
        "The light is too warm. Use a daylight lamp or set the white balance, then fit the colours."
    ),
    "light.cold": "The light is too cold. Set the white balance, then fit the colours.",
    "light.hues_alike": (
        "The {hues:words} markers look alike in this light. Use another lamp, or other cloth."
    ),
    "light.room_has_hues": (
        "The room also contains {hues:words}, in {spots} {spots:spot|spots}. Lay a dark "
        "or grey cloth under the hand, or fit the colours."
    ),
    "light.markers_missed": (
        "{missed} of {expected} markers are not found with these colours. Fit them to the image."
    ),
    "light.show_hand": "Hold your gloved hand in front of the camera, its back up.",
    "light.no_images": "{path} contains no images whose light can be measured.",
    "colours.no_calibration": (
        "The session contains no camera calibration, so no hand can be found in its images."
    ),
    "colours.no_images": "{path} contains no images to fit colours to.",
    "colours.session_fit_worse": (
        "The colours are unchanged: the fitted ones find {found:.1f} markers and "
        "{others:.1f} other objects per image, the current ones {found_before:.1f} and "
        "{others_before:.1f}."
    ),
    "colours.no_hand_found": (
        "The colours could not be fitted: no hand was found with certainty, in any light and with "
        "any names of the hues. Hold the hand flat and still in view of {cameras:word}, in more or "
        "whiter light."
    ),
    "colours.live_needs": (
        "Fitting to live images needs the glove and a calibrated camera. Fit to one image instead."
    ),
}
