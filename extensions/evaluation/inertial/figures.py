"""Draws figures like 9 and 10 of Lemak et al. 2020 as PNG files."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from extensions.evaluation.inertial.errors import draw
from extensions.evaluation.inertial.estimators import BETAS, ESTIMATORS
from extensions.evaluation.inertial.experiment import ErrorRow
from extensions.evaluation.inertial.motion import grasp
from tracker.inertial.finger import Finger

FIGURE_9_T_M = 1.0  # s
_SIZE = (9.0, 6.5)
_TITLES = {"white": "white noise", "offset": "zero offset", "both": "both errors"}


def save_figures(rows: list[ErrorRow], finger: Finger, folder: Path, rate_hz: float) -> list[Path]:
    """Save all figures for which there are rows; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    made = {f"trajectory_{rate_hz:g}Hz": trajectory(finger, rate_hz)}
    for rate in sorted({r.rate_hz for r in rows}):
        at_rate = [r for r in rows if r.rate_hz == rate and r.condition == "vertical"]
        made[f"rms_{rate:g}Hz"] = rms(at_rate, rate)
        made[f"beta_{rate:g}Hz"] = beta(at_rate, rate)
    return [_save(figure, folder / f"inertial_{name}.png") for name, figure in made.items()]


def _save(figure: Figure, path: Path) -> Path:
    figure.savefig(path, dpi=150)
    return path


def trajectory(finger: Finger, rate_hz: float, t_m: float = FIGURE_9_T_M) -> Figure:
    """Figure 9: angles and rates of the motion at the top, errors of the estimators below."""
    motion = grasp(finger, t_m, rate_hz)
    readings = draw(len(motion.t), "both", rate_hz, (0,)).planar(motion.ideal)
    figure = Figure(_SIZE, layout="constrained")
    axes = figure.subplots(2, 2, sharex=True)
    for k in range(3):
        axes[0, 0].plot(motion.t, np.rad2deg(motion.theta[:, k]), label=f"phalanx {k}")
        axes[0, 1].plot(motion.t, np.rad2deg(motion.omega[:, k]))
    for name, make in ESTIMATORS.items():
        theta = make(finger, 1 / rate_hz).run(readings)
        for k in range(2):
            error = np.rad2deg(theta[:, k] - motion.theta[:, k])
            axes[1, k].plot(motion.t, error, label=name, lw=1)
    labels = ("angle, °", "rate, °/s", "error of phalanx 0, °", "error of phalanx 1, °")
    for ax, label in zip(axes.flat, labels, strict=True):
        ax.set_ylabel(label)
        ax.grid(alpha=0.3)
    for ax in axes[1]:
        ax.set_ylim(-15, 15)
        ax.set_xlabel("time, s")
    axes[0, 0].legend()
    axes[1, 0].legend(fontsize=7, ncols=2)
    figure.suptitle(f"Test motion of {t_m:g} s at {rate_hz:g} Hz, both sensor errors")
    return figure


def rms(rows: list[ErrorRow], rate_hz: float) -> Figure:
    """Figure 10: RMS error as a function of the motion's duration, one panel per series."""
    series = [s for s in _TITLES if any(r.series == s for r in rows)]
    figure = Figure((2.0 + 4.5 * len(series), 5.0), layout="constrained")
    axes = np.atleast_1d(figure.subplots(1, len(series), sharey=True))
    named = [n for n in dict.fromkeys(r.estimator for r in rows) if not _is_variant(n)]
    for ax, s in zip(axes, series, strict=True):
        for i, name in enumerate(named):
            _curve(ax, [r for r in rows if r.series == s and r.estimator == name], name, i)
        _log_axes(ax, _TITLES[s])
    figure.legend(*axes[-1].get_legend_handles_labels(), loc="outside right upper", fontsize=8)
    figure.suptitle(f"RMS error at {rate_hz:g} Hz; bands reach over the seeds")
    return figure


def beta(rows: list[ErrorRow], rate_hz: float) -> Figure:
    """β and the kinematic compensation: noise only on the left, both errors on the right."""
    figure = Figure(_SIZE, layout="constrained")
    axes = figure.subplots(1, 2, sharey=True)
    styles = {"central": "-", "backward": "--", "plain": ":"}
    for ax, s in zip(axes, ("white", "both"), strict=True):
        for i, value in enumerate(BETAS):
            for kind, style in styles.items():
                name = f"madgwick_{kind}_{value:g}"
                found = [r for r in rows if r.series == s and r.estimator == name]
                _curve(ax, found, f"β {value:g}, {kind}", i, style)
        _log_axes(ax, _TITLES[s])
    axes[0].legend(fontsize=7)
    figure.suptitle(f"Madgwick filter at {rate_hz:g} Hz: β and compensation")
    return figure


def _is_variant(name: str) -> bool:
    return name.split("_")[-1] in {f"{b:g}" for b in BETAS}


def _curve(ax: Axes, rows: list[ErrorRow], label: str, colour: int, style: str = "-") -> None:
    found = sorted(rows, key=lambda r: r.t_m)
    if not found:
        return
    t_m = [r.t_m for r in found]
    shade = mpl.color_sequences["tab20"][2 * colour % 20 + (2 * colour) // 20]
    ax.plot(t_m, [r.rms_deg for r in found], style, color=shade, label=label, lw=1.2)
    low, high = [r.low_deg for r in found], [r.high_deg for r in found]
    ax.fill_between(t_m, low, high, color=shade, alpha=0.12, lw=0)


def _log_axes(ax: Axes, title: str) -> None:
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_title(title)
    ax.set_xlabel("duration of the motion, s")
    ax.set_ylabel("RMS error, °")
    ax.grid(alpha=0.3, which="both")
