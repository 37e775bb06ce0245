"""Files: saves the scene, and opens scenes, rules, replays and pictures, also those dropped on the window."""

from dataclasses import replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace
from weakref import WeakKeyDictionary

from game.world.background.rule_warmup import make_ready, make_recording_ready
from game.world.files.checked_table import as_line
from game.world.files.paths import asset, folder_of, save_named
from game.world.rules.rule_text import is_rule
from game.world.scenes.picture_file import Photo, SeededScene, open_picture, picture_bytes
from game.world.scenes.scene import Scene, load_scene
from game.world.sessions import recording as replay
from game.world.sessions.recording import Recording, recording_of, replay_bytes
from game.world.sessions.session import Session


def demos():
    """Return the names of the shipped replays."""
    return sorted(path.stem for path in asset("replays").glob(f"*{replay.SUFFIX}"))


class Files:
    """Saves and opens beside the frames, and says on the screen what came of it."""

    def __init__(self, sessions, journals, photo_import, rule_files, name_card, background, notices):
        self._sessions, self._journals, self._photo_import = sessions, journals, photo_import
        self._name_card = name_card
        self._names = WeakKeyDictionary()  # {Scene: what it was saved as, or opened from}
        self._rule_files = rule_files
        self._background, self._notices = background, notices

    def save(self):
        """Save the scene as it is now as a picture in the user's folder, under a name that is asked for once."""
        session = self._sessions.now
        still = SimpleNamespace(
            world=session.world.copy(), scene=session.scene, rule=session.rule, seed=session.seed, clock=session.clock
        )
        if still.scene in self._names:
            self._save(still, self._names[still.scene])
        else:
            self._name_card.ask("Save this scene", still.scene.title, partial(self._save, still))

    def save_replay(self):
        """Save the session that is played as a replay in the user's folder, under a name that is asked for."""
        self._name_card.ask("Save this session as a replay", self._sessions.now.scene.title, self._save_replay)

    def _save(self, still, name):
        name = self._names[still.scene] = name or still.scene.title
        still.scene = replace(still.scene, title=name)

        def work():
            return save_named("scenes", name, ".png", picture_bytes(still))

        self._background.do(work, self._say_saved, writes=True)

    def _save_replay(self, name):
        if self._sessions.ready():
            recording = recording_of(self._sessions.now)
            name = name or recording.scene.title

            def work():
                return save_named("replays", name, replay.SUFFIX, replay_bytes(recording))

            self._background.do(work, self._say_saved, writes=True)

    def _say_saved(self, path):
        self._notices.say(f"Saved as {path}")

    def open(self, path):
        """Open a scene, a rule, a replay, a saved scene or any picture."""
        self._background.do(partial(read, path), self._take)

    def open_shipped(self, name):
        """Put a shipped scene in place of this one: of sand at once, else as soon as its rule is compiled."""
        scene = load_scene(name)
        if scene.rule.is_sand:
            self._sessions.open_shipped(scene)
        else:
            self.open(asset("scenes", f"{name}.toml"))

    def open_made(self, made, name):
        """Open the scene that made() returns, which may take long; the window tells of what it raises on a file."""
        self._background.do(partial(_made_ready, made), lambda scene: self._take((scene, name)))

    def play_demo(self, name):
        """Play a shipped replay."""
        self.open(asset("replays", f"{name}{replay.SUFFIX}"))

    def play(self, recording, name):
        """Play a Recording from its beginning; this session waits behind it."""
        session = Session.retold(recording)
        self._journals.begin(session, recording.entries)
        self._sessions.open(session)
        self._notices.say(recording.problem or f"Replay: {name}. Paint at any time to make it yours.")

    def _take(self, found):
        what, name = found
        if isinstance(what, SeededScene):
            self._names[what.scene] = name
        if isinstance(what, Path):
            self._rule_files.play(what, f"Plays by {name} from now on. Ctrl+Z takes you back.")
        elif isinstance(what, Recording):
            height, width = what.scene.shape
            self._sessions.slowly(f"Opening {name} …", partial(self.play, what, name), height * width)
        elif isinstance(what, Photo):
            self._photo_import.show(what)
        else:
            scene, seed = what if isinstance(what, SeededScene) else (what, self._sessions.now.seed)
            height, width = scene.shape
            self._sessions.slowly(f"Opening {name} …", partial(self._open_scene, scene, seed, name), height * width)

    def _open_scene(self, scene, seed, name):
        opened = scene.problem or f"Opened {name}. Ctrl+Z takes you back."
        waits = f"{name} was not opened: the sand is still being computed."
        self._notices.say(opened if self._sessions.open_scene(scene, seed) else waits)


def read(path):
    """Return what a file holds, and what it is called; raise the file's error, one line, if it is none of these.

    It is a Scene, Recording, SeededScene or Photo; of a rule it is the path alone.
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind == ".toml":
        found: Scene | Recording | SeededScene | Photo | Path = path if is_rule(path) else load_scene(path)
    elif kind == replay.SUFFIX:
        found = replay.load_replay(path)
    else:
        found = open_picture(path)
        if isinstance(found, SeededScene) and path.parent == folder_of("scenes"):
            found = found._replace(scene=replace(found.scene, title=path.stem))
        if isinstance(found, Photo):
            found.picture(in_colours=True)  # which is slow for the first time, and what is shown first
    scene = found.scene if isinstance(found, SeededScene) else found
    if isinstance(scene, Scene):
        _made_ready(lambda: scene)
    elif isinstance(found, Recording):
        make_recording_ready(found)
    return found, as_line(found.title if isinstance(found, Scene) else path.stem)


def _made_ready(made):
    """Return the Scene that made() returns, once its rule is compiled."""
    scene = made()
    if not scene.rule.is_sand:
        make_ready(scene.rule, scene.made_of, scene.cell, scene.coloured, scene.fixtures)
    return scene
