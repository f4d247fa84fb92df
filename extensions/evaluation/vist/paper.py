"""Results on people from Lee et al. 2021 (doi:10.1126/scirobotics.abe1315, figs. 3 and 4)."""

from __future__ import annotations

PAPER: dict[str, dict[str, object]] = {
    "free": {
        "mean_mm": 10.69,
        "sd_mm": 5.85,
        "between_sd_mm": 1.57,
        "ci95_mm": [9.90, 11.49],
        "pck20": 78.0,
        "pck35": 99.0,
        "matched_mean": 10.93,
    },
    "object": {
        "mean_mm": 12.68,
        "between_sd_mm": 1.66,
        "ci95_mm": [11.84, 13.52],
        "pck20": 69.0,
        "pck35": 96.0,
    },
    "device": {
        "mean_mm": 10.89,
        "between_sd_mm": 1.53,
        "ci95_mm": [10.11, 11.66],
        "pck20": 79.0,
        "pck35": 98.0,
    },
}

HEAD_NOTE = (
    "The paper contains no figures for this experiment. The estimate is transformed to the "
    "camera's frame with the pose that the camera reports, which has errors of 3 mm and 0.5° per "
    "axis, and the truth with the true pose."
)
"""Note on the experiment with a camera on the head."""

CAVEAT = (
    "These figures are simulated; the paper's are of fifteen people under motion capture. The "
    "simulated people have different hands, fittings, marker placement, sliding cloth, soft-tissue "
    "wobble and imperfect synergies, but no bending bones, no skin that bulges, no cloth that "
    "folds, no motion blur and no error in the reference itself. Expect larger errors on people."
)
