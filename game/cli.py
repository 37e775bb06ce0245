"""The command line: play, headless, rule, export, bench and study."""

import argparse
import sys
from importlib.util import find_spec
from pathlib import Path

from game import process
from game.world.sand import parameters

SCENE = "hourglass"
OF_SCENE = ("scene", "p", "seed", "size")  # options that a replay decides itself, …
ALSO_OF_HEADLESS = ("frames",)  # … and without a window this one too
STUDY_NEEDS = ("matplotlib", "rich", "scipy")  # packages of the `study` extra …
BENCH_NEEDS = ("rich",)  # … of which the bench needs this one, …
PICTURE_NEEDS = ("matplotlib",)  # … and this one for its picture
STUDY_EXTRA = "pip install 'sandglass[study]'"


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        """Say what is wrong in one line and leave with status 2."""
        self.exit(2, f"{self.prog}: {message} (--help lists what there is)\n")

    def _print_message(self, message, file=None):
        """Print, and raise OSError where that is not possible: argparse would keep it to itself."""
        if message:
            (file or sys.stderr).write(message)


def main(arguments=None):
    """Run the command that `arguments` (default: the process's own) name and return the exit status."""
    return process.run(lambda: _answered(sys.argv[1:] if arguments is None else list(arguments)))


def _answered(arguments):
    """Run the command; refuse in one line where a file that came with the toy is damaged."""
    from game.world.files.atomic import FileError

    try:
        return _command(arguments)
    except FileError as error:
        return _refuse(error)


def _command(arguments):
    if arguments[:1] == ["headless"]:
        options = _headless_parser().parse_args(arguments[1:])
        _refuse_beside_replay(options, ALSO_OF_HEADLESS)
        return _headless(options) if options.replay is None else _replay(options)
    if arguments[:1] == ["rule"]:
        return _rule(_rule_parser().parse_args(arguments[1:]))
    if arguments[:1] == ["export"]:
        return _export(_export_parser().parse_args(arguments[1:]))
    if arguments[:1] == ["bench"]:
        return _bench(_bench_parser().parse_args(arguments[1:]))
    if arguments[:1] == ["study"]:
        return _study(_study_parser().parse_args(arguments[1:]))
    options = _play_parser().parse_args(arguments)
    _refuse_beside_replay(options)
    return _play(options)


def _refuse_beside_replay(options, also=()):
    """Leave with status 2 and one line where a replay is asked for and something that it decides itself."""
    if options.replay is not None:
        given = [name for name in (*OF_SCENE, *also) if getattr(options, name) is not None]
        if given:
            raise SystemExit(_refuse(f"--replay and --{given[0]} do not go together: the recording decides that"))


def _setting(each):
    """Return an argparse type that reads `each` knob."""

    def parse(text):
        try:
            return each.parse(text)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    return parse


def _size(text):
    """Read 'WIDTHxHEIGHT' in cells."""
    parts = text.lower().split("x")
    if len(parts) != 2:
        raise argparse.ArgumentTypeError(f"size must be WIDTHxHEIGHT in cells, as in 480x270, got {text!r}")
    return tuple(map(_setting(parameters.SIDE), parts))


