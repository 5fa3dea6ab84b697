"""What a PDF file says, as a reader outside of this program sees it."""

import subprocess


def pages_of(pdf: bytes) -> list[str]:
    """Return the text of each page, every run of spaces and line ends as one space.

    By poppler: reading it in Python takes longer than making it.
    """
    command = ["pdftotext", "-raw", "-", "-"]
    done = subprocess.run(command, input=pdf, capture_output=True, check=True)  # noqa: S603 (poppler)
    *pages, _ = done.stdout.decode().split("\f")
    return [" ".join(page.split()) for page in pages]
