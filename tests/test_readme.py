"""What the READMEs say is so."""

import contextlib
import io
import re
from importlib.util import find_spec
from pathlib import Path

import pygame
import pytest

from game import SceneError, cli, load_rule, load_scene, rule_names, scene_names
from game.play.controls.keymap import CTRL, KEYS, SHIFT
from game.world.rules import definition, events, materials
from game.world.rules.laws import laws
from game.world.rules.pictures import MOST_OUTCOMES
from game.world.rules.rule_text import LARGEST_FILE

ROOT = Path(__file__).parents[1]
FIRST = ROOT / "README.md"
PLAYING = ROOT / "game" / "play" / "README.md"
CODE = ROOT / "game" / "README.md"
RULES = ROOT / "assets" / "rules" / "README.md"
SCENES = ROOT / "assets" / "scenes" / "README.md"
READMES = sorted([FIRST, *(ROOT / "game").rglob("README.md"), *(ROOT / "assets").rglob("README.md")])

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
each_readme = pytest.mark.parametrize("readme", READMES, ids=lambda path: str(path.relative_to(ROOT)))


def text_of(readme):
    return readme.read_text(encoding="utf-8")


def prose(readme):
    """Return a README without its code blocks."""
    return FENCE.sub("", text_of(readme))


def inline_code(readme):
    return re.findall(r"`([^`\n]+)`", prose(readme))


def blocks(readme, language):
    return [code for kind, code in FENCE.findall(text_of(readme)) if kind == language]


def section(readme, title):
    """Return what stands below a heading, as far as the next one."""
    return re.split(r"\n##+ ", text_of(readme).split(f"\n{title}\n", 1)[1])[0]


