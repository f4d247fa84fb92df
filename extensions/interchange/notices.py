"""Texts of the notices of this extension, by code."""

TEXTS = {
    "film.ffmpeg_failed_why": "ffmpeg could not write {file}: {why}",
    "film.opencv_cannot": "OpenCV cannot write {file} on this computer.",
    "film.ffmpeg_failed": "ffmpeg could not write {file}.",
    "film.no_images": "{path} contains no images of the tracked time.",
    "skeleton.bone_unseen": "No skeleton: both ends of a bone are never known at the same time.",
    "skeleton.needs_wrist": "A skeleton requires the wrist. Export all joints.",
    "skeleton.untracked": "No skeleton: {keypoint:word} was never tracked.",
    "urdf.left_handed": "URDF requires right-handed axes; {axes} is left-handed.",
}
