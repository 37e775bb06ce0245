"""The ground floor: planes, blocks, chance, steps, pixels."""