def anchors(readme):
    """Return what a link can name of a README: its headings, as code hosts spell them."""
    headings = re.findall(r"^#+ (.*)$", prose(readme), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def rows(readme, head):
    """Return the first cells of all tables whose first column is called `head`."""
    tables = re.findall(rf"^\| {head} \|.*\n\|[-|: ]+\|\n((?:\|.*\n)+)", text_of(readme), re.MULTILINE)
    return [line.split(" | ")[0].removeprefix("| ") for table in tables for line in table.splitlines()]


def test_the_first_page_is_read_in_one_sitting():
    assert len(text_of(FIRST).splitlines()) <= 200


@pytest.mark.parametrize("title", ["## Run", "## Test"])
def test_one_line_sets_everything_up(title):
    assert FENCE.findall(section(FIRST, title))[0][1].count("\n") == 1


@each_readme
def test_every_example_prints_what_is_shown_below_it(readme):
    fences = FENCE.findall(text_of(readme))
    for number, (kind, code) in enumerate(fences):
        if kind == "python":
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(code, {})
            assert fences[number + 1] == ("", printed.getvalue())


def test_there_is_an_example():
    assert blocks(FIRST, "python")


@each_readme
def test_every_scene_shown_is_a_scene(readme, tmp_path):
    for code in blocks(readme, "toml") if readme != RULES else ():
        path = tmp_path / "scene.toml"
        path.write_text(code, encoding="utf-8")
        scene = load_scene(path)
        assert scene.sand.any() and scene.walls.any()


def test_every_rule_shown_is_a_rule_that_keeps_its_laws(tmp_path):
    for code in blocks(RULES, "toml"):
        path = tmp_path / "rule.toml"
        path.write_text(code, encoding="utf-8")
        rule = load_rule(path)
        assert all(law.holds for law in laws(rule.definition, rule.values))


def test_a_scene_is_shown():
    assert len(blocks(SCENES, "toml")) == 2


@each_readme
def test_no_code_is_shown_that_no_test_runs(readme):
    """Plain blocks are the two one-liners, run by CI, and what examples print; `text` is no code."""
    kinds = [kind for kind, _ in FENCE.findall(text_of(readme))]
    assert set(kinds) <= {"", "python", "toml", "text"}
    assert kinds.count("") == kinds.count("python") + 2 * (readme == FIRST)


def help_of(words):
    """Return what says which flags a command takes: its help, or the source of a program of its own."""
    if words[:2] == ["python", "-m"]:
        return Path(find_spec(words[2]).origin).read_text(encoding="utf-8")
    said = io.StringIO()
    with contextlib.redirect_stdout(said), pytest.raises(SystemExit):
        cli.main([*(word for word in words[2:3] if not word.startswith("-")), "--help"])
    return said.getvalue()


@each_readme
def test_every_command_and_flag_shown_is_there(readme):
    for code in inline_code(readme):
        words = code.split()
        if re.match(r"(\.venv/bin/)?python (main\.py|-m)\b|--\w", code):
            known = help_of(words)
            assert all(re.search(rf"{word}\b", known) for word in words if word.startswith("--")), code


@each_readme
def test_every_link_leads_somewhere(readme):
    for target in LINK.findall(prose(readme)):
        if target.startswith("https://"):
            continue
        path, _, anchor = target.partition("#")
        found = (readme.parent / path).resolve() if path else readme
        assert found.exists(), target
        assert not anchor or anchor in anchors(found), target


@each_readme
def test_every_file_named_is_there(readme):
    for code in inline_code(readme):
        if re.fullmatch(r"(game|tests|assets|\.ci)/[\w./-]*|[\w/]+\.py|[a-z]+/", code):
            assert (ROOT / code).exists() or (readme.parent / code).exists(), code


def test_every_picture_kept_is_shown():
    shown = {(readme.parent / target).resolve() for readme in READMES for target in LINK.findall(prose(readme))}
    kept = [*(ROOT / "assets" / "pictures").iterdir(), *(ROOT / "game").rglob("*.png")]
    assert [path for path in kept if path not in shown] == []


def test_every_folder_of_the_code_is_on_the_map():
    folders = {f"{path.parent.relative_to(ROOT).as_posix()}/" for path in (ROOT / "game").rglob("__init__.py")}
    floors = {"game/", "game/play/", "game/study/", "game/world/"}
    assert {code.strip("`") for code in rows(CODE, "folder")} == folders - floors


def test_every_shipped_scene_has_a_line():
    assert sorted(rows(SCENES, "name")) == sorted(f"`{name}`" for name in scene_names())


def test_every_shipped_rule_has_a_line():
    assert sorted(rows(RULES, "name")) == sorted(f"`{name}`" for name in rule_names())


def test_the_limits_of_a_rule_are_those_of_the_code():
    told = dict(re.findall(r"^\| (.*) \| ([\d,]+) \|$", text_of(RULES), re.MULTILINE))
    limits = {words: int(number.replace(",", "")) for words, number in told.items()}
    assert limits == {
        "bytes of a file": LARGEST_FILE,
        "files included, which include no others": definition.MOST_INCLUDES,
        "layers": definition.MOST_LAYERS,
        "events, with those included": events.MOST,
        "outcomes of an event, whose chances are 1 at most in all": MOST_OUTCOMES,
        "conditions in `where`": events.MOST_CONDITIONS,
        "chances": definition.MOST_CHANCES,
        "sums in `[[conserve]]`": definition.MOST_BOOKS,
    }
    assert f"| `[materials]` | 3 to {materials.MOST}; " in text_of(RULES)


@pytest.mark.parametrize(
    "wrong",
    [
        "qqq = 1",
        'walls = "qqq"',
        "[rule]\nqqq = 1",
        '[rule]\nschedule = "qqq"',
        "[[tap]]\nqqq = 1",
        "[[drain]]\nqqq = 1",
        '[[tap]]\nx = 1\ny = 1\ncolour = "qqq"',
        '[[shape]]\nkind = "qqq"',
        '[[shape]]\nkind = "line"\nmaterial = "qqq"',
        '[[shape]]\nkind = "line"\nmaterial = "sand"\ncolour = "qqq"',
        *(f'[[shape]]\nkind = "{kind}"\nqqq = 1' for kind in ("hourglass", "line", "bars", "pegs", "slats")),
    ],
)
def test_whatever_a_scene_file_may_say_is_described(wrong, tmp_path):
    """The message for a wrong word lists the right ones."""
    path = tmp_path / "wrong.toml"
    path.write_text(f"width = 9\nheight = 9\n{wrong}", encoding="utf-8")
    with pytest.raises(SceneError) as error:
        load_scene(path)
    wanted = str(error.value).rpartition("one of ")[2].split(", ")
    described = inline_code(SCENES) + inline_code(ROOT / "game" / "core" / "README.md")  # where the probabilities are
    assert len(wanted) > 1 and set(wanted) <= set(re.findall(r"\w+", " ".join(described)))


def spelled(code, mods):
    """Return a key as the READMEs spell it."""
    name = pygame.key.name(code).title().replace("Escape", "Esc")
    return f"{'Ctrl+' * (mods & CTRL == CTRL)}{'Shift+' * (mods & SHIFT == SHIFT)}{name}"


def keys_shown(readme):
    return {key for cell in rows(readme, "key") for key in re.findall(r"`([^`]+)`", cell)}


def labels_without_a_code():
    """Return what the help calls the keys and buttons that are heard elsewhere."""
    return {key.label.split(",")[0] for key in KEYS if not key.codes}


def test_every_command_is_shown_with_a_key():
    shown = keys_shown(PLAYING)
    told = {key.command for key in KEYS if shown & {spelled(code, key.mods) for code in key.codes}}
    assert told == {key.command for key in KEYS if key.codes}
    assert labels_without_a_code() <= shown


@pytest.mark.parametrize("readme", [FIRST, PLAYING])
def test_every_key_shown_is_one(readme):
    keys = {spelled(code, key.mods) for key in KEYS for code in key.codes}
    assert keys_shown(readme) <= keys | labels_without_a_code()
