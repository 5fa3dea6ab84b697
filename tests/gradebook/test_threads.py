"""Gradebooks that threads of one program make at the same moment."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from gripcourse.gradebook.store import open_gradebook


def test_threads_make_gradebooks_at_once(tmp_path: Path) -> None:
    places = [str(tmp_path / f"{number}.sqlite") for number in range(8)]
    with ThreadPoolExecutor(4) as pool:
        books = list(pool.map(open_gradebook, places))
    assert [book.attempts(["s01"]) for book in books] == [()] * len(places)
