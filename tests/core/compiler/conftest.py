"""Let every test here compile its rules itself, and keep none of them."""

import pytest

from game.core import jit


@pytest.fixture(autouse=True)
def nothing_kept(monkeypatch):
    """Keep no passes between tests or runs."""
    monkeypatch.setattr(jit, "_FOLDER", None)
