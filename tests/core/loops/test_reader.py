"""A reader packs what it was written for, as a look at each argument does, and nothing else."""

from itertools import product
from typing import NamedTuple

import numpy as np
import pytest

from game.core.loops import signature
from game.core.loops.reader import reader


class Pair(NamedTuple):
    """Two things."""

    one: object
    other: object


WORDS = np.arange(24, dtype=np.uint64).reshape(4, 6)
CASES = {
    "nothing": (),
    "numbers": (1, 2.5, True, np.uint8(3), np.int16(-4), np.float32(0.5)),
    "other numbers": (1, 2.5, 1, np.uint8(3), np.int16(-4), np.float32(0.5)),
    "fewer numbers": (1, 2.5, True, np.uint8(3), np.int16(-4)),
    "a row": (WORDS[0],),
    "a row of others": (WORDS[0].view(np.int64),),
    "a column": (WORDS[:, 0],),
    "rows": (WORDS,),
    "parts of rows": (WORDS[:, 1:3],),
    "turned rows": (WORDS.T,),
    "one number as an array": (np.array(1.5),),
    "a tuple": ((1, WORDS[0]),),
    "a pair": (Pair(1, WORDS[0]),),
    "a tuple of none": ((),),
    "tuples in a tuple": (((1,), (2, (WORDS,))), 3),
    "other tuples in a tuple": (((1,), (2, WORDS)), 3),
}


def described(arguments):
    types, words = [], []
    signature.describe(arguments, types, words)
    return tuple(types), signature.packing(types).pack(*words)


@pytest.mark.parametrize(("of", "given"), list(product(CASES, CASES)))
def test_a_reader_packs_arguments_of_its_types_and_no_others(of, given):
    types, packed = described(CASES[given])
    wanted = packed if types == described(CASES[of])[0] else None
    assert reader(described(CASES[of])[0])(CASES[given]) == wanted


def test_numbers_of_one_kind_are_read_alike():
    read = reader(described((1, 2.5, np.uint8(3), True))[0])
    for given in (
        (np.int8(-1), np.float64(0.5), np.uint64(2**64 - 1), np.bool_(False)),
        (2**40, 1.5, np.uint16(1), True),
    ):
        assert read(given) == described(given)[1]
