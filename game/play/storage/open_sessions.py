"""The open sessions: the one that is played, and those it was opened over, to which the player can return."""

from game.play.window.allocator import trim_heap
from game.world.sand import parameters
from game.world.scenes.scene import ORDER, load_scene, scene_title
from game.world.sessions.action import Load
from game.world.sessions.session import SEEK_NS

LARGE = 2**23  # cells: an act on more takes longer than a frame, and so is announced
FIRST = ORDER[0]  # the scene that the window opens with
MOST_WAITING = 4  # when more sessions wait, the second one is dropped, never the first, the player's own


class Sessions:
    """The session that is played now, and a stack of those that wait, with little memory, the player's own first."""

    def __init__(self, session, journals, notices, on_switch, suited=lambda scene: scene):
        """`on_switch()` is called after another session, or another scene, has taken the place of the one shown.

        suited(scene): returns a scene of one glass in cells that suit the window.
        """
        self.now = session
        self._journals, self._notices, self._on_switch = journals, notices, on_switch
        self.suited = suited
        self._waiting = []
        self._has_waited = False  # in this frame, for the sand to be computed
        self.words = ""  # what is about to be done, for the status line
        self._announced = []  # … and how, in order

    def begin_frame(self):
        """Let `ready` wait again, and do what the last frame has announced."""
        self._has_waited = False
        acts, self.words, self._announced = self._announced, "", []
        for act in acts:
            act()

    def slowly(self, words, act, cells=None):
        """Call act(), which takes long on many cells: then in the next frame, when this one has said so.

        cells: how many it goes over, if not the lattice that is played. What follows something announced waits for it.
        """
        height, width = self.now.world.shape
        if not self._announced and (height * width if cells is None else cells) < LARGE:
            act()
        else:
            self.words = words
            self._announced.append(act)

    def ready(self):
        """Return whether the session's sand is computed; wait for that a little, once a frame, else say so."""
        if not self.now.arrived and not self._has_waited:
            self._has_waited = True
            self.now.catch_up(SEEK_NS)
        if self.now.arrived:
            return True
        self._notices.say("The sand is still being computed.")
        return False

    def do(self, action, join=False):
        """Let a player's act happen; return whether it changed anything.

        join: undo takes it back together with the act before.
        """
        return self.ready() and self.now.do(action, join)

    def load(self, name):
        """Put the shipped scene of that name in place of this one."""
        self.open_shipped(load_scene(name))

    def open_shipped(self, scene):
        """Put a shipped scene in place of this one: the first of them in cells that suit the window."""
        self.open_scene(self.suited(scene) if scene.name == FIRST else scene, self.now.seed)

    def open_scene(self, scene, seed):
        """Put a scene in place of this one, which can be undone; return whether that was done."""
        if not self.ready():
            return False
        self.now.do(Load(scene, seed))
        self._on_switch()
        trim_heap()
        return True

    def open(self, session, keep=False):
        """Play another session; keep this one waiting if `keep` or if anything was done in it."""
        before = self.now
        self._play(session)
        if keep or before.timeline.history.line.before is not None or self._waiting:
            before.limit_memory(parameters.MEMORY.low)
            self._waiting.append(before)
            if len(self._waiting) > MOST_WAITING:
                self._end(self._waiting.pop(1))
        else:
            self._end(before)
        trim_heap()

    def leave(self):
        """Go back to the session that this one was opened over; return whether there is one."""
        if not self._waiting:
            return False
        self._end(self.now)
        self._play(self._waiting.pop())
        trim_heap()
        return True

    @property
    def can_leave(self):
        """Whether this session was opened over another."""
        return bool(self._waiting)

    @property
    def waiting(self):
        """The sessions that wait, the player's own first."""
        return tuple(self._waiting)

    def title_of(self, name):
        """Return the title of a shipped scene, or of the one that is open."""
        scene = self.now.scene
        return scene.title if name == scene.name else scene_title(name)

    def close(self):
        """End the journals of all sessions but the player's own, which the next start can go on with."""
        own, *others = *self._waiting, self.now
        for session in others:
            self._journals.close(session)
        self._journals.leave(own)

    def _play(self, session):
        session.limit_memory(self.now.memory_mb)
        self.now = session
        self._on_switch()

    def _end(self, session):
        """End a session that nobody returns to."""
        self._journals.close(session)
        session.drop_past()
