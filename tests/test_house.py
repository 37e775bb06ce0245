"""Laws of the house: one name means one thing, and a folder is small enough to look through."""

import re
from collections import Counter
from pathlib import Path

import game

SOURCES = [*Path(game.__file__).parent.rglob("*.py")]
CLASS = re.compile(r"^ *class (\w+)\b.*:$", re.MULTILINE)
MOST = 20  # modules in a folder


def test_no_two_classes_share_a_name():
    names = Counter(name for source in SOURCES for name in CLASS.findall(source.read_text("utf-8")))
    twice = {name for name, times in names.items() if times > 1}
    assert not twice


def test_no_folder_has_more_modules_than_one_can_look_through():
    folders = Counter(source.parent for source in SOURCES if source.name != "__init__.py")
    assert {str(folder): count for folder, count in folders.items() if count > MOST} == {}
