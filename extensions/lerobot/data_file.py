"""Writes one Parquet file of a data set, with its episodes as row groups, and its videos."""

from __future__ import annotations

import json
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from extensions.lerobot.film import DatasetFilm
from extensions.lerobot.frames import Frames, Recorded, frames_of, read_recorded
from extensions.lerobot.layout import ACTION, COUNTERS, STATE, VALID, DatasetCamera, Layout
from extensions.lerobot.plan import Episode
from extensions.lerobot.stats import Stats, image_rows, image_stats, stats_of
from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.messages import IntArray
from tracker.session.export.tables import arrow
from tracker.session.images import image_size
from tracker.session.mcap.ordering import ordered
from tracker.session.message_check import sound
from tracker.session.reader import SessionReader
from tracker.session.ros import sensors, topics

CHUNK = 1000  # files per folder
LARGEST_GROUP = 256 * 2**20
"""Bytes of images per row group of a long episode; one row group is held in memory."""
DATA_PATH = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
VIDEO_PATH = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
READING = 0.5
"""Share of the progress that reading takes for an episode without images."""


class FileJob(NamedTuple):
    """The ``number``-th file of the data set in ``folder``."""

    folder: Path
    number: int
    layout: Layout
    episodes: tuple[Episode, ...]
    tasks: tuple[str, ...]

    @property
    def at(self) -> dict[str, int]:
        return {"chunk_index": self.number // CHUNK, "file_index": self.number % CHUNK}


class WrittenEpisode(NamedTuple):
    """A written episode. ``film_start``: its start in the videos, s; ``image_gap``: the largest
    time between a frame and its image, s."""

    episode: Episode
    file: int
    stats: dict[str, Stats]
    film_start: float
    image_gap: float
    lost: float  # share of unknown values


def write_file(job: FileJob, progress: Callable[[float], None]) -> list[WrittenEpisode]:
    """Write the file. Raises GlovetrackError and any exception of ``progress``."""
    _, pq = arrow()
    path = job.folder / DATA_PATH.format(**job.at)
    path.parent.mkdir(parents=True, exist_ok=True)
    schema = _schema(job.layout)
    plain = [c.key for c in job.layout.cameras]
    total, before = sum(e.frames for e in job.episodes), 0
    out, recorded = [], _Sessions(job.layout)
    with ExitStack() as stack:
        writer = stack.enter_context(
            pq.ParquetWriter(
                path, schema, compression={n: "NONE" if n in plain else "SNAPPY"
                                           for n in schema.names},
                use_dictionary=[*COUNTERS, f"{VALID}.list.element"],
                write_statistics=list(COUNTERS),
            )
        )  # fmt: skip
        films = [stack.enter_context(_film(job, k)) for k in range(len(plain) * job.layout.video)]
        for episode in job.episodes:

            def tell(share: float, e: Episode = episode, before: int = before) -> None:
                progress((before + share * e.frames) / total)

            found = recorded.of(episode.source, lambda share: tell(READING * share))
            sink = _Sink(job, episode, writer, films, frames_of(episode, job.layout, found))
            out.append(sink.write(before, lambda share: tell(READING + (1 - READING) * share)))
            before += episode.frames
    return out


def _film(job: FileJob, k: int) -> DatasetFilm:
    camera = job.layout.cameras[k]
    path = job.folder / VIDEO_PATH.format(video_key=camera.key, **job.at)
    starts = [e.first - job.episodes[0].first for e in job.episodes]
    return DatasetFilm(path, job.layout.fps, camera.kind, starts)


class _Sessions:
    """Caches the last session, since its episodes are consecutive."""

    def __init__(self, layout: Layout) -> None:
        self._layout = layout
        self._path: Path | None = None
        self._read: Recorded | None = None

    def of(self, path: Path, watch: Callable[[float], None]) -> Recorded:
        if self._read is None or path != self._path:
            self._path, self._read = path, None  # two at once would take twice the memory
            self._read = read_recorded(path, self._layout, watch)
        return self._read


@dataclass
class _Sink:
    """Writes an episode in row groups."""

    job: FileJob
    episode: Episode
    writer: Any
    films: list[DatasetFilm]
    frames: Frames
    gap: float = 0.0
    seen: dict[str, list[bytes]] = field(default_factory=dict)

    def write(self, before: int, progress: Callable[[float], None]) -> WrittenEpisode:
        """``before``: number of frames already in this file's videos."""
        e, layout = self.episode, self.job.layout
        start = 0
        for images in self._groups(progress):
            n = len(images[0]) if images else e.frames
            self.writer.write_table(self._table(start, start + n, images), row_group_size=n)
            start += n
        stats = self._stats()
        lost = float(1 - self.frames.valid.mean())
        return WrittenEpisode(e, self.job.number, stats, before / layout.fps, self.gap, lost)

    def _groups(self, progress: Callable[[float], None]) -> Iterator[list[list[bytes]]]:
        """Images of each camera per row group; a single empty group without images or with
        videos."""
        layout, e = self.job.layout, self.episode
        if not layout.cameras:
            yield []
            return
        at = instants(e, layout.fps)
        rows, held, size = image_rows(e.frames), [], 0
        with SessionReader(e.source) as reader:
            nearest = NearestImages(reader, layout.cameras, at)
            for k, images in enumerate(nearest):
                progress(k / e.frames)
                if k in rows:
                    for camera, image in zip(layout.cameras, images, strict=True):
                        self.seen.setdefault(camera.key, []).append(image)
                for film, image in zip(self.films, images, strict=False):
                    film.write(image)
                if not self.films:
                    held.append(images)
                    size += sum(map(len, images))
                if size > LARGEST_GROUP:
                    yield [list(column) for column in zip(*held, strict=True)]
                    held, size = [], 0
            self.gap = nearest.gap
        if self.films:
            yield []
        elif held:
            yield [list(column) for column in zip(*held, strict=True)]

    def _table(self, start: int, stop: int, images: list[list[bytes]]) -> Any:
        pa, _ = arrow()
        frames, layout = self.frames, self.job.layout
        columns = {
            STATE: _lists(pa, frames.state[start:stop]),
            VALID: _lists(pa, frames.valid[start:stop]),
            ACTION: _lists(pa, frames.action[start:stop]),
        }
        for camera, found in zip(layout.cameras, images, strict=False):
            ending = "png" if camera.kind == "png" else "jpg"
            names = [f"frame-{k:06d}.{ending}" for k in range(start, stop)]
            parts = [pa.array(found, pa.binary()), pa.array(names, pa.string())]
            columns[camera.key] = pa.StructArray.from_arrays(parts, ["bytes", "path"])
        for name, values in self._counters().items():
            columns[name] = pa.array(values[start:stop])
        schema = _schema(layout)
        return pa.table([columns[n] for n in schema.names], schema=schema)

    def _counters(self) -> dict[str, Any]:
        e, row = self.episode, np.arange(self.episode.frames)
        task = self.job.tasks.index(e.task)
        return {
            "timestamp": (row / self.job.layout.fps).astype(np.float32),
            "frame_index": row,
            "episode_index": np.full(e.frames, e.number),
            "index": e.first + row,
            "task_index": np.full(e.frames, task),
        }

    def _stats(self) -> dict[str, Stats]:
        f = self.frames
        tables = {STATE: f.state, VALID: f.valid, ACTION: f.action, **self._counters()}
        found = {name: stats_of(values) for name, values in tables.items()}
        return found | {key: image_stats(images) for key, images in self.seen.items()}


def instants(episode: Episode, fps: int) -> IntArray:
    """Times (N,) of the frames in ns since 1970."""
    after = np.round(np.arange(episode.frames) * (NS / fps)).astype(np.int64)
    return np.asarray(episode.start_ns + after)


def _lists(pa: Any, values: np.ndarray) -> Any:
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def _schema(layout: Layout) -> Any:
    """Schema with Hugging Face's metadata, by which `datasets` distinguishes images from bytes."""

    pa, _ = arrow()
    kinds = {"float32": pa.float32(), "int64": pa.int64()}
    columns: list[Any] = []
    features: dict[str, dict[str, Any]] = {}
    for name, feature in layout.features().items():
        if feature["dtype"] == "video":
            continue
        if feature["dtype"] == "image":
            kind = pa.struct([("bytes", pa.binary()), ("path", pa.string())])
            features[name] = {"_type": "Image"}
        elif name in COUNTERS:
            kind = kinds[feature["dtype"]]
            features[name] = {"dtype": feature["dtype"], "_type": "Value"}
        else:
            width = feature["shape"][0]
            kind = pa.list_(kinds[feature["dtype"]], width)
            value = {"dtype": feature["dtype"], "_type": "Value"}
            features[name] = {"feature": value, "length": width, "_type": "Sequence"}
        columns.append(pa.field(name, kind))
    face = json.dumps({"info": {"features": features}})
    return pa.schema(columns, metadata={"huggingface": face})


def file_jobs(
    folder: Path, layout: Layout, episodes: Sequence[Episode], tasks: tuple[str, ...], largest: int
) -> list[FileJob]:
    """Groups episodes into files of about ``largest`` bytes without splitting an episode."""
    groups: list[list[Episode]] = []
    size = np.inf
    for e in episodes:
        numbers = e.frames * 4 * (len(layout.state_names) + len(layout.action_names))
        images = e.size if layout.cameras and not layout.video else 0.0
        if size + numbers + images > largest:
            groups.append([])
            size = 0.0
        groups[-1].append(e)
        size += numbers + images
    return [FileJob(folder, k, layout, tuple(g), tasks) for k, g in enumerate(groups)]


# ---- finds the recorded image nearest in time to each frame

LATE = 2 * NS
"""Largest delay in ns between the exposure and the arrival of an image."""


class NearestImages:
    """Iterates once over the images of ``cameras``; ``gap`` is the largest time between a frame and
    its image so far, s."""

    def __init__(
        self, reader: SessionReader, cameras: Sequence[DatasetCamera], at: IntArray
    ) -> None:
        self._reader, self._at = reader, at
        self._queues = {topics.image(c.name): _Queue(c, at) for c in cameras}

    @property
    def gap(self) -> float:
        return max(q.gap for q in self._queues.values()) / NS

    def __iter__(self) -> Iterator[tuple[bytes, ...]]:
        """One image per camera for each of N frames. Raises FileError if a camera has none,
        ConfigError if its images change their size."""
        queues = list(self._queues.values())
        first, last = int(self._at[0]) - LATE, int(self._at[-1]) + LATE
        wanted = frozenset(self._queues)
        source = self._reader.source
        stored = ordered(source, wanted, max(first, 0), last)
        for raw in sound(stored, source.left_out):
            self._queues[raw.topic].feed(raw.publish_time, raw.data)
            while all(q.decided for q in queues):
                yield tuple(q.decided.popleft() for q in queues)
        for q in queues:
            q.finish(str(self._reader.path))
        while queues[0].decided:
            yield tuple(q.decided.popleft() for q in queues)


class _Queue:
    """Images of one camera that are already known to be the nearest ones of their frames."""

    def __init__(self, camera: DatasetCamera, at: IntArray) -> None:
        self._camera, self._at = camera, at
        self._before: tuple[int, bytes] | None = None
        self._next = 0
        self.decided: deque[bytes] = deque()
        self.gap = 0

    def feed(self, stamp: int, message: bytes) -> None:
        data = sensors.unpack_image(message).data
        if image_size(data) != (self._camera.width, self._camera.height):
            raise ConfigError(notice("lerobot.image_sizes", camera=self._camera.name))
        if self._before is not None:
            middle = (self._before[0] + stamp) // 2
            self._give(int(np.searchsorted(self._at, middle, side="right")))
        self._before = (stamp, data)

    def finish(self, path: str) -> None:
        if self._before is None:
            raise FileError(notice("lerobot.no_images", path=path, camera=self._camera.name))
        self._give(len(self._at))

    def _give(self, end: int) -> None:
        """Assign the previous image to all frames up to ``end``."""
        if self._before is None:
            return
        stamp, data = self._before
        for k in range(self._next, end):
            self.gap = max(self.gap, abs(int(self._at[k]) - stamp))
            self.decided.append(data)
        self._next = max(self._next, end)
