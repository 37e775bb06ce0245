"""The recorder: takes pictures of the window and the sand, and films of what follows or of the last seconds."""

import io
import queue
from functools import partial

import numpy as np
import pygame

from game.play.storage.clipboard import put_picture
from game.play.storage.films.film import Film, rgb
from game.play.storage.films.film_file import FilmFile
from game.play.storage.films.formats import encoder_of
from game.world.files.paths import new_name, save_new
from game.world.looks import painter as picture
from game.world.looks.themes import SAND, substances_of
from game.world.looks.view import View
from game.world.sessions.moment import Lookahead, Moment
from game.world.sessions.snapshots import nearest

FRAME_MS = 40  # of a film: 25 frames per second
PAST_S = 10
LONGEST_S = 120  # of a recording
LARGEST_PICTURE = 4096  # pixels a side of a picture of the sand whose cells are larger than a pixel
BAND = 2**20  # pixels of a picture of the sand drawn at a time: drawing takes over twenty bytes for each
MOST_WAITING = 500  # frames that the writer may be behind, or the recording ends: they are kept in memory


class Recorder:
    """Takes pictures and records; all writing is done beside the frames."""

    def __init__(self, sessions, display, settings, background, notices):
        self._sessions, self._display, self._settings = sessions, display, settings
        self._background, self._notices = background, notices
        self._film = self._frames = None  # while recording: the Film, and the queue to its writer
        self._since_s = self._last_s = None
        self._share = None  # of the last seconds that has been written, while that goes on
        self._sizes = {}  # {what is being written: its bytes so far}

    @property
    def said(self):
        """What the status line says of a recording, or ""."""
        size = sum(list(self._sizes.values()))
        if self.going_on and self._since_s is not None:
            return f"Recording {self._last_s - self._since_s:.0f} s    {spelled(size)}    G stops it"
        if self._share is not None:
            return f"Writing the last {PAST_S} seconds: {100 * self._share:.0f} %    {spelled(size)}"
        return f"Writing the recording    {spelled(size)}" if self._sizes else ""

    @property
    def going_on(self):
        """Whether what happens is being recorded."""
        return self._frames is not None

    def shoot_window(self):
        """Save a picture of the window as it is."""
        surface = self._display.window.front.copy()
        self._save_picture(partial(image_of, surface))

    def shoot_sand(self):
        """Save a picture of the sand, its cells as many whole pixels wide as they are on the screen."""
        self._save_picture(self._picture_of_sand())

    def copy_sand(self):
        """Put that picture on the clipboard."""
        draw = self._picture_of_sand()
        done = "The picture is on the clipboard."
        self._background.do(lambda: put_picture(_png(draw())), lambda _: self._notices.say(done))

    def _picture_of_sand(self):
        """Return a function without arguments that draws it."""
        shown, streams = self._sessions.now.world, self._sessions.now.streams
        world = shown.copy()
        streams = streams.copy(world) if streams and streams.follows(shown) else None
        most = LARGEST_PICTURE // max(world.shape)
        scale = max(1, min(round(self._display.sand_view.view.cell), most))
        return partial(image_of_sand, world, scale, *self._looks(), streams)

    def _save_picture(self, draw):
        """Save the image that draw() returns, beside the frames."""
        name = self._sessions.now.scene.name

        def work():
            return save_new("pictures", name, ".png", _png(draw()))

        self._background.do(work, lambda path: self._notices.say(f"Picture saved as {path}"), writes=True)

    def toggle(self):
        """Record what follows, or end that."""
        if self.going_on:
            self.stop()
            return
        session = self._sessions.now
        self._film = Film(session.world.shape, session.scene.cell, *self._looks())
        self._frames = frames = queue.SimpleQueue()  # unbounded, so that putting never waits
        self._since_s = self._last_s = None
        work = partial(self._write, session.scene.name, self._film, iter(frames.get, None))
        self._background.do(work, self._say_where, partial(self._give_up, frames), writes=True)

    def stop(self):
        """End the recording of what follows, if one goes on."""
        if self.going_on:
            self._frames.put(None)
            self._frames = None

    def update(self, now_s):
        """Record the sand of this frame, if one is due; never wait for the writer."""
        if not self.going_on:
            return
        self._since_s = now_s if self._since_s is None else self._since_s
        passed_ms = FRAME_MS if self._last_s is None else (now_s - self._last_s) * 1e3
        if passed_ms < FRAME_MS - 1:
            return
        world = self._sessions.now.world
        if world.shape != self._film.shape or now_s - self._since_s > LONGEST_S:
            self.stop()
        elif self._frames.qsize() >= MOST_WAITING:
            self.stop()
            self._notices.say("The recording ends: the disk is too slow for it.", trouble=True)
        else:
            self._frames.put((self._film.frame(world), passed_ms))
            self._last_s = now_s

    def record_past(self):
        """Record the last seconds again, from the timeline."""
        session = self._sessions.now
        if self._share is not None or not self._sessions.ready():
            return
        end, speed = session.now, session.clock.speed
        start = max(0, end - round(PAST_S * speed))
        count = max(1, round((end - start) / speed * 1000 / FRAME_MS))
        ats = [start + (end - start) * number // count for number in range(count + 1)]
        film = Film(session.world.shape, session.scene.cell, *self._looks())
        self._share = 0.0
        again = _again(session.timeline, ats)
        frames = self._counted(film, again, len(ats))
        work = partial(self._write, session.scene.name, film, frames, self._forget_share)
        self._background.do(work, self._say_where, writes=True)

    def _counted(self, film, worlds, count):
        for number, world in enumerate(worlds, 1):
            if world.shape == film.shape:
                yield film.frame(world), FRAME_MS
            self._share = number / count

    def _looks(self):
        """Return the colours of the theme, what the walls are made of, and what the cells can hold."""
        session = self._sessions.now
        return self._display.colours, session.scene.made_of, substances_of(session.rule.definition.materials)

    def _forget_share(self):
        self._share = None

    def _give_up(self, frames):
        """End the recording, if it is the one whose writer has failed."""
        if self._frames is frames:
            self._frames = None

    def _write(self, name, film, frames, at_the_end=None):
        """Write frames (pixels, milliseconds) of a film to a new file; return its path and size in words."""
        encoder = encoder_of(self._settings["recording"])(film.colours, film.zoom)
        file = None
        try:
            file = FilmFile(new_name("pictures", name, encoder.suffix), encoder)
            for pixels, ms in frames:
                file.add(pixels, ms)
                self._sizes[file] = file.size
            path = file.close()
            return f"{path} ({spelled(path.stat().st_size)})"
        except Exception:
            if file:
                file.drop()
            raise
        finally:
            self._sizes.pop(file, None)
            if at_the_end:
                at_the_end()

    def _say_where(self, path_and_size):
        self._notices.say(f"Recorded as {path_and_size}")


def image_of(surface):
    """Return the image of what is on a surface."""
    from PIL import Image

    return Image.frombytes("RGB", surface.get_size(), pygame.image.tobytes(surface, "RGB"))


def image_of_sand(world, scale, colours, walls, substances=SAND, streams=None):
    """Return an image of a world, `scale` pixels to a cell, drawn in bands for the sake of memory.

    streams: the MotionSamples of the world, if falling sand is drawn by them.
    """
    from PIL import Image

    height, width = (side * scale for side in world.shape)
    painter = picture.Painter(View(world.shape, 0, 0, width, height), colours, walls, substances=substances)
    image = Image.new("RGB", (width, height))
    for top in range(0, height, max(1, BAND // width)):
        pixels = np.empty((min(max(1, BAND // width), height - top), width), np.uint32)
        painter.look_through(View(world.shape, 0, -top, width, height, (0, 0, width, len(pixels))))
        painter.draw(world, pixels, streams=streams)
        image.paste(Image.fromarray(rgb(pixels)), (0, top))
    return image


def _again(timeline, ats):
    """Return an iterator over the worlds at the iterations `ats`, ascending, computed apart from the timeline."""
    first = timeline.history.latest(ats[0])
    snapshot = nearest(first, ats[0])
    moment = snapshot.moment() if snapshot else Moment.start(*timeline.start)
    lookahead = Lookahead(moment, timeline.history.after(snapshot.act if snapshot else timeline.history.root))

    def worlds():
        for at in ats:
            lookahead.run_to(at)
            yield lookahead.world

    return worlds()


def spelled(size):
    """Return a number of bytes as people say it."""
    return f"{size / 1e6:.1f} MB" if size >= 1e5 else f"{size / 1e3:.0f} kB"


def _png(image):
    """Return the PNG of a Pillow image."""
    file = io.BytesIO()
    image.save(file, "PNG")
    return file.getvalue()
