"""Sandglass: sand as a probabilistic cellular automaton, fast enough to forget about.

A world is a lattice of cells, each of one material; a rule says what materials do and how likely; `advance` runs it.
Nothing here needs a display, so the sand can live in another program or game engine:

    import numpy as np
    from game import Rule, World, advance

    sand, walls = np.zeros((6, 9), bool), np.zeros((6, 9), bool)
    sand[0:3, 4] = True                     # a column of three grains
    walls[5, :] = True                      # over a floor
    world = World.from_cells(sand, walls, seed=1)
    advance(world, Rule.with_p(0.75), 40)   # the friction of the paper's third picture
    for row in np.where(world.walls, "#", np.where(world.sand, "o", ".")):
        print("".join(row))

World      cells, iteration and seed: `from_cells`, `sand`, `walls`, `grains`, `flip`, `copy`, `digest`; of any rule:
           `from_materials`, `materials`, `where`.
Rule       how materials move, a probability for each chance, a schedule: read from a file of pictures by `load_rule`,
           by the name of a shipped rule or by path. `Rule.with_p(p)` is the paper's one-parameter rule of sand.
advance    runs iterations of a rule on a world of its materials, in place.
density    the chance of sand, or of another material, in each cell after some iterations, from many runs at once.
Scene      a world, rule and pace read from a file by `load_scene`, by the name of a shipped scene or by path.

The model is that of Devlin & Schuster, "Probabilistic Cellular Automata for Granular Media in Video Games" (2020).
"""

from importlib import import_module

_MODULES = {
    "Rule": "game.world.rules.rule",
    "RuleError": "game.world.rules.rule_text",
    "Scene": "game.world.scenes.scene",
    "SceneError": "game.world.scenes.scene",
    "World": "game.world.sand.world",
    "advance": "game.world.sand.advance",
    "density": "game.world.sand.ensemble",
    "load_rule": "game.world.rules.rule",
    "load_scene": "game.world.scenes.scene",
    "rule_names": "game.world.rules.definition",
    "scene_names": "game.world.scenes.scene",
}
__all__ = list(_MODULES)


def __getattr__(name):
    """Import a name when it is asked for first: the command line answers before the compiler is loaded."""
    if name not in _MODULES:
        raise AttributeError(f"module 'game' has no attribute {name!r}")
    return getattr(import_module(_MODULES[name]), name)