def _duration(text):
    """Read a time such as '3m' in seconds."""
    from game.world.sand.duration import parse_duration

    try:
        return parse_duration(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _scene_options(parser):
    parser.add_argument(
        "--scene", metavar="NAME|FILE", help=f"a shipped scene, a scene file or a picture (default: {SCENE})"
    )
    parser.add_argument(
        "--p", type=_setting(parameters.P), help="probability that grains topple, 0 … 1 (default: the scene's)"
    )
    parser.add_argument(
        "--seed", type=_setting(parameters.SEED), help=f"{parameters.SEED.meaning} (default: the scene's)"
    )
    parser.add_argument("--size", type=_size, metavar="WxH", help="size of the lattice in cells (default: the scene's)")


def _play_parser():
    parser = _Parser(
        prog="sandglass",
        description="A falling-sand toy: paint sand and walls, and turn the glass over.",
        epilog="other commands: headless (time frames without a window), rule (read a rule and check it), "
        "export (a rule as a C header), bench (measure the speed), study (check the model); each has its own --help",
    )
    _scene_options(parser)
    parser.add_argument("--replay", metavar="FILE", help="play a recorded session")
    parser.add_argument(
        "--timer",
        type=_duration,
        metavar="TIME",
        help="start a timer of 3m, 90s, 1:30 or 1h; without --scene, in a glass made for it",
    )
    parser.add_argument(
        "--cell", type=_setting(parameters.CELL), metavar="PX", help=f"{parameters.CELL.meaning}, in pixels"
    )
    parser.add_argument("--fullscreen", action="store_true", help="start in full screen")
    parser.add_argument("--ui-scale", type=_setting(parameters.UI_SCALE), help=parameters.UI_SCALE.meaning)
    return parser


def _headless_parser():
    parser = _Parser(prog="sandglass headless", description="Play frames without a window and time them.")
    _scene_options(parser)
    parser.add_argument(
        "--frames",
        type=_setting(parameters.FRAMES),
        help=f"{parameters.FRAMES.meaning} (default: {parameters.FRAMES.default})",
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--replay", metavar="FILE", help="compute a recorded session to its end")
    return parser


def _rule_parser():
    parser = _Parser(
        prog="sandglass rule",
        description="Tell what a rule says: its materials, the laws that it keeps, and how likely each event is.",
    )
    parser.add_argument("rule", metavar="NAME|FILE", help="a shipped rule or a rule file")
    parser.add_argument("--out", type=Path, metavar="FILE.png", help="draw it in a picture instead")
    return parser


def _export_parser():
    parser = _Parser(
        prog="sandglass export",
        description="Write a rule as one C header for any engine, which moves every cell as Sandglass does.",
    )
    parser.add_argument(
        "--rule", metavar="NAME|FILE", help="a shipped rule or a rule file (default: that of the scene, or sand)"
    )
    parser.add_argument(
        "--scene",
        metavar="NAME|FILE",
        help="what it starts with: a shipped scene, a scene file or a picture (default: a small hourglass)",
    )
    parser.add_argument(
        "--out",
        type=Path,
        required=True,
        metavar="DIR",
        help="where sandglass.h, example.c and README.md go; a file there that no export wrote is left as it is",
    )
    return parser


def _bench_parser():
    parser = _Parser(
        prog="sandglass bench",
        description="Measure how fast the sand is, beside the paper, other programs and the memory.",
    )
    parser.add_argument(
        "--quick", action="store_true", help="smaller lattices and fewer rounds: a minute instead of seven"
    )
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="write the tables as README.md and JSON, with a picture"
    )
    return parser


def _study_parser():
    parser = _Parser(
        prog="sandglass study",
        description="Compare the sand, row by row, with what is expected; exit with status 1 if a row disagrees.",
    )
    parser.add_argument("--quick", action="store_true", help="about a minute, with larger errors")
    parser.add_argument(
        "--out",
        type=Path,
        default=Path("study"),
        metavar="DIR",
        help="where README.md, the whole report and its pictures go",
    )
    parser.add_argument("--part", action="append", metavar="NAME", help="run only this part; may be repeated")
    return parser


def _load(options):
    """Return the scene and the seed that the options ask for, or leave with status 2 and one line."""
    from game.world.scenes.open_scene import load_start
    from game.world.scenes.picture_file import PictureError
    from game.world.scenes.scene import SceneError

    try:
        scene, seed = load_start(SCENE if options.scene is None else options.scene, options.size)
    except (SceneError, PictureError) as error:
        raise SystemExit(_refuse(error)) from None
    if options.p is not None and not scene.rule.is_sand:
        raise SystemExit(_refuse(f"--p: found it with the rule {scene.rule.definition.name}, wanted a scene of sand"))
    if scene.problem:
        print(f"sandglass: {scene.problem}", file=sys.stderr)
    return scene, seed if options.seed is None else options.seed


def _headless(options):
    from game import headless

    scene, seed = _load(options)
    frames = parameters.FRAMES.default if options.frames is None else options.frames
    report = headless.run(scene, frames, options.p, seed)
    print(headless.text(report, options.json))
    _warn_of_cache()
    return headless.status(report)


def _warn_of_cache():
    """Say in one line that kernels could not be kept, or read, where that is so."""
    from game.world.background.kernel_warmup import cache_trouble

    if words := cache_trouble():
        print(f"sandglass: {words}", file=sys.stderr)


def _load_replay(options):
    """Return the Recording the options ask for, or leave with status 2 and one line."""
    from game.world.sessions.recording import ReplayError, load_replay

    try:
        recording = load_replay(options.replay)
    except ReplayError as error:
        raise SystemExit(_refuse(error)) from None
    if recording.problem:
        print(f"sandglass: {recording.problem}", file=sys.stderr)
    return recording


def _replay(options):
    from game import headless

    report = headless.replay(_load_replay(options))
    print(headless.replay_text(report, options.json))
    _warn_of_cache()
    return headless.replay_status(report)


def _rule(options):
    from game.world.files.atomic import FileError
    from game.world.rules.rule import load_rule
    from game.world.rules.rule_text import RuleError

    try:
        rule = load_rule(options.rule)
        if options.out is not None:
            from game.world.rules.rule_picture import save_picture

            save_picture(rule, options.out)
        else:
            from game.world.rules.description import description

            print("\n".join(description(rule)))
    except (RuleError, FileError) as error:
        return _refuse(error)
    return 0


def _export(options):
    from game.export import command
    from game.world.files.atomic import FileError

    try:
        print("\n".join(command.run(options.rule, options.scene, options.out)))
    except FileError as error:
        return _refuse(error)
    return 0


def _bench(options):
    if missing := _missing(BENCH_NEEDS):
        return _refuse(f"the bench needs {missing}: {STUDY_EXTRA}")
    if missing := options.out and _missing(PICTURE_NEEDS):
        return _refuse(f"--out draws a picture and needs {missing}: {STUDY_EXTRA}")
    from game.study.bench import command
    from game.world.files.atomic import FileError

    try:
        return command.run(options.quick, options.json, options.out)
    except FileError as error:
        return _refuse(f"the tables cannot be written: {error}")


def _study(options):
    if missing := _missing(STUDY_NEEDS):
        return _refuse(f"the study needs {missing}: {STUDY_EXTRA}")
    from game.study import run
    from game.world.files.atomic import FileError

    parts = options.part or list(run.PARTS)
    unknown = [name for name in parts if name not in run.PARTS]
    if unknown:
        return _refuse(f"the study has no part {unknown[0]!r}; its parts are {', '.join(run.PARTS)}")
    try:
        return run.run(options.quick, options.out, parts)
    except FileError as error:
        return _refuse(f"the report cannot be written: {error}")


def _missing(packages):
    """Return those of the packages that are not installed, as words."""
    return " and ".join(name for name in packages if find_spec(name) is None)


def _refuse(words):
    """Say in one line why nothing is done and return status 2."""
    print(f"sandglass: {words}", file=sys.stderr)
    return 2


def _settings(flags):
    """Return the user's settings, with the flags that were given over them; say in one line what is wrong with them."""
    from game.world.files.settings import Settings

    settings = Settings.of_user()
    if settings.problem:
        print(f"sandglass: {settings.problem}", file=sys.stderr)
    for name, value in flags.items():
        if value is not None:
            settings.override(name, value)
    return settings


def _scene_to_play(options, recording):
    """Return scene and seed: the recording's, those asked for, or for a timer without a scene a glass that suits it."""
    if recording:
        return recording.scene, recording.seed
    if options.timer and options.scene is None:
        from game.world.scenes.hourglass_maker import glass_within, scene_for, scene_of

        try:
            scene = scene_of(glass_within(*options.size)) if options.size else scene_for(options.timer)
            return scene, parameters.SEED.default if options.seed is None else options.seed
        except ValueError as error:
            raise SystemExit(_refuse(error)) from None
    return _load(options)


def _suits_window(options):
    """Return whether the scene may be made in other cells than its own: nobody has asked for just this lattice."""
    return options.replay is None and options.scene in (None, SCENE) and not (options.size or options.cell)


def _play(options):
    recording = None if options.replay is None else _load_replay(options)
    scene, seed = _scene_to_play(options, recording)
    from game.play import loop

    settings = _settings({"ui_scale": options.ui_scale})
    try:
        of_window = settings, seed, options.p, options.cell, options.fullscreen
        loop.play(scene, *of_window, recording, options.timer, suits=_suits_window(options))
        return process.leave_threads(0)
    except loop.NoDisplayError as error:
        print(f"sandglass: no display to open a window on ({error}); running headless instead")
        if recording:
            options.json = False
            return _replay(options)
        options.frames, options.json = None, False
        return _headless(options)
