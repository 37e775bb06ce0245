"""A kernel does what Python does with the same function, and says where a function is none that can be compiled."""

import threading
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.core.jit import gate
from game.core.loops.kernel import Kernel, compile_kernel
from game.core.loops.statements import NotCompilableError

KNOWN = np.array([3, 1, 2], np.uint8)
TABLE = np.zeros((2, 2))
STEPS = (1, 2), (3, 4)
ONE = np.uint64(1)


class Pair(NamedTuple):
    """A number and some."""

    first: int
    second: np.ndarray


def kernel_of(function):
    """Return a kernel that is compiled in this test."""
    return Kernel(function, lambda key, types: compile_kernel(function, types))


@gate
def sign(x):
    if x < 0:
        return -1
    if x > 0:
        return 1
    return 0


@gate
def first_above(values, limit):
    for k in range(len(values)):
        if values[k] > limit:
            return k, values[k]
    return -1, 0


def arithmetic(a, b):
    return a + b, a - b, a * b, a // b, a % b, a / b, -a, abs(b), ~a, a & b, a | b, a ^ b, min(a, b), max(a, b, 3)


def shifts(a, b):
    return a << b, a >> b, a**3, 2 * a >> 1, a // 4, a % 4


def reals(a, b):
    return a + b, a * b - 1, a / b, np.floor(a), np.ceil(b), int(a), abs(a), min(a, b, 0.5), max(a, 1), a < b, a != b


def comparisons(a, b):
    return a < b, a <= b, a > b, a >= b, a == b, a != b, -5 <= a < b, not a, a > 0 and b > 0, a > 0 or b > 0


def choices(a, b):
    x = a if a > b else b
    y = (a, 1.5) if a > 0 else (b, 2)
    return x, y[0], y[1], 1 if a else 0, sign(a), sign(sign(b) - a)


def loops(a, b):
    total, turns = 0, 0
    for k in range(a, b):
        if k % 3 == 0:
            continue
        if total > 100:
            break
        total += k
    for k in range(b, a, -2):
        turns += k - a
    while total > 7:
        total //= 2
        turns += 1
    for one, two in STEPS:
        if one == a:
            break
        total += one * two
    return total, turns


def swaps(a, b):
    a, (b, c) = b, (a, a + b)
    c = a = a + c
    return a, b, c


@pytest.mark.parametrize("function", [arithmetic, shifts, comparisons, choices, loops, swaps])
def test_whole_numbers_are_those_of_python(function):
    kernel = kernel_of(function)
    for a in (-7, -4, -1, 0, 1, 2, 8, 13):
        for b in (1, 2, 3, 8) if function is shifts else (-8, -3, -1, 1, 2, 5, 64):
            assert kernel(a, b) == pytest.approx(function(a, b), abs=0), (a, b)


def test_floats_are_those_of_python():
    kernel = kernel_of(reals)
    for a in (-2.5, -0.1, 0.0, 0.5, 3.75):
        for b in (-1.5, 0.3, 2.0):
            assert kernel(a, b) == reals(a, b)


def test_what_is_no_number_is_not_even_itself():
    def same(a):
        return a == a, a != a, a < a

    assert kernel_of(same)(np.nan) == (False, True, False)


def unsigned(a, b):
    return a + b, a * b, a // b, a % b, a >> ONE, a << ONE, ~a, a < b, min(a, b), np.float64(a), np.int64(a) >> 1


UNSIGNED = kernel_of(unsigned)


