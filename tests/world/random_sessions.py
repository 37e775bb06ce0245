"""Random sessions: what hypothesis lets a player do, and the plain twin that computes a story from its start."""

import numpy as np
from hypothesis import strategies as st

from game import Rule, advance
from game.world.rules.rule import SCHEDULES
from game.world.sand.fixtures import Fixture
from game.world.sand.sand_colours import DYES
from game.world.sand.stamp import Stamp
from game.world.scenes.hourglass_spec import Glass
from game.world.scenes.scene import Scene
from game.world.sessions.action import (
    ANCHORS,
    SHAPES,
    Clear,
    Draw,
    Fill,
    Flip,
    Load,
    Move,
    Paint,
    Paste,
    Reshape,
    Resize,
    SetFixtures,
    SetRule,
    Turn,
    apply,
)
from game.world.sessions.history import WAIT
from game.world.sessions.session import Session
from tests.cells import coloured, random_world


def scene_of(number, height=24, width=30):
    """Return a small scene strewn at random, with colours where the number is odd."""
    generator = np.random.default_rng(number)
    world = random_world(generator, height, width)
    colours = coloured(world, generator).colours if number % 2 else None
    rule = Rule.with_p((1.0, 0.5)[number % 2], "balanced")
    return Scene(f"scene{number}", f"Scene {number}", "", world.materials, rule, 100.0 + number, 4, colours=colours)


SCENES = [scene_of(0), scene_of(1), scene_of(2, 9, 140)]
places = st.tuples(st.floats(-4, 34), st.floats(-4, 28))
chances = st.sampled_from((0.0, 0.25, 0.7, 1.0))
dyes = st.sampled_from(DYES)
figures = st.sampled_from(("rectangle", "ellipse"))
turns = st.one_of(st.just(Flip()), st.builds(Turn, st.integers(1, 3)))
rules = st.builds(Rule, *[chances] * 7, st.sampled_from(sorted(SCHEDULES)))
sides = st.integers(12, 40)
glasses = st.builds(
    Glass,
    sides,
    sides,
    st.integers(0, 3),
    st.integers(0, 3),
    st.floats(1, 9),
    fill=st.floats(0, 1),
    material=st.sampled_from(("", "water", "lava")),
)
reshapes = st.builds(Reshape, glasses, st.booleans())
resizes = st.builds(Resize, sides, sides, st.sampled_from(sorted(ANCHORS)))


def stamp_of(number, fixtures=()):
    """Return a small Stamp at random, of sand with colours or of other materials, with some fixtures."""
    generator = np.random.default_rng(number)
    names = (("air", "sand", "wall"), ("air", "lava", "wall", "water", "sand"))[number % 2]
    cells = generator.integers(0, len(names), generator.integers(1, 12, 2), np.uint8)
    colours = generator.integers(0, 8, cells.shape, np.uint8) * (cells == 1) if number % 4 == 0 else None
    stamp = Stamp(names, cells, colours, tuple(fixtures))
    return stamp.mirrored() if number % 3 else stamp.turned(number % 4)


def fixtures_of(materials):
    """Return what makes a Fixture, of one of some materials if it is a tap."""
    return st.builds(
        Fixture,
        st.sampled_from(("tap", "drain")),
        st.integers(-3, 30),
        st.integers(-3, 24),
        st.integers(1, 9),
        st.integers(1, 3),
        st.integers(1, 9),
        st.sampled_from(("amber", "teal", "rainbow")),
        st.sampled_from(materials),
    )


def tools_of(materials):
    """Return what makes an act of a tool with one of some materials, or of the eraser."""
    painted = st.sampled_from(("erase", *materials))
    plain = st.builds(Paint, painted, places, places, st.integers(1, 9), st.booleans())
    shaped = st.builds(
        Paint,
        painted,
        places,
        places,
        st.integers(1, 9),
        shape=st.sampled_from(sorted(SHAPES)),
        only=st.sampled_from(("", "empty", *materials)),
        spray=st.integers(0, 3),
        colour=dyes,
    )
    draws = st.builds(Draw, figures, painted, places, places, st.integers(0, 3), colour=dyes)
    return st.one_of(plain, shaped, draws, st.builds(Fill, painted, places, dyes))


def actions_of(tools, fixtures, rules, scenes):
    """Return what makes any act of a player with such tools, fixtures, rules and scenes."""
    fittings = st.builds(SetFixtures, st.lists(fixtures, max_size=4).map(tuple))
    loads = st.builds(Load, st.sampled_from(scenes), st.integers(0, 3))
    stamps = st.builds(stamp_of, st.integers(0, 9), st.lists(fixtures, max_size=1))
    pastes = st.builds(Paste, stamps, places, st.booleans())
    moves = st.builds(Move, places, places, places, st.integers(0, 3), st.booleans())
    return st.one_of(
        tools,
        tools,
        pastes,
        moves,
        resizes,
        fittings,
        reshapes,
        st.builds(SetRule, rules),
        loads,
        turns,
        st.just(Clear()),
    )


def plays_of(actions):
    """Return what makes the commands of a session with such acts."""
    commands = st.one_of(
        st.tuples(st.just("run"), st.integers(0, 30)),
        st.tuples(st.just("do"), actions, st.booleans()),
        st.tuples(st.just("undo"), st.booleans()),
        st.tuples(st.just("redo"), st.booleans()),
        st.tuples(st.just("seek"), st.integers(0, 150)),
    )
    return st.lists(commands, max_size=25)


fixtures = fixtures_of(("sand",))
actions = actions_of(tools_of(("sand", "wall", "gold")), fixtures, rules, SCENES)
plays = plays_of(actions)


class Listener:
    """A journal that keeps what it hears in memory."""

    def __init__(self):
        self.entries = []

    def note(self, entry):
        if entry.what != WAIT:
            self.entries.append(entry)


def obey(session, command):
    """Let a session do one command."""
    kind, *values = command
    if kind == "run":
        session.timeline.run(*values)
    else:
        getattr(session, kind)(*values)


def played(play, scene=SCENES[1], seed=5):
    """Return the Session after the commands of `play`, with a Listener."""
    session = Session(scene, seed)
    session.journal = Listener()
    for command in play:
        obey(session, command)
    return session


def plain_world(scene, seed, entries, now):
    """Return (world, rule) at iteration `now` of acts in order, computed from the start and by nothing else."""
    world, rule, at = scene.world(seed), scene.rule, 0
    for entry in entries:
        if entry.at > now:
            break
        advance(world, rule, entry.at - at)
        world, rule = apply(entry.what, world, rule)
        at = entry.at
    advance(world, rule, now - at)
    return world, rule


def state(session):
    """Return all that must be equal for two sessions to be at the same moment."""
    return session.now, session.world.digest(), session.rule, session.scene.name, session.account
