"""What an exported README shows is built and run, with stand-ins for the engines' own classes."""

import os
import re

import numpy as np
import pytest

from game import World, advance, load_rule
from game.export.start_scene import small_start
from tests.export.library import FOLDER, STRICT, builds, compiler_of, needs, run, texts_of
from tests.sweeps import sweep

STAND_INS = FOLDER / "stand_ins"
FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
FRAMES, ITERATIONS = 20, 4
GDSCRIPT = """
extends SceneTree
func _init():
	var script = NativeScript.new()
	script.library = load("res://sand.gdnlib")
	script.set_class_name("SandWorld")
	script.new().run()
	quit()
"""


@pytest.fixture
def out(tmp_path):
    """Return a folder with the files that export sand."""
    for name, text in texts_of("sand").items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


def shown(language, number=0):
    """Return a block of code in the README."""
    found = [code for kind, code in FENCE.findall(texts_of("sand")["README.md"]) if kind == language]
    return found[number]


def command(word):
    """Return the command of the README in which a word stands, in one line."""
    lines = (shown("sh") + shown("sh", 1)).replace("\\\n", "").splitlines()
    return next(line for line in lines if word in line)


def world_after(iterations, seed=1):
    start = small_start(load_rule("sand"))
    world = World.from_materials(start.cells, start.rule, seed)
    advance(world, start.rule, iterations)
    return world


def pixels_after(iterations):
    """Return the colours of the cells, as numbers whose lowest byte is red."""
    materials = load_rule("sand").definition.materials
    palette = np.array([(*each.colour, 255) for each in materials], np.uint8).view("<u4").ravel()
    return palette[world_after(iterations).materials].ravel()


