"""Kernels as machine code: LLVM's passes over a kernel's IR, what they make of it, and how it is called."""

import ctypes
from functools import lru_cache

import llvmlite.binding as llvm

from game.core.compiler.machine_code import MachineCode, target_machine

_VECTORISED = 3  # the level of optimisation at which loops become vectors
# As code in memory has to be there.
_RELOCATION = "static" if llvm.get_process_triple().startswith("x86") else "default"


def compiled(text, called=""):
    """Return the machine code of a module of LLVM IR, optimised, as bytes.

    called: the IR of another module, whose functions become parts of those that call them.
    """
    machine = target_machine(opt=_VECTORISED, reloc=_RELOCATION, jit=True)
    module = _parsed(text, machine)
    if called:
        _link(module, _parsed(called, machine))
    options = llvm.create_pipeline_tuning_options(speed_level=_VECTORISED)
    options.loop_vectorization = options.slp_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return machine.emit_object(module)


def _parsed(text, machine):
    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    return module


def _link(module, called):
    """Move what another module defines into one, out of sight of all others."""
    names = {each.name for each in (*called.functions, *called.global_variables) if not each.is_declaration}
    module.link_in(called)
    for each in (*module.functions, *module.global_variables):
        if each.name in names:
            each.linkage = llvm.Linkage.internal


class ObjectCode(MachineCode):
    """Machine code in memory, which can be called with the bytes of arguments and room for results."""

    def __init__(self, code, name):
        _lend_memory()
        super().__init__(code, name)
        self.call = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p)(self.address)


@lru_cache(maxsize=1)
def _lend_memory():
    """Let kernels find the functions of Python that give and take memory."""
    for name in ("Calloc", "Free"):
        address = ctypes.cast(getattr(ctypes.pythonapi, f"PyMem_Raw{name}"), ctypes.c_void_p).value
        llvm.add_symbol(f"sandglass_{name.lower()}", address)
