"""The shelf of saved scenes, the newest first; pictures in view are read beside the frames."""

from functools import partial

import pygame

from game.play.pages.shipped_scenes import fitting
from game.play.ui.input import key_name
from game.world.files.atomic import FileError, moved, trouble
from game.world.files.paths import folder_of
from game.world.scenes.open_scene import PICTURES
from game.world.scenes.picture_file import thumbnail_of

AWAY = "put away"  # the folder of scenes that are not to be listed
BATCH = 6  # pictures read at a time
LARGEST = 640, 480  # pixels of a picture that is kept
KEPT = 30  # pictures kept that are out of sight; up to 0.9 MB each


def saved_scenes():
    """Return the paths of the saved scenes, and of photos put beside them, the newest first."""

    def age(path):
        try:
            return path.stat().st_mtime_ns
        except OSError:
            return 0

    pictures = [path for path in folder_of("scenes").glob("*") if path.suffix.lower() in PICTURES and path.is_file()]
    return sorted(pictures, key=age, reverse=True)


class SavedScenes:
    """The user's own scenes."""

    title = "Saved"
    waiting = "no picture"
    empty = (
        f"Nothing is saved yet. {key_name('Ctrl+S')} saves the scene as it is. You can also drop a photo on the window."
    )
    first = 0
    lets_go = True  # scenes can be put away

    def __init__(self, files, background, notices):
        self._files, self._background, self._notices = files, background, notices
        self.paths = []
        self._pictures = {}  # path: a surface, or None where there is no picture in it; the last seen last
        self._sprites = {}  # number: (size, surface) as drawn last
        self._in_sight = []  # paths
        self._reading = False

    def __len__(self):
        return len(self.paths)

    def begin(self):
        """List what is saved now."""
        self.paths, self._pictures, self._sprites, self._in_sight = saved_scenes(), {}, {}, []

    def name(self, number):
        """Return the name of a scene."""
        return self.paths[number].stem

    def about(self, number):
        """Return where a scene is."""
        return str(self.paths[number])

    def picture(self, number):
        """Return the picture of a scene, or None."""
        return self._sprites[number][1] if number in self._sprites else None

    def open(self, number):
        """Play a scene."""
        self._files.open(self.paths[number])

    def put_away(self, number):
        """Move a scene to a folder beside the others, where it is not lost, and say so."""
        path = self.paths[number]
        target = path.parent / AWAY / path.name
        try:
            target.parent.mkdir(exist_ok=True)
            while not moved(path, target):
                target = target.with_stem(f"{target.stem} again")
        except OSError as error:
            self._notices.say(trouble(path, "cannot be put away", error), trouble=True)
            return
        self._notices.say(f"Moved to {target}")
        self.begin()

    def run(self, now_s, rooms):
        """Fit the pictures that were read into their rooms; return the numbers of those that look different."""
        moved = []
        self._in_sight = [self.paths[number] for number in rooms]
        self._forget_some(rooms)
        self._read_on()
        for number, room in rooms.items():
            picture = self._pictures.get(self.paths[number])
            if picture and self._sprites.get(number, (None,))[0] != room:
                self._sprites[number] = room, _fitting(picture, room)
                moved.append(number)
        return moved

    def _read_on(self):
        """Read a few of the pictures in sight that are missing, beside the frames."""
        missing = [path for path in self._in_sight if path not in self._pictures][:BATCH]
        if missing and not self._reading:
            self._reading = True
            self._background.do(partial(_thumbnails, missing), self._take)

    def _take(self, found):
        self._reading = False
        for path, size, data in found:
            self._pictures[path] = pygame.image.frombytes(data, size, "RGB") if size else None

    def _forget_some(self, rooms):
        """Keep the pictures in sight, and of the others those seen last."""
        for path in self._in_sight:
            if path in self._pictures:
                self._pictures[path] = self._pictures.pop(path)
        for path in list(self._pictures)[: -KEPT - len(rooms)]:
            del self._pictures[path]
        self._sprites = {number: sprite for number, sprite in self._sprites.items() if number in rooms}


def _thumbnails(paths):
    """Return [(path, size, RGB bytes)], with (path, None, None) for a file that would not be opened."""
    found = []
    for path in paths:
        try:
            found.append((path, *thumbnail_of(path, LARGEST)))
        except FileError:
            found.append((path, None, None))
    return found


def _fitting(sprite, room):
    """Return the sprite as large as `room` allows."""
    size = fitting(sprite.get_size(), room)
    shrinks = size < sprite.get_size()
    return pygame.transform.smoothscale(sprite, size) if shrinks else pygame.transform.scale(sprite, size)
