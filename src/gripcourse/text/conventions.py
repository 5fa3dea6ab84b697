"""How numbers and functions are written: English, and the languages of the continent."""

ENGLISH = "en"


def is_english(language: str) -> bool:
    """Tell whether a language is that of the keys and writes as English does."""
    return language == ENGLISH


def decimal_sign(language: str) -> str:
    """Return what stands between the whole and the decimals of a number."""
    return "." if is_english(language) else ","
