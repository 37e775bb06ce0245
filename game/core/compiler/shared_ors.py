"""Ors of many sets of literals at once: what sets have in common is made once."""

from collections import Counter
from heapq import heapify, heappop, heappush
from itertools import combinations

from game.core.compiler.circuit import FALSE


def shared_ors(circuit, sets):
    """Return {key: literal of any of the set} for {key: literals}.

    The pair of literals that most sets share is joined first, and so on. Source: Paar 1997, for sums of products.
    """
    sets = {key: set(literals) - {FALSE} for key, literals in sets.items()}
    counts = Counter(pair for each in sets.values() for pair in combinations(sorted(each), 2))
    heap = [(-count, pair) for pair, count in counts.items() if count > 1]
    heapify(heap)
    while heap:
        count, pair = heappop(heap)
        if -count == counts[pair]:
            for each in _join(circuit, sets, counts, pair):
                heappush(heap, (-counts[each], each))
        elif counts[pair] > 1:
            heappush(heap, (-counts[pair], pair))
    return {key: circuit.any(sorted(literals)) for key, literals in sets.items()}


def _join(circuit, sets, counts, pair):
    """Put the or of a pair in its place wherever both are; return the pairs that more than one set has now."""
    joined, raised = circuit.or_(*pair), set()
    for each in sets.values():
        if not each.issuperset(pair):
            continue
        each.difference_update((*pair, joined))
        for other in each:
            for one in pair:
                counts[min(one, other), max(one, other)] -= 1
            key = min(other, joined), max(other, joined)
            counts[key] += 1
            raised.add(key)
        each.add(joined)
    counts[pair] = 0
    return [key for key in raised if counts[key] > 1]
