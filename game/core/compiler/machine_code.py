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


class MachineCode:
    """A compiled function; `address` is good as long as this object lives."""

    def __init__(self, text, name, code=None):
        """`code`: what `code` was of the same text and machine before; without it the text is compiled."""
        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
        module = llvm.parse_assembly(text)
        machine = llvm.Target.from_default_triple().create_target_machine(
            cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=2
        )
        self.code = code
        self._engine = llvm.create_mcjit_compiler(module, machine)
        self._engine.set_object_cache(self._take, lambda module: code)
        self._engine.finalize_object()
        self.address = self._engine.get_function_address(name)

    def _take(self, module, code):
        self.code = code
