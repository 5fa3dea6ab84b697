"""How a length stands in an SVG file."""


def number(value: float) -> str:
    """Write a coordinate: hundredths of a millimetre are finer than any printer."""
    written = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if written == "-0" else written
