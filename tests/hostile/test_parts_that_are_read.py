"""The bounds of parts that nobody needs hold in the sheet that answers are read from, too."""

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.spreadsheet.preflight import MOST_ELEMENTS, refusal
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.xml_scan import DEEPEST, MOST_RANGES
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from hostile.small_workbook import PARTS, SHEET, STYLES, TEXTS, archive

_END = b"</sheetData>"


def with_added(content: bytes, *, before: bytes = _END) -> dict[str, bytes]:
    return {**PARTS, SHEET: PARTS[SHEET].replace(before, content + before)}


def in_utf_16(part: bytes) -> bytes:
    return part.decode().replace('encoding="UTF-8"', 'encoding="UTF-16"').encode("utf-16")


def read(parts: dict[str, bytes]) -> RawWorkbook | str:
    found = read_workbook(NamedBytes("answers.xlsx", archive(parts)))
    return found.code if isinstance(found, Rejected) else found


_ENTITY = b'<!DOCTYPE worksheet [<!ENTITY e "1">]>'


@pytest.mark.parametrize(
    ("parts", "reason"),
    [
        (with_added(b"<x/>" * MOST_ELEMENTS), WhyRefused.TOO_LARGE),
        (with_added(b"<x>" * DEEPEST + b"</x>" * DEEPEST), WhyRefused.FOREIGN_CONTENT),
        (with_added(b"<x>" * 90_000 + b"</x>" * 90_000), WhyRefused.FOREIGN_CONTENT),
        (with_added(b'<mergeCell ref="A1"/>' * MOST_RANGES), WhyRefused.MERGED),
        (with_added(b'<mergeCell ref="A:A"/>'), WhyRefused.MERGED),
        (with_added(_ENTITY, before=b"<worksheet"), WhyRefused.FOREIGN_CONTENT),
        (
            {**PARTS, SHEET: in_utf_16(with_added(_ENTITY, before=b"<worksheet")[SHEET])},
            WhyRefused.FOREIGN_CONTENT,
        ),
    ],
    ids=["elements", "depth", "great depth", "ranges", "a column", "entity", "entity in UTF-16"],
)
def test_a_sheet_with_answers_is_bounded(parts: dict[str, bytes], reason: WhyRefused) -> None:
    assert read(parts) == reason == refusal("answers.xlsx", archive(parts))


def test_what_only_looks_like_many_elements_is_read() -> None:
    comments = with_added(b"<!--" + b"<" * (MOST_ELEMENTS + 1) + b"-->")
    assert isinstance(read(comments), RawWorkbook)


def test_a_reason_does_not_depend_on_what_was_read_first() -> None:
    """The hidden fault stands earlier in the archive than the sheet, which is read before it."""
    early = {"xl/early.xml": _ENTITY + b"<x/>", **with_added(b"<x/>" * MOST_ELEMENTS)}
    late = {**with_added(b"<x/>" * MOST_ELEMENTS), "xl/late.xml": _ENTITY + b"<x/>"}
    assert read(early) == WhyRefused.FOREIGN_CONTENT
    assert read(late) == WhyRefused.TOO_LARGE


def test_parts_that_are_the_same_in_many_works_count_in_each() -> None:
    sound = {**PARTS, "xl/kept.xml": b"<x>" + b'<mergeCell ref="A1"/>' * 900 + b"</x>"}
    assert read(sound) == read(sound)
    assert isinstance(read(sound), RawWorkbook)
    copies = {f"xl/kept{number}.xml": sound["xl/kept.xml"] for number in range(MOST_RANGES // 900)}
    assert read({**sound, **copies}) == WhyRefused.MERGED
    spoiled = sound["xl/kept.xml"].replace(b"</x>", b"</y>")
    damaged = read({**sound, "xl/kept.xml": spoiled})
    assert isinstance(damaged, RawWorkbook)
    assert "xl/kept.xml" in str(damaged.remarks)


def test_a_part_with_two_purposes_is_refused() -> None:
    relations = "xl/_rels/workbook.xml.rels"
    name = STYLES.rpartition("/")[2].encode()
    two = PARTS[relations].replace(TEXTS.rpartition("/")[2].encode(), name)
    assert two != PARTS[relations]
    assert read({**PARTS, relations: two}) == WhyRefused.UNREADABLE_CONTENT


def test_a_sheet_under_many_titles_is_read_once_for_all() -> None:
    workbook = PARTS["xl/workbook.xml"]
    start = workbook.index(b"<sheet ")
    sheet = workbook[start : workbook.index(b">", start) + 1]
    title = sheet.split(b'name="')[1].split(b'"')[0]
    more = b"".join(sheet.replace(title, b"%d" % number) for number in range(90))
    found = read({**PARTS, "xl/workbook.xml": workbook.replace(sheet, sheet + more)})
    assert isinstance(found, RawWorkbook)
    assert found.answers["force"].value == 22941.5
