"""Laws of names: one name means one thing."""

import ast
from collections import Counter
from pathlib import Path

import game


def test_no_two_classes_share_a_name():
    sources = Path(game.__file__).parent.rglob("*.py")
    nodes = (node for source in sources for node in ast.walk(ast.parse(source.read_text("utf-8"))))
    names = Counter(node.name for node in nodes if isinstance(node, ast.ClassDef))
    twice = {name for name, times in names.items() if times > 1}
    assert not twice
