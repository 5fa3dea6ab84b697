import pytest

from gripcourse.course.quantity import Tolerance
from gripcourse.solver.band_text import band_text
from gripcourse.text.words import Words


@pytest.mark.parametrize(
    ("relative", "absolute", "language", "said"),
    [
        (0.02, 0.0, "en", "± 2%"),
        (0.0, 0.05, "en", "± 0.05 mm"),
        (0.0, 0.05, "uk", "± 0,05 мм"),
        (0.02, 0.05, "ru", "± 2 %"),
    ],
)
def test_a_band_without_a_share_is_printed_with_its_amount(
    relative: float, absolute: float, language: str, said: str
) -> None:
    band = Tolerance(relative, absolute)
    assert band_text(band, "mm", Words(language)).replace("\u00a0", " ") == said
