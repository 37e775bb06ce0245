"""What lies over the sand: cards, outlines, the map of the lattice, what blocks may do."""
