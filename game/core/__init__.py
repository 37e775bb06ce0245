"""Arrays in, arrays out: the automaton's compiled ground floor."""
