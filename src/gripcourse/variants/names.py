"""What variants are called, and what a spreadsheet program makes of it."""


def without_noughts(name: str) -> str:
    """Return a name as a spreadsheet program saves it: of a whole number the first noughts go."""
    return name.lstrip("0") or "0" if name.isdecimal() else name
