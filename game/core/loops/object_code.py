"""Kernels as machine code: LLVM's passes over a kernel's IR, what they make of it, and how it is called."""

import ctypes
from functools import lru_cache

import llvmlite.binding as llvm

_VECTORISED = 3  # the level of optimisation at which loops become vectors


def _machine():
    """Return a new description of this machine, for one owner."""
    _initialize()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=_VECTORISED,
        reloc="static" if target.name.startswith("x86") else "default",  # as code in memory has to be there
        jit=True,
    )


@lru_cache(maxsize=1)
def _initialize():
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    for name in ("Calloc", "Free"):
        address = ctypes.cast(getattr(ctypes.pythonapi, f"PyMem_Raw{name}"), ctypes.c_void_p).value
        llvm.add_symbol(f"sandglass_{name.lower()}", address)


def compiled(text):
    """Return the machine code of a module of LLVM IR, optimised, as bytes."""
    machine = _machine()
    module = llvm.parse_assembly(text)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=_VECTORISED)
    options.loop_vectorization = options.slp_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    return machine.emit_object(module)


class ObjectCode:
    """Machine code in memory, which can be called with the bytes of arguments and room for results."""

    def __init__(self, code, name):
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        address = self._engine.get_function_address(name)
        self.call = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p)(address)