@given(*[st.integers(1, 2**64 - 1)] * 2)
def test_unsigned_numbers_wrap_around(a, b):
    sums = [(a + b), (a * b), a // b, a % b, a >> 1, a << 1, ~a]
    signed = a - 2**64 if a >= 2**63 else a
    expected = [each % 2**64 for each in sums] + [a < b, min(a, b), float(a), signed >> 1]
    assert list(UNSIGNED(np.uint64(a), np.uint64(b))) == expected


def stored(numbers, signed, unsigned, halves, flags):
    for k in range(len(numbers)):
        signed[k] = numbers[k]
        unsigned[k] = numbers[k]
        halves[k] = np.float32(numbers[k]) / np.float32(3)
        flags[k] = np.uint8(numbers[k]) > np.uint8(100)
        numbers[k] += KNOWN[k % 3] - np.uint16(numbers[k])


@pytest.mark.parametrize("kinds", [(np.int8, np.uint8), (np.int16, np.uint16), (np.int32, np.uint32)])
def test_items_hold_what_fits_in_their_type(kinds):
    numbers = np.array([0, 1, -1, 200, 40000, -70000, 2**31, 2**40 + 5])
    before = numbers.copy()
    room = [np.zeros(8, kind) for kind in (*kinds, np.float32, np.bool_)]
    kernel_of(stored)(numbers, *room)
    assert (room[0] == before.astype(kinds[0])).all() and (room[1] == before.astype(kinds[1])).all()
    assert (room[2] == before.astype(np.float32) / np.float32(3)).all()
    assert (room[3] == (before.astype(np.uint8) > 100)).all()
    assert (numbers == before + np.resize(KNOWN, 8) - before.astype(np.uint16)).all()


@pytest.mark.parametrize("kind", "bBhHiIlLfd?")
def test_items_are_read_as_they_are(kind):
    def read(values, found):
        for k in range(len(values)):
            found[k] = values[k]

    values, found = np.array([0, 1, 5, 100]).astype(kind), np.zeros(4)
    if kind in "bhil":
        values[3] = np.iinfo(kind).min
    elif kind in "BHIL":
        values[3] = np.iinfo(kind).max
    kernel_of(read)(values, found)
    assert (found == values).all()


def parts(cells, pair, start, end):
    height, width = cells.shape
    row = cells[1]
    row[start:end] = 7
    cells[2:, 1] = 9
    cells[0] = cells[height - 1, width - 1]
    cells[1, 0] += len(row) + cells.size
    pair.second[:] = pair.first
    x, y = pair.second
    return (
        x + y,
        cells[:, 1:].shape[1],
        row[0:99].size,
        row[start:end].size,
        first_above(row, 3)[0],
        first_above(row, 3)[1],
    )


@pytest.mark.parametrize("cells", [np.arange(24).reshape(4, 6), np.arange(48).reshape(4, 12)[:, ::2]])
@pytest.mark.parametrize("order", [0, 1])
def test_parts_of_arrays_are_those_of_numpy(cells, order):
    mine, theirs = (cells.copy() if order == 0 else np.array(cells.T, order="F").T for _ in range(2))
    one, other = Pair(5, np.zeros(2, np.int64)), Pair(5, np.zeros(2, np.int64))
    for span in ((2, 4), (3, 99), (4, 2)):
        assert kernel_of(parts)(mine, one, *span) == parts(theirs, other, *span)
        assert (mine == theirs).all() and (one.second == other.second).all()


def working(n, out):
    words = np.zeros((2, n), np.uint64)
    for k in range(n):
        words[k & 1, k] = np.uint64(k) << np.uint64(8)
    bytes_, flat = words[1].view(np.uint8), words.reshape(-1)
    for k in range(n):
        out[k] = bytes_[8 * k + 1] + flat[k]
    return words.shape[1]


def test_a_kernel_has_room_of_its_own():
    out = np.zeros(9, np.int64)
    assert kernel_of(working)(9, out) == 9
    assert out.tolist() == [(k if k & 1 else 0) + (0 if k & 1 else k << 8) for k in range(9)]


def test_without_memory_there_is_an_error():
    with pytest.raises(MemoryError):
        kernel_of(working)(2**45, np.zeros(1, np.int64))


def test_memory_is_given_back():
    def rooms(n, turns):
        total = 0.0
        for _ in range(turns):
            total += np.zeros(n, np.float64)[n - 1]
        return total

    kernel = kernel_of(rooms)
    for _ in range(200):
        assert kernel(2**22, 32) == 0.0  # 200 GiB, were it kept


def test_types_that_differ_are_compiled_apart_and_strides_of_one_item_are_not():
    def total(values):
        found = 0
        for k in range(len(values)):
            found += values[k]
        return found

    kernel = kernel_of(total)
    numbers = np.arange(10)
    for values in (numbers, numbers[2:5], numbers[::2], numbers[:1:2], numbers[::-1], numbers.astype(np.int32)):
        values.flags.writeable = False
        assert kernel(values) == total(values)
    assert kernel(np.arange(6).reshape(6, 1)[:1].T[0]) == 0 and kernel(np.arange(9)[::5][:1]) == 0
    assert kernel.signatures == ["i8[1]", "i8[1 apart]", "i4[1]"]


def test_what_a_kernel_does_not_know_is_refused():
    kernel = kernel_of(sign)
    with pytest.raises(TypeError, match="takes no list"):
        kernel([1])
    for values in (np.zeros(3, np.int32).astype(">i4"), np.zeros(3, np.float16), np.zeros(3, np.complex64)):
        with pytest.raises(TypeError, match="takes no items of type"):
            kernel(values)


def test_threads_that_call_at_once_compile_once():
    made = []

    def total(a, b):
        return a + b

    kernel = Kernel(total, lambda key, types: made.append(key) or compile_kernel(total, types))
    threads = [threading.Thread(target=kernel, args=(1, 2)) for _ in range(8)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert len(made) == 1 and kernel(3, 4) == 7


def mixed(a):
    return a < ONE + np.uint64(a)


def changing(a):
    x = a
    x = 0.5 if x else x
    return x


def unknown(a):
    return sorted(a)


def listed(a):
    return [each for each in a]


def divided(a, b):
    return a // b


def each_item(a):
    for x in a:
        return x


def length_of_a_number(a):
    return len(a)


def part_of_a_number(a):
    return a[0]


def steps(a):
    return a[::2].size


def last(a):
    return a[-1]


def row_changed(a):
    a[0] += 1


def no_break(a):
    for x in range(a):
        a += x
    else:
        a = 0
    return a


def early(a):
    for k in range(a):
        a += later if k else 1  # noqa: F821
        later = k  # noqa: F841
    return a


def no_power(a):
    return a**0 + a**-1


def turned_over(a):
    return ~(a > 1)


def table(a):
    return TABLE[a, 0]


@pytest.mark.parametrize(
    ("function", "arguments", "line"),
    [
        (mixed, (1,), "return a < ONE"),
        (changing, (1,), "x = 0.5 if"),
        (unknown, (np.zeros(3),), "return sorted"),
        (listed, (np.zeros(3),), "return [each"),
        (divided, (1, ONE), "return a // b"),
        (each_item, (np.zeros(3),), "for x in a"),
        (length_of_a_number, (1,), "return len(a)"),
        (part_of_a_number, (1,), "return a[0]"),
        (steps, (np.zeros(3),), "return a[::2]"),
        (last, (np.zeros(3),), "return a[-1]"),
        (row_changed, (np.zeros((2, 2)),), "a[0] += 1"),
        (no_break, (3,), "for x in range(a)"),
        (early, (3,), "a += later"),
        (no_power, (3,), "return a**0"),
        (turned_over, (3,), "return ~"),
        (table, (1,), "return TABLE"),
    ],
)
def test_what_cannot_be_compiled_is_said_with_its_place(function, arguments, line):
    with pytest.raises(NotCompilableError) as error:
        kernel_of(function)(*arguments)
    path, number, _ = str(error.value).split(":", 2)
    assert path == __file__ and line in Path(path).read_text("utf-8").splitlines()[int(number) - 1]
