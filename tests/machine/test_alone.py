"""What another process is writing is told from what a dead one left."""

import subprocess
import sys
from pathlib import Path

import pytest

from gripcourse.machine.alone import writing_into

_WRITES = """
import sys
from pathlib import Path
from gripcourse.machine.alone import writing_into
with writing_into(Path(sys.argv[1])) as alone:
    print(alone, flush=True)
    sys.stdin.read()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="a system without such locks")
def test_who_writes_is_known_until_it_is_dead(tmp_path: Path) -> None:
    command = [sys.executable, "-c", _WRITES, str(tmp_path)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, text=True) as other:  # noqa: S603 (ours)
        assert other.stdout is not None
        assert other.stdout.readline() == "True\n"
        with writing_into(tmp_path) as alone:
            assert not alone
        other.kill()
    with writing_into(tmp_path) as alone:
        assert alone
    with writing_into(tmp_path / "gone") as alone:
        assert alone
