"""Compiles kernels: functions on numbers and arrays, in a small part of Python, to machine code within milliseconds."""
