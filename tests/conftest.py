"""Let every test run without a display and without a sound card."""

import os

import pytest

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")


@pytest.fixture(autouse=True)
def own_folder(tmp_path, monkeypatch):
    """Keep the user's real files out of reach."""
    monkeypatch.setenv("SANDGLASS_DATA_DIR", str(tmp_path / "data"))
    monkeypatch.setenv("SANDGLASS_CONFIG_DIR", str(tmp_path / "config"))
    return tmp_path / "data"
