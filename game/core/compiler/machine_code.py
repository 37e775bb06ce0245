"""Machine code from LLVM IR, at an address."""

import platform

import llvmlite.binding as llvm

_LANES = (("avx512dq", 8), ("avx2", 4), ("sse2", 2), ("neon", 2))  # 64-bit words to a vector, the best feature first


def lanes():
    """Return how many 64-bit words this machine works out at a time."""
    features = llvm.get_host_cpu_features()
    return next((lanes for feature, lanes in _LANES if features.get(feature)), 1)


def machine():
    """Return in words what code is made for."""
    return f"{platform.machine()} {llvm.get_host_cpu_name()}, LLVM {'.'.join(map(str, llvm.llvm_version_info))}"


def features():
    """Return in words what this machine can do."""
    return llvm.get_host_cpu_features().flatten()


def target_machine(**options):
    """Return a new description of this machine, for one owner; options: those of llvmlite's create_target_machine."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    cpu = llvm.get_host_cpu_name()
    return llvm.Target.from_default_triple().create_target_machine(cpu=cpu, features=features(), **options)


def compiled(text):
    """Return the machine code of LLVM IR, as bytes; it is taken as it is written."""
    return target_machine(opt=2).emit_object(llvm.parse_assembly(text))


class MachineCode:
    """A compiled function; `address` is good as long as this object lives."""

    def __init__(self, code, name):
        """code: an object file, made on this machine or one like it."""
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        self.address = self._engine.get_function_address(name)
