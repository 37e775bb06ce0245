"""The shelves of the player's files: scenes, stamps and replays; pictures in view are made beside the frames."""

from functools import partial
from typing import NamedTuple

import pygame

from game.play.pages.shipped_scenes import fitting
from game.play.ui.input import key_name
from game.play.view.scene_picture import picture_of
from game.world.files.atomic import FileError, load, moved, trouble
from game.world.files.paths import file_stem, folder_of
from game.world.scenes.open_scene import PICTURES
from game.world.scenes.picture_file import SeededScene, open_picture, size_of, thumbnail_of
from game.world.sessions import recording as replay
from game.world.sessions.session_format import LARGEST_FILE

AWAY = "put away"  # the folder of files that are not to be listed
BATCH = 6  # pictures made at a time
LARGEST = 640, 480  # pixels of a picture that is kept
KEPT = 30  # pictures kept that are out of sight; up to 0.9 MB each
MOST_PAINTED = 2**22  # cells: of larger scenes the picture shows the plain colours of its cells
BY_AGE, BY_NAME = "Newest first", "By name"


class FileKind(NamedTuple):
    """What a shelf holds."""

    title: str
    folder: str  # of the user's files
    suffixes: tuple
    empty: str  # what there is to say of a shelf without files
    scene_in: object  # a function of a path that returns the Scene to be shown, or None for the picture in the file


class FileShelf:
    """The user's own files of a kind, which can be renamed, deleted and sorted."""

    waiting = "no picture"
    first = 0
    lets_go = True  # files can be deleted

    def __init__(self, kind, on_open, display, background, notices):
        """`on_open(path)` is called for the file that the player chooses."""
        self.title, self.empty, self._kind, self._on_open = kind.title, kind.empty, kind, on_open
        self._display, self._background, self._notices = display, background, notices
        self.paths = []
        self.order = BY_AGE
        self._done = []  # (where a file is now, where it was), of what can be taken back
        self._pictures = {}  # path: a surface, or None where there is no picture in it; the last seen last
        self._sprites = {}  # number: (size, surface) as drawn last
        self._in_sight = []  # paths
        self._reading = False

    def __len__(self):
        return len(self.paths)

    def begin(self):
        """List what there is now."""
        self._list()
        self._pictures = {}

    def name(self, number):
        """Return the name of a file."""
        return self.paths[number].stem

    def about(self, number):
        """Return where a file is."""
        return str(self.paths[number])

    def picture(self, number):
        """Return the picture of a file, or None."""
        return self._sprites[number][1] if number in self._sprites else None

    def open(self, number):
        """Open a file."""
        self._on_open(self.paths[number])

    def sort(self):
        """List the files in the other order."""
        self.order = BY_NAME if self.order == BY_AGE else BY_AGE
        self._list()

    def put_away(self, number):
        """Move a file to a folder beside the others, where it is not lost, and say so."""
        path = self.paths[number]
        target = path.parent / AWAY / path.name
        try:
            target.parent.mkdir(exist_ok=True)
            while not moved(path, target):
                target = target.with_stem(f"{target.stem} again")
        except OSError as error:
            self._notices.say(trouble(path, "cannot be put away", error), trouble=True)
            return
        self._done.append((target, path))
        self._notices.say(f"Moved to {target}. {key_name('Ctrl+Z')} brings it back.")
        self._list()

    def rename(self, number, name):
        """Call a file by another name, and return its number now."""
        path = self.paths[number]
        target = path.with_name(f"{file_stem(name)}{path.suffix}")
        if target == path or not name:
            return number
        if self._move(path, target):
            self._done.append((target, path))
        return self._number_of(target, number)

    @property
    def can_take_back(self):
        """Whether anything was deleted or renamed here."""
        return bool(self._done)

    def take_back(self):
        """Undo the last deletion or renaming; return the number of its file, or None."""
        if not self._done:
            return None
        now, before = self._done.pop()
        return self._number_of(before, None) if self._move(now, before) else None

    def run(self, now_s, rooms):
        """Fit the pictures that were made into their rooms; return the numbers of those that look different."""
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

    def _list(self):
        paths = [path for path in folder_of(self._kind.folder).glob("*") if path.suffix.lower() in self._kind.suffixes]
        key = _age if self.order == BY_AGE else lambda path: (path.name.casefold(), path.name)
        self.paths = sorted((path for path in paths if path.is_file()), key=key, reverse=self.order == BY_AGE)
        self._sprites, self._in_sight = {}, []

    def _move(self, path, target):
        """Move a file, and return whether that was possible; else say why it was not."""
        try:
            there = not moved(path, target)
        except OSError as error:
            self._notices.say(trouble(path, "cannot be renamed", error), trouble=True)
            return False
        if there:
            self._notices.say(f"There is a {target.name} already.", trouble=True)
        if path in self._pictures and not there:
            self._pictures[target] = self._pictures.pop(path)
        self._list()
        return not there

    def _number_of(self, path, otherwise):
        return self.paths.index(path) if path in self.paths else otherwise

    def _read_on(self):
        """Make a few of the pictures in sight that are missing, beside the frames."""
        missing = [path for path in self._in_sight if path not in self._pictures][:BATCH]
        if missing and not self._reading:
            self._reading = True
            work = partial(_thumbnails, missing, self._kind.scene_in, self._display.colours)
            self._background.do(work, self._take)

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


def _age(path):
    try:
        return path.stat().st_mtime_ns
    except OSError:
        return 0


def scene_in_picture(path):
    """Return the Scene that a picture was saved of, or None for a photo or a huge scene; raise FileError."""
    width, height = size_of(path)
    if width * height > MOST_PAINTED:
        return None
    found = open_picture(path)
    return found.scene if isinstance(found, SeededScene) else None


def start_of_replay(path):
    """Return the Scene that a replay begins with; raise FileError."""
    data = load(path, LARGEST_FILE)
    recording, _ = replay.parse(data[: data.find(b"\n") + 1], path)
    return recording.scene


SCENES = FileKind(
    "Saved",
    "scenes",
    tuple(PICTURES),
    f"Nothing is saved yet. {key_name('Ctrl+S')} saves the scene as it is. You can also drop a photo on the window.",
    scene_in_picture,
)
STAMPS = FileKind(
    "Stamps",
    "stamps",
    tuple(PICTURES),
    f"No stamp is kept yet. Select a piece ({key_name('Shift+S')}), then {key_name('Ctrl+K')} keeps it.",
    scene_in_picture,
)
REPLAYS = FileKind(
    "Replays",
    "replays",
    (replay.SUFFIX,),
    f"No replay is saved yet. {key_name('Ctrl+Shift+S')} saves what you did in this session.",
    start_of_replay,
)


def _thumbnails(paths, scene_in, colours):
    """Return [(path, size, RGB bytes)], with (path, None, None) for a file that would not be opened."""
    found = []
    for path in paths:
        try:
            found.append((path, *_thumbnail(path, scene_in, colours)))
        except FileError:
            found.append((path, None, None))
    return found


def _thumbnail(path, scene_in, colours):
    scene = scene_in(path)
    if scene is not None and scene.cells.size <= MOST_PAINTED:
        return picture_of(scene, LARGEST, colours)
    return thumbnail_of(path, LARGEST)


def _fitting(sprite, room):
    """Return the sprite as large as `room` allows."""
    size = fitting(sprite.get_size(), room)
    shrinks = size < sprite.get_size()
    return pygame.transform.smoothscale(sprite, size) if shrinks else pygame.transform.scale(sprite, size)
