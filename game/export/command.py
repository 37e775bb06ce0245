"""The command: a rule, and a scene of it, into a folder."""

from game.export.files import NAMES, files
from game.export.folder import write_all
from game.export.start_scene import scene_start, small_start
from game.world.files.atomic import FileError
from game.world.rules.rule import load_rule
from game.world.scenes.open_scene import load_start


def run(rule_name, scene_name, folder):
    """Write the header of a rule, an example and a README to a folder; return the lines that tell of it.

    scene_name: what the example starts with; None for a small hourglass. rule_name None: the scene's rule. Raises
    FileError, with one line to show.
    """
    start = _start(rule_name, scene_name)
    try:
        texts = files(start)
    except ValueError as error:
        raise FileError(f"{scene_name}: scene: {error}") from None
    write_all(folder, texts)
    return [
        f"{start.rule.definition.title}, {start.told}: {', '.join(NAMES)} in {folder}",
        *(f"left out: {each}" for each in start.left_out),
        f"try it: cc -O2 {folder / 'example.c'} -o example && ./example",
    ]


def _start(rule_name, scene_name):
    if scene_name is None:
        return small_start(load_rule("sand" if rule_name is None else rule_name))
    scene = load_start(scene_name).scene
    if rule_name is not None:
        rule = load_rule(rule_name)
        if rule.definition != scene.rule.definition:
            found = scene.rule.definition.name
            raise FileError(f"{scene_name}: rule: found {found}, wanted a scene of {rule.definition.name}")
    return scene_start(scene)
