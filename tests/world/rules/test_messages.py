"""Whatever is wrong in a rule file is told in one line: file, line, event, what was found and what is wanted."""

import random

import pytest

from game import RuleError, load_rule
from game.world.rules.rule_text import LARGEST_FILE
from tests.world.rules.small_rule import TEXT, line_of, small_rule, written

PICTURE = 'picture = "l'
HEADER = '[[event]]\nname = "lava and water"'
REACTION = "event 'lava and water': "
SHAPES = "wanted one cell, two cells or 2×2 cells, the same before -> after (or before -> one after | another)"
LETTERS = "the letter of a material or of [any]: ., l, #, k, w, M, X"

WRONG = [  # what is changed, the line that is told, and the message after it
    ("lw -> k.", "lw -> kq", PICTURE, f"{REACTION}picture: found 'q', wanted {LETTERS}"),
    ("lw -> k.", "lww -> k..", PICTURE, f"{REACTION}picture: found parts of 2, 3 cells in a row, {SHAPES}"),
    ("lw -> k. | kw", "lw", PICTURE, f"{REACTION}picture: found 1 rows of 1 parts, {SHAPES}"),
    ("lw -> k. | kw", "l? -> k. | k?", PICTURE, f"{REACTION}picture: found '?' that becomes '.', wanted a cell that"),
    ("lw -> k.", "lw -> kX", PICTURE, f"{REACTION}picture: found 'X' in the after picture alone, wanted a letter"),
    (
        '"boil", 0.25',
        '"boll", 0.25',
        'chance = ["',
        f"{REACTION}chance: found 'boll', wanted a number in [0, 1], a name in",
    ),
    (
        '"boil", 0.25',
        '"boil"',
        'chance = ["',
        f"{REACTION}chance: found 1 of them, wanted one for each after picture (2)",
    ),
    ('"boil", 0.25', '"boil", 1.5', 'chance = ["', f"{REACTION}chance: found 1.5, wanted a number in [0, 1]"),
    ('"boil", 0.25', '"boil", 0.75', HEADER, f"{REACTION[:-2]}: chance: found 1.25 in all, wanted at most 1 in all"),
    ("M sinks in X", "M floats on X", "where", "event 'fall': where: found 'M floats on X', wanted 'X sinks in Y' or"),
    ("M sinks in X", "M sinks in w", "where", "event 'fall': where: found 'M sinks in w', wanted 'X sinks in Y' or"),
    ("liquid, powder", "liquid, sead", 'M = "', "any: M: found 'sead', wanted one of everything, empty, powder"),
    (
        'layer = "motion"\nwhere',
        'layer = "moton"\nwhere',
        'layer = "moton',
        "event 'fall': layer: found 'moton', wanted one of",
    ),
    (
        'name = "fall"',
        'name = "flow"',
        'name = "flow"\nlayer = "motion"\nchance',
        "event 'flow': name: found it a second time, wanted a name",
    ),
    ('name = "fall"', 'nmae = "fall"', "nmae", "event 2: nmae: found an unknown key, wanted name"),
    (
        'letter = "k"',
        'letter = "l"',
        "stone =",
        "materials: stone: found the letter 'l', which is that of lava, wanted",
    ),
    ('letter = "k"', 'letter = "K"', "stone =", "materials: stone: found letter = 'K', wanted letter to be one sign"),
    ("density = 60, ", "", "stone =", "materials: stone: found no density, wanted density to be in [-1000, 1000]"),
    ('"powder", d', '"sand", d', "stone =", "materials: stone: found class = 'sand', wanted class to be one of empty"),
    ("#94918c", "grey", "stone =", "materials: stone: found colour = 'grey', wanted colour to be as in \"#3b7ddd\""),
    (
        "flow = 0.5",
        "flaw = 0.5",
        "water =",
        "materials: water: found 'flaw', wanted a number that an event asks for: flow",
    ),
    (
        'flow = "slow"',
        'flow = "sloow"',
        "lava =",
        "materials: lava: found flow = 'sloow', wanted a probability in [0, 1]",
    ),
    ('"solid"', '"powder", density = 1', "wall =", "materials: wall: found another class, wanted a solid 'wall'"),
    ("value = 0.25", "value = 2", "slow =", "chances: slow: found 2, wanted a probability in [0, 1]"),
    ("boil = 0.5", "schedule = 0.5", "schedule =", "chances: schedule: found that name, wanted small letters"),
    (
        '"lava + stone"',
        '"lava + sand"',
        'sum = "lava',
        "conserve 1: sum: found 'lava + sand', wanted materials, each once",
    ),
    (
        '["lava and water"]',
        '["lava and ice"]',
        "but = [",
        "conserve 2: but: found 'lava and ice', wanted names of events",
    ),
    (
        '["lava and water"]',
        '["lava and water", "fall"]',
        '[[conserve]]\nsum = "water',
        "conserve: but: found 'fall', wanted only events",
    ),
    ("lw -> k.", "lw -> ..", HEADER, f"{REACTION[:-2]}: found wl/.. -> ../.., wanted lava + stone to be kept"),
    ("lw -> k. | kw", "#w -> kw | #w", HEADER, f"{REACTION[:-2]}: found a change of wall, wanted wall to stay wall"),
    ('title = "Small"', "title = Small", "title", "line 1, column 9: found broken TOML (Invalid value), wanted key ="),
    ('title = "Small"', 'titel = "Small"', "titel", "titel: found an unknown key, wanted title"),
    ('title = "Small"', 'schedule = "Paper"', "schedule", "schedule: found 'Paper', wanted one of margolus, paper"),
    ('title = "Small"', 'include = ["../motion"]', "include", "include: found '../motion', wanted names of rule files"),
    ('title = "Small"', 'include = ["montion"]', "include", "include: found 'montion', wanted a file montion.toml"),
]


