"""MP4, by the ffmpeg that is found on PATH: plays everywhere as a video."""

import shutil
import subprocess
import tempfile

import numpy as np

from game.play.storage.films.film_file import enlarged

PROGRAM = "ffmpeg"
EVEN = "pad=ceil(iw/2)*2:ceil(ih/2)*2"  # the sides that the usual pixels of a video must have


class Mp4Encoder:
    """Hands frames to ffmpeg, which writes the file."""

    suffix = ".mp4"
    unit_ms = 40  # 25 frames per second

    def __init__(self, colours, zoom=1):
        """`colours`: the RGB bytes of the palette. `zoom`: pixels across a pixel of the frames."""
        self._palette, self._zoom = np.frombuffer(colours, np.uint8).reshape(-1, 3), zoom
        self._program = None
        self._said = tempfile.TemporaryFile()  # noqa: SIM115 - what ffmpeg complains of, until the film ends

    def begin(self, part, shape):
        """Write to a Part."""
        height, width = (side * self._zoom for side in shape)
        frames = "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{1000 // self.unit_ms}"
        video = "-vf", EVEN, "-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-movflags", "+faststart"
        self._program = subprocess.Popen(
            [PROGRAM, "-v", "error", "-y", *frames, "-i", "-", "-an", *video, "-f", "mp4", part.path],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._said,
        )

    def write(self, before, now, ms):
        """Write a frame, which follows another or None."""
        frame = enlarged(self._palette[now], self._zoom).tobytes()
        try:
            for _ in range(ms // self.unit_ms):
                self._program.stdin.write(frame)
        except OSError:
            raise self._trouble() from None

    def end(self):
        """Let the program finish."""
        try:
            self._program.stdin.close()
        except OSError:
            raise self._trouble() from None
        if self._program.wait():
            raise self._trouble()
        self._said.close()

    def drop(self):
        """Leave nothing behind."""
        if self._program:
            self._program.kill()
            self._program.wait()
        self._said.close()

    def _trouble(self):
        """Return what the program has said last as an OSError."""
        self._program.kill()
        self._program.wait()
        self._said.seek(0)
        lines = self._said.read().decode("utf-8", "replace").split("\n")
        return OSError(next((f"{PROGRAM}: {line}" for line in reversed(lines) if line.strip()), f"{PROGRAM} ended"))


def is_there():
    """Return whether there is an ffmpeg to write with."""
    return shutil.which(PROGRAM) is not None