def test_the_example_runs_to_rest_as_in_python(out):
    run(*compiler_of(builds()[0]), *STRICT, "example.c", "-o", "example", cwd=out)
    *picture, counts, digest = run(out / "example", "0").splitlines()
    world = world_after(int(counts.split()[0]))
    assert world.activity.settled and digest == world.digest()
    assert counts.split(", ")[1:] == [f"{world.grains} sand", f"{np.count_nonzero(world.walls)} wall"]
    assert len(picture) == -(-world.shape[0] // 2) and {len(line) for line in picture} == {world.shape[1]}


def test_the_first_command_builds_the_example(out):
    needs("cc")
    assert len(run("sh", "-c", command("example.c").replace("./example", "./example 0"), cwd=out).splitlines()) > 20


@sweep("compiler", ["g++", "clang++"], keep=["g++"])
@pytest.mark.parametrize(
    ("number", "engine", "headers"),
    [
        (
            0,
            "godot.hpp",
            [
                "godot_cpp/classes/image.hpp",
                "godot_cpp/classes/image_texture.hpp",
                "godot_cpp/classes/texture_rect.hpp",
            ],
        ),
        (1, "unreal.h", ["Components/ActorComponent.h", "Engine/Texture2D.h", "SandWorld.generated.h"]),
    ],
)
def test_classes_in_cpp_draw_the_cells(out, compiler, number, engine, headers):
    needs(compiler)
    for header in headers:
        (out / header).parent.mkdir(parents=True, exist_ok=True)
        (out / header).write_text(f'#include "{STAND_INS / engine}"\n', encoding="utf-8")
    main = (STAND_INS / f"{engine.split('.')[0]}_main.cpp").read_text(encoding="utf-8")
    (out / "engine.cpp").write_text(shown("cpp", number) + main, encoding="utf-8")
    flags = ("-std=c++17", "-O0", "-Wall", "-Wextra", "-Werror", "-I", ".")
    run(compiler, *flags, "engine.cpp", "-o", "engine", cwd=out)
    assert run(out / "engine") == f"{pixels_after(FRAMES * ITERATIONS)[0]:x} 0\n"


@sweep("compiler", ["g++", "clang++"], keep=["g++"])
def test_the_header_is_strict_cpp(out, compiler):
    needs(compiler)
    (out / "all.cpp").write_text('#define SANDGLASS_IMPLEMENTATION\n#include "sandglass.h"\n', encoding="utf-8")
    run(compiler, "-std=c++11", *STRICT, "-O0", "-c", "all.cpp", cwd=out)


def test_two_rules_fit_in_one_program(out):
    for name in ("sand", "rolling-sand"):
        header = f"{name.replace('-', '_')}.h"
        (out / header).write_text(texts_of(name)["sandglass.h"], encoding="utf-8")
        text = f'#define SANDGLASS_API static inline\n#define SANDGLASS_IMPLEMENTATION\n#include "{header}"\n'
        call = f"int {header[:-2]}(void);\nint {header[:-2]}(void)\n{{\n    return (int)sandglass_bytes(9, 9);\n}}\n"
        (out / f"{header[:-2]}.c").write_text(text + call, encoding="utf-8")
    main = "int sand(void);\nint rolling_sand(void);\nint main(void)\n{\n    return !(sand() && rolling_sand());\n}\n"
    (out / "main.c").write_text(main, encoding="utf-8")
    run(*compiler_of(builds()[0]), *STRICT, "main.c", "sand.c", "rolling_sand.c", "-o", "both", cwd=out)
    run(out / "both")


def test_the_header_runs_in_the_server_of_godot_3(out):
    needs("godot3-server", "gcc")
    run(*compiler_of("gcc"), *STRICT, "-I", ".", "-shared", "-fPIC", STAND_INS / "gdnative.c", "-o", "sand.so", cwd=out)
    (out / "project.godot").write_text("config_version=4\n", encoding="utf-8")
    library = '[general]\nsymbol_prefix="godot_"\n[entry]\nServer.64="res://sand.so"\n[dependencies]\nServer.64=[]\n'
    (out / "sand.gdnlib").write_text(library, encoding="utf-8")
    (out / "run.gd").write_text(GDSCRIPT, encoding="utf-8")
    printed = run("godot3-server", "--path", ".", "-s", "run.gd", cwd=out, env={**os.environ, "HOME": str(out)})
    assert printed.splitlines()[-1] == world_after(FRAMES * ITERATIONS).digest()


def test_the_class_for_unity_draws_the_cells(out):
    needs("mcs", "mono", "cc")
    run("sh", "-c", command("libsandglass.so").replace("-O3", "-O0"), cwd=out)
    (out / "SandWorld.cs").write_text(shown("csharp"), encoding="utf-8")
    run("mcs", "-out:run.exe", "SandWorld.cs", STAND_INS / "unity.cs", cwd=out)
    printed = run("mono", "run.exe", cwd=out, env={**os.environ, "LD_LIBRARY_PATH": str(out)})
    assert [int(line) for line in printed.split()] == pixels_after(FRAMES * ITERATIONS).tolist()


@sweep("simd", ["", "-msimd128"], keep=["-msimd128"])
def test_the_page_for_browsers_draws_the_cells(out, simd):
    needs("clang", "wasm-ld", "node")
    run("sh", "-c", command("wasm32").replace("-msimd128", simd), cwd=out)
    digest = """
        c.memory.grow(1);
        const at = c.memory.buffer.byteLength - 64;
        c.sandglass_digest(world, at);
        const drawn = new Uint32Array(c.memory.buffer, pixels, width * height);
        console.log(new TextDecoder().decode(new Uint8Array(c.memory.buffer, at, 32)), ...drawn);
    """
    page = f'import "{STAND_INS / "browser.mjs"}";\n{shown("js")}{digest}'
    (out / "page.mjs").write_text(page, encoding="utf-8")
    name, *drawn = run("node", "page.mjs", cwd=out).split()
    world = world_after(FRAMES * ITERATIONS)
    assert name == world.digest()
    assert [int(pixel) for pixel in drawn] == pixels_after(FRAMES * ITERATIONS).tolist()
