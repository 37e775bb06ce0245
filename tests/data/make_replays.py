"""Records the demos in assets/replays: `python -m tests.data.make_replays`, again whenever a scene in them changed."""

import math
from itertools import pairwise

from game.world.files.paths import asset
from game.world.rules.rule import Rule
from game.world.scenes.scene import load_scene
from game.world.sessions.action import Clear, Flip, Load, Paint, SetRule
from game.world.sessions.recording import SUFFIX
from game.world.sessions.session import Session
from tests.saved import save_replay


def three_turns():
    """Turn the hourglass over three times, each time with more friction."""
    session = Session(load_scene("hourglass"), seed=1)
    for p in (0.6, 0.4, 0.2):
        session.timeline.run(2400)
        session.do(SetRule(Rule.with_p(p, "balanced")))
        session.do(Flip())
    session.timeline.run(2400)
    return session


def draw(session, material, points, diameter, wait):
    """Draw a stroke through points (column, row), `wait` iterations from one to the next."""
    for number, (start, end) in enumerate(pairwise(points)):
        session.do(Paint(material, start, end, diameter), join=number > 0)
        session.timeline.run(wait)


def builder():
    """Draw a bowl on the blank scene, pour a wave of sand over it, open the bowl, think better of one wall."""
    session = Session(load_scene("blank"), seed=2)
    bowl = [(120 + 70 * math.cos(k * math.pi / 12), 90 + 60 * math.sin(k * math.pi / 12)) for k in range(13)]
    draw(session, "wall", bowl, 4, 0)
    draw(session, "sand", [(60 + 4 * k, 20 + 10 * math.sin(k / 3)) for k in range(31)], 9, 12)
    draw(session, "wall", [(40, 10), (200, 10)], 3, 60)
    session.undo()
    session.timeline.run(300)
    draw(session, "erase", [(120, 140), (120, 160)], 8, 0)
    session.timeline.run(900)
    return session


def rooms():
    """Go from scene to scene: a flood, a cleared table, another size of the paper's glass."""
    session = Session(load_scene("sandpile"), seed=3)
    session.timeline.run(1200)
    draw(session, "sand", [(40 + 5 * k, 100) for k in range(30)], 12, 4)
    session.do(Clear())
    session.timeline.run(50)
    session.do(Load(load_scene("paper", (121, 121)), 4))
    session.timeline.run(600)
    session.do(SetRule(Rule.with_p(0.75, "margolus", -0.3)))
    session.timeline.run(500)
    session.do(Flip())
    session.timeline.run(800)
    return session


DEMOS = {"three-turns": three_turns, "builder": builder, "rooms": rooms}


def main():
    """Record every demo."""
    for name, play in DEMOS.items():
        path = asset("replays") / f"{name}{SUFFIX}"
        save_replay(path, play())
        print(f"{path.name}: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
