"""The tools in hand: brush, figures, pieces, taps and drains, the ruler."""
