"""More materials: what they cost beside sand, and beside loops over bytes with a table of block states."""

import time
from dataclasses import replace
from functools import cache
from pathlib import Path

from game.core.compiler.rule_pass import pass_of
from game.study.bench import goals, worlds
from game.study.bench.checks import header_same_as_ours, same_as_table_twin, table_peers_same_as_twin
from game.study.bench.rounds import MICROSECONDS, header_in_c, ours, take_turns, theirs
from game.study.peers import cpp_blocks, exported_header, table_loop
from game.study.peers.block_table import block_table
from game.study.report import table
from game.study.report.report import Section
from game.study.report.table import Column, Table
from game.world.rules.rule import Rule, load_rule

OURS, CPP, LOOP = "ours", "cpp_table", table_loop.TABLE_LOOP.key
SAND, WATER, EIGHT, ALCHEMY = "sand, p = 1", "sand and water", "eight materials", "alchemy"
KITCHEN = "alchemy, in the kitchen"
LITTLE = "the paper: more materials add “very little computational overhead”; from {} to {}"
COLUMNS = (
    Column("rule", "rule"),
    Column("materials", "materials"),
    Column("name", "implementation"),
    Column("time", "µs per iteration", MICROSECONDS),
    Column("gcells", "Gcell/s", table.three_digits),
    Column("of_sand", "of sand", table.ratio),
    Column("slower", "ours is faster", table.ratio),
    Column("ready_ms", "ready in ms", table.three_digits),
    Column("checked", "checked"),
    goals.COLUMN,
)
PEER_COLUMNS = tuple(each for each in COLUMNS if each.key != "of_sand")
OUR_COLUMNS = tuple(each for each in COLUMNS if each.key not in ("name", "slower"))


@cache
def rules():
    """Return {name: Rule} of more and more materials, the sand first."""
    folder, schedule = Path(__file__).with_name("rules"), worlds.GLASS_RULE.schedule
    loaded = {
        SAND: Rule(),
        WATER: load_rule(folder / "sand-and-water.toml"),
        EIGHT: load_rule(folder / "eight-materials.toml"),
        ALCHEMY: load_rule("alchemy"),
    }
    return {name: rule.with_schedule(schedule) for name, rule in loaded.items()}


def rule_peer_table(plan):
    """Return the times of rules of more and more materials beside loops that look block states up."""
    size = plan.rule_size
    rows = [row for name, rule in rules().items() for row in _beside_peers(name, rule, worlds.strewn(size, rule), plan)]
    if ALCHEMY in rules():
        rows += _beside_peers(KITCHEN, rules()[ALCHEMY], worlds.cooking(size, rules()[ALCHEMY]), plan)
    notes = [
        f"{table.size(size)}, half of the cells empty and the others of all materials but wall, or the scene kitchen "
        f"after {worlds.COOKED} iterations; {plan.peer_batch} iterations in one call from the same world, one thread "
        "each. Materials: air and wall are among them. The loops' table has the outcomes of each block state, all "
        "layers of the rule folded into one draw.",
        f"The header is what `export` writes, {' '.join(exported_header.FLAGS[1:])}.",
        "Ready: ours, from what the rule says to machine code that was checked on all block states; the loops, "
        "compiled and their table filled; the header, compiled; timed once.",
        "Checked: so many iterations, cell by cell: ours against a plain twin of any rule that draws the same numbers, "
        "the loops against that twin with their table and their numbers, the header against ours.",
    ]
    return Section("rule peers", "2b · Peers, by the number of materials", [Table("", PEER_COLUMNS, rows), *notes])


def _beside_peers(name, rule, world, plan):
    """Return the rows of a rule on a world: ours, and each loop that there is a compiler for."""
    peers, rows = [table_loop.TABLE_LOOP], []
    try:
        peers.append(cpp_blocks.compiled_table())
    except cpp_blocks.NoCompilerError as error:
        rows.append({"rule": name, "materials": len(rule.materials), "key": CPP, "name": str(error)})
    checked = dict.fromkeys((peer.key for peer in peers), table_peers_same_as_twin(peers, world, rule, plan.checked))
    checked[OURS] = same_as_table_twin(world, rule, plan.checked)
    ready_ms = {peer.key: _compiled_ms(peer.key) + _filled_ms(rule) for peer in peers} | {OURS: _made_ms(rule)}
    timed = [ours(OURS, world, rule, plan.peer_batch), *(theirs(peer, world, rule, plan.peer_batch) for peer in peers)]
    names = {**{peer.key: peer.name for peer in peers}, OURS: "ours, bit planes"}
    for compiler in filter(exported_header.is_there, plan.headers):
        names[compiler] = f"ours, exported as a C header, {compiler}"
        header, ready_ms[compiler] = _header(rule, compiler)
        checked[compiler] = header_same_as_ours(names[compiler], header, world, rule, plan.checked)
        timed.append(header_in_c(compiler, header, world, plan.peer_batch))
    found = take_turns(timed, plan.rounds, plan.sample_ns)
    return rows + [
        {
            **_row(name, rule, found[key], plan.rule_size, ready_ms[key], checked[key]),
            "key": key,
            "name": names[key],
            "slower": None if key == OURS else found[key].times(found[OURS]),
            "goal": _peer_goal(name, key, found, plan.rule_size),
        }
        for key in names
    ]