@pytest.mark.parametrize(("old", "new", "place", "said"), WRONG, ids=[new for _, new, _, _ in WRONG])
def test_what_is_wrong_is_told_with_its_line(old, new, place, said, tmp_path):
    path = written(tmp_path, (old, new))
    with pytest.raises(RuleError) as error:
        load_rule(path)
    text = path.read_text(encoding="utf-8")
    line = text[: text.index(place)].count("\n") + 1
    assert str(error.value).startswith(f"{path}:{line}: {said}") and len(str(error.value).splitlines()) == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("#" * (LARGEST_FILE + 1), f"file: found a larger file, wanted at most {LARGEST_FILE} bytes"),
        ("x = " + "[" * 20_000, "TOML: found a number or a nesting out of bounds, wanted ordinary numbers and tables"),
        ("x = " + "9" * 20_000, "TOML: found a number or a nesting out of bounds, wanted ordinary numbers and tables"),
        ("", "materials: found 0 materials, wanted 3 to 16"),
        ("[materials]\nair = 3\nwall = 4", "materials: found 2 materials, wanted 3 to 16"),
        ("materials = 3", "materials: found 3, wanted a table [materials]"),
        ("[materials]\nair = 3\nwall = 4\nlava = 5", "materials: air: found 3, wanted a table [air]"),
        ("event = 3\n[materials]", "materials: found 0 materials"),
        ("include = [" + '"motion",' * 5 + "]", "include: found an array of 5, wanted a list of at most 4 names"),
        ("[chances]\n" + "\n".join(f"c{n} = 0.5" for n in range(49)), "chances: found 49 of them, wanted at most 48"),
    ],
)
def test_what_is_no_rule_is_told(text, said, tmp_path):
    path = tmp_path / "no.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(RuleError) as error:
        load_rule(path)
    assert said in str(error.value) and len(str(error.value).splitlines()) == 1


def test_a_rule_in_which_nothing_can_happen_is_told(tmp_path):
    text = TEXT[: TEXT.index("[any]")] + '[any]\nG = "gas"\n[[event]]\nname = "fade"\npicture = "G -> ."\n'
    path = tmp_path / "still.toml"
    path.write_text(text.replace(", flow = 0.5", "").replace(', flow = "slow"', ""), encoding="utf-8")
    with pytest.raises(RuleError, match=r"still.toml:\d+: event: found none that can happen, wanted one that matches"):
        load_rule(path)


def test_too_many_events_are_told(tmp_path):
    many = "".join(f'[[event]]\nname = "{n}"\npicture = "l -> l"\n' for n in range(97))
    with pytest.raises(RuleError, match="event: found 100 of them, wanted at most 96"):
        small_rule(tmp_path, ('[[event]]\nname = "fall"', f'{many}[[event]]\nname = "fall"'))


@pytest.mark.parametrize("name", ["sead", "", "a\0b", "no/such.toml", "sand.toml"])
def test_a_rule_that_is_not_there_is_told(name):
    with pytest.raises(RuleError, match=r"rule: found no such file, wanted a rule.*, or one of sand, alchemy"):
        load_rule(name)


def test_a_folder_is_no_rule(tmp_path):
    with pytest.raises(RuleError, match="found a folder, wanted a text file"):
        load_rule(tmp_path)


def test_lines_are_counted_past_pictures(tmp_path):
    with pytest.raises(RuleError) as error:
        small_rule(tmp_path, ('chance = "M.flow"', 'chance = "M.flow!"'))
    assert f"small.toml:{line_of('M.flow')}: event 'flow': chance" in str(error.value)


PIECES = [
    *"'\"[]{}=?.,#|>-\n 0MXlkwé",
    "->",
    "1e999",
    "nan",
    "true",
    "9" * 30,
    "[[event]]",
    "[any]",
    "'''",
    "wall",
    "{}",
    "[]",
]


@pytest.mark.parametrize("seed", range(20))
def test_a_damaged_file_is_a_rule_or_told_in_one_line(seed, tmp_path):
    draw, path = random.Random(seed), tmp_path / "damaged.toml"
    for _ in range(5):
        text = TEXT
        for _ in range(draw.randint(1, 3)):
            start = draw.randrange(len(text))
            text = text[:start] + draw.choice(PIECES) + text[start + draw.randint(0, 6) :]
        path.write_text(text, encoding="utf-8")
        try:
            load_rule(path)
        except RuleError as error:
            assert len(str(error).splitlines()) == 1 and str(error).startswith(str(path))
