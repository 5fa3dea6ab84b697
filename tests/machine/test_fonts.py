"""The fonts of this machine are asked for as documents ask, and nothing else is imported for it."""

import subprocess
import sys

PROGRAM = """
import sys
from gripcourse.machine.fonts import fonts_used, load_pango
assert fonts_used(["Liberation Serif"])["Liberation Serif"]
assert "weasyprint" not in sys.modules, "all of it was imported"
from weasyprint.text import fonts
assert fonts.pango is load_pango()[1].pango, "the libraries were loaded twice"
"""


def test_asking_for_a_font_imports_the_libraries_only_and_documents_use_the_same() -> None:
    done = subprocess.run(  # noqa: S603 (our own text)
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=False, timeout=120
    )
    assert (done.returncode, done.stderr) == (0, "")