def material_table(plan):
    """Return the time of an iteration of rules of more and more materials, and how many times that of sand it is."""
    size = plan.scene_size
    lattices = {name: worlds.strewn(size, rule) for name, rule in rules().items()}
    checked = {name: same_as_table_twin(lattices[name], rule, plan.checked) for name, rule in rules().items()}
    timed = [ours(name, lattices[name], rule, plan.batch) for name, rule in rules().items()]
    found = take_turns(timed, plan.rounds, plan.sample_ns)
    rows = [
        {
            **_row(name, rule, found[name], size, _made_ms(rule), checked[name]),
            "of_sand": found[name].times(found[SAND]),
            "goal": _goal(name, found, size),
        }
        for name, rule in rules().items()
    ]
    words = LITTLE.format(rows[0]["materials"], rows[-1]["materials"])
    rows.append({"rule": words, "of_sand": rows[-1]["of_sand"]})
    notes = [
        f"{table.size(size)}, half of the cells empty and the others of all materials but wall, {plan.batch} "
        f"iterations in one call, schedule {worlds.GLASS_RULE.schedule}. Materials: air and wall are among them."
    ]
    return Section("materials", "3c · What a scene needs: more materials", [Table("", OUR_COLUMNS, rows), *notes])


def _row(name, rule, timing, size, ready_ms, checked):
    return {
        "rule": name,
        "materials": len(rule.materials),
        "time": timing,
        "gcells": size[0] * size[1] / timing.median,
        "ready_ms": ready_ms,
        "checked": checked,
    }


def _goal(name, found, size):
    if name != WATER:
        return None
    what = f"{WATER}, all moving, {table.size(size)}: of {SAND}"
    return goals.at_most(what, found[name].times(found[SAND]), goals.WATER)


def _peer_goal(name, key, found, size):
    if key not in (OURS, CPP, LOOP):
        return _header_goal(name, key, found, size)
    if (name, key) != (ALCHEMY, CPP):
        return None
    what = f"{ALCHEMY}, all moving, {table.size(size)}: as fast as bytes and a table in C++"
    return goals.at_least(what, found[key].times(found[OURS]), goals.TABLE_PEER)


def _header_goal(name, key, found, size):
    where = f"header in C, {key}, {name}, all moving, {table.size(size)}"
    if name == SAND:
        return goals.at_most(f"{where}: of ours", found[key].times(found[OURS]), goals.HEADER)
    if name == ALCHEMY and CPP in found:
        what = f"{where}: as fast as bytes and a table in C++"
        return goals.at_least(what, found[CPP].times(found[key]), goals.HEADER_PEER)
    return None


def _header(rule, compiler):
    """Return the ExportedHeader of a rule, and how long it takes to write and compile it."""
    start = time.perf_counter()
    header = exported_header.ExportedHeader(rule, compiler)
    return header, 1e3 * (time.perf_counter() - start)


@cache
def _made_ms(rule):
    """Return how long it takes to make the machine code of a rule, as if it had not been there."""
    return _elapsed_ms(lambda: pass_of(replace(rule.table), rule.values))


@cache
def _compiled_ms(key):
    """Return how long it takes to compile a loop that looks block states up."""
    return _elapsed_ms({CPP: cpp_blocks.compiled_table, LOOP: table_loop.compile_anew}[key])


def _filled_ms(rule):
    """Return how long it takes to fill the table of block states."""
    return _elapsed_ms(lambda: block_table.__wrapped__(rule))


def _elapsed_ms(act):
    start = time.perf_counter()
    act()
    return 1e3 * (time.perf_counter() - start)
