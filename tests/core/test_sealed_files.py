"""A sealed file holds what was written, or is refused."""

from threading import Thread

from game.core.sealed_files import read_sealed, write_sealed

DATA = b"code" * 2**16


def test_threads_that_write_the_same_file_at_once_leave_it_whole(tmp_path):
    path, found = tmp_path / "kernels" / "a.rule", []

    def write():
        for _ in range(50):
            write_sealed(path, DATA)
            found.append(read_sealed(path) == DATA)

    threads = [Thread(target=write) for _ in range(4)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert len(found) == 200 and all(found) and list(path.parent.iterdir()) == [path]
