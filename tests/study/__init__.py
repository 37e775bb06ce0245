"""Tests of the study: its framework, its chain and its verdicts."""
