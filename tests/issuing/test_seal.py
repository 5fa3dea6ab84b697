"""The square code of a sheet: who, which variant, signed."""

import xml.etree.ElementTree as ET
from dataclasses import replace
from datetime import date

from hypothesis import given
from hypothesis import strategies as st

from gripcourse.issuing.seal import Seal, read_seal, seal_modules, seal_of, seal_svg, seal_text
from gripcourse.issuing.signature import sign, verify
from gripcourse.variants.model import Issued, Student, Variant

KEY = bytes(range(32))
VARIANT = Variant("017", "rack_parallelogram", {"drive": "hydraulic"}, {"mass": 60.0})
ISSUED = Issued(
    Student("s017", "Иванова Ольга", "РТ-41", "", "ru", ""),
    VARIANT,
    date(2025, 2, 10),
    None,
    sign(KEY, "gripper-design", "s017", VARIANT),
)
SEAL = seal_of(ISSUED, "gripper-design")


@given(*(st.text(st.characters(exclude_categories=["Cs"]), min_size=1) for _ in range(3)))
def test_what_is_written_can_be_read(course: str, student: str, variant: str) -> None:
    seal = Seal(course, student, variant, "0" * 64)
    assert read_seal(seal_text(seal)) == seal
    assert seal_text(seal).isascii()


def test_a_seal_proves_what_was_issued() -> None:
    read = read_seal(seal_text(SEAL))
    assert read is not None
    assert read.variant == VARIANT.id
    assert verify(KEY, read.course, read.student, VARIANT, read.signature)
    assert not verify(KEY, read.course, "s018", VARIANT, read.signature)


def test_another_code_is_no_seal() -> None:
    assert read_seal("https://example.org/") is None
    assert read_seal(seal_text(SEAL)[:-1]) is None
    assert read_seal("") is None


def test_the_picture_is_square_and_depends_on_the_student() -> None:
    picture = ET.fromstring(seal_svg(SEAL))  # noqa: S314 - our own drawing
    _, _, width, height = picture.attrib["viewBox"].split()
    assert width == height
    assert seal_svg(replace(SEAL, student="s018")) != seal_svg(SEAL)


def test_the_picture_is_as_many_modules_wide_as_is_said() -> None:
    for address in ("", "https://example.org/grippers"):
        picture = ET.fromstring(seal_svg(SEAL, address))  # noqa: S314 - our own drawing
        assert picture.attrib["viewBox"].split()[2] == str(seal_modules(SEAL, address))


def test_the_code_of_a_course_with_an_address_is_a_link_that_says_the_same() -> None:
    text = seal_text(SEAL, "https://example.org/grippers")
    assert text.startswith("https://example.org/grippers#gripcourse:1:")
    assert read_seal(text) == SEAL
