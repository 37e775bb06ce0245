"""Tests of game.world."""
