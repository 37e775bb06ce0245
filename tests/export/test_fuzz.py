"""Whatever a caller hands over, an exported header stays in its memory and in what C defines."""

import pytest

from game import rule_names
from tests.export.library import FOLDER, STRICT, builds, run, texts_of
from tests.sweeps import sweep

SANITIZERS = ("-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
QUICK = ("rolling-sand", "-O0")


@sweep(("name", "level"), [QUICK, *((name, "-O1") for name in rule_names())], keep=[QUICK])
def test_a_header_called_at_random_keeps_to_its_memory(name, level, tmp_path):
    compiler = builds()[0].split()[0]
    (tmp_path / "sandglass.h").write_text(texts_of(name)["sandglass.h"], encoding="utf-8")
    flags = ("-std=c99", *STRICT, *SANITIZERS, level, "-I", tmp_path)
    try:
        run(compiler, *flags, FOLDER / "fuzz.c", "-o", tmp_path / "fuzz")
    except AssertionError as error:
        if "cannot find" in str(error):
            pytest.skip(f"{compiler} has no sanitizers here")
        raise
    assert run(tmp_path / "fuzz") == "well\n"
