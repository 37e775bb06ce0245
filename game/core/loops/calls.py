"""What kernels call that is no Python: passes over words at an address, and copies of rows."""

from game.core.loops.values import Array, Scalar, size_of


def _write(writer, address, result, words):
    """Call a function at an address with words, and return the word that it returns, if it does."""
    place = writer.new(f"inttoptr i64 {writer.as_kind(address, 'i').name} to ptr")
    call = f"call {result} {place}({', '.join(f'i64 {word}' for word in words)})"
    if result == "void":
        writer.line(call)
        return None
    return Scalar("i", writer.new(call))


def call_pass(address, words, at, may, origin, key, chances, size):
    """Call a pass of `core.compiler.vector_ir` at an address, an int64; of arrays it gets the pointers."""


def _write_pass(writer, address, *handed):
    words = []
    for value in handed:
        is_array = isinstance(value, Array)
        words.append(writer.new(f"ptrtoint ptr {value.data} to i64") if is_array else writer.as_kind(value, "i").name)
    return _write(writer, address, "i64", words)


def call_words(address, at, first, size):
    """Call a pass of `core.compiler.word_pass` at an address, with the addresses in `at`, flat, from place `first`."""


def _write_words(writer, address, at, first, size):
    start = writer.new(f"ptrtoint ptr {writer.address(at._replace(strides=()), [first]).data} to i64")
    return _write(writer, address, "void", [start, writer.as_kind(size, "i").name])


def copy(source, first, target, start, size):
    """Copy `size` items of a row of an array from its place `first` to another one's from `start`; they are apart."""


def _write_copy(writer, source, first, target, start, size):
    to, where = writer.address(target, [start]).data, writer.address(source, [first]).data
    bytes_ = writer.new(f"mul i64 {writer.as_kind(size, 'i').name}, {size_of(source.item)}")
    align = f"align {size_of(source.item)}"
    writer.line(f"call void @llvm.memcpy.p0.p0.i64(ptr {align} {to}, ptr {align} {where}, i64 {bytes_}, i1 false)")


call_pass.write_call = _write_pass
call_words.write_call = _write_words
copy.write_call = _write_copy
