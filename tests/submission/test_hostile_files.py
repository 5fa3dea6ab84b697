"""Files that no spreadsheet program should be trusted with are refused with a clear sentence.

Each is a kilobyte or so; what it would cost a reader that trusts it is in the comments.
"""

import io
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from openpyxl import Workbook

from gripcourse.machine.spreadsheet import preflight
from gripcourse.machine.spreadsheet.refusals import REASONS, WhyRefused
from gripcourse.machine.spreadsheet.xml_names import LONG
from gripcourse.machine.spreadsheet.xml_scan import MOST_NAMES
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

if TYPE_CHECKING:
    from .conftest import Returned

SECTION = "xl/worksheets/sheet2.xml"
OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(504)
DOCTYPE = b'<?xml version="1.0"?><!DOCTYPE x [%s]><x>&a;</x>'
LAUGHS = b'<!ENTITY a "ha">' + b"".join(
    b'<!ENTITY %c "&%c;&%c;">' % (name + 1, name, name) for name in range(ord("a"), ord("z"))
)


def reason(path: Path) -> str:
    result = read_workbook(path)
    assert isinstance(result, Rejected), result
    assert len(result.digest) == 64
    assert result.file == str(path)
    return str(result.reason)


def archive(*members: tuple[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as target:
        for name, data in members:
            target.writestr(name, data)
    return stream.getvalue()


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "empty"),
        (OLE + "EncryptedPackage".encode("utf-16-le"), "password"),
        (OLE + "Workbook".encode("utf-16-le"), "old .xls format"),
        ("Диаметр;60,08\r\nСила;22941\r\n".encode(), "plain text"),
        ("Диаметр;60,08\r\n".encode("cp1251"), "plain text"),
        (b"<html><table><tr><td>1</td></tr></table></html>", "web page"),
        (b"\xef\xbb\xbf<?xml version='1.0'?><Workbook/>", "web page or XML"),
        (b"%PDF-1.7 ...", "PDF"),
        (b"\x89PNG\r\n\x1a\n....", "picture"),
        (b"\xff\xd8\xff\xe0 JFIF", "picture"),
        (bytes(range(256)) * 10, "not a workbook"),
        (b"PK\x03\x04" + bytes(100), "damaged"),
        (archive(("a.txt", b"x")), "not a workbook"),
        (
            archive(
                ("mimetype", b"application/vnd.oasis.opendocument.spreadsheet"),
                ("content.xml", b"<x/>"),
            ),
            "OpenDocument",
        ),
        (archive(("word/document.xml", b"<w/>")), "text document"),
        (archive(("xl/workbook.bin", b"\0")), ".xlsb"),
        (archive(("xl/workbook.xml", b"<workbook/>")), "none of the answer cells"),
    ],
)
def test_what_is_no_xlsx_workbook_is_told_by_what_it_is(
    tmp_path: Path, data: bytes, said: str
) -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(data)
    assert said in reason(path)


@pytest.mark.parametrize("name", ["~$answers.xlsx", ".~lock.answers.xlsx#"])
def test_a_lock_file_is_told_as_one(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_bytes(b"\x05ivan")
    assert "lock file" in reason(path)


def test_a_truncated_workbook_is_damaged(blank: bytes, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    for part in (0.2, 0.5, 0.99):
        path.write_bytes(blank[: int(part * len(blank))])
        assert "damaged" in reason(path)


def test_flipped_bytes_never_make_reading_fail(blank: bytes, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    for place in range(0, len(blank), len(blank) // 60):
        path.write_bytes(blank[:place] + bytes([blank[place] ^ 0x5A]) + blank[place + 1 :])
        assert isinstance(read_workbook(path), Rejected | RawWorkbook)


@pytest.mark.parametrize(
    "member",
    [
        ("xl/worksheets/huge.xml", b"<x>" + b" " * preflight.LARGEST_PART + b"</x>"),
        ("xl/media/zeros.png", bytes(preflight.LARGEST_TOTAL + 1)),
        ("xl/media/hidden.png", b" <x>" + b" " * preflight.LARGEST_PART + b"</x>"),
        ("xl/worksheets/cells.xml", b"<x>" + b"<c/>" * preflight.MOST_ELEMENTS + b"</x>"),
    ],
    ids=["a part", "all parts", "XML under another name", "cells"],
)
def test_what_unpacks_to_too_much_is_refused(
    blank: bytes, tmp_path: Path, member: tuple[str, bytes]
) -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(blank)
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as target:
        target.writestr(*member)
    assert path.stat().st_size < 200_000
    assert "far more than an answer workbook" in reason(path)


def test_too_many_parts_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(archive(*((f"xl/{n}.xml", b"") for n in range(preflight.MOST_PARTS + 1))))
    assert "far more than an answer workbook" in reason(path)


def test_a_sheet_that_is_listed_many_times_is_refused(returned: "Returned") -> None:
    # The reader would load it once for each entry.
    path = returned.patched({"xl/workbook.xml": lambda part: _repeat(part, b"<sheet ", b"/>", 200)})
    assert "far more than an answer workbook" in reason(path)


def _repeat(part: bytes, start: bytes, end: bytes, times: int) -> bytes:
    first = part.index(start)
    last = part.index(end, first) + len(end)
    return part[:last] + part[first:last] * times + part[last:]


def before_end(addition: bytes) -> Callable[[bytes], bytes]:
    return lambda part: part.replace(b"</sheetData>", b"</sheetData>" + addition)


@pytest.mark.parametrize(
    "addition",
    [
        b'<mergeCells count="1"><mergeCell ref="B1:B1048576"/></mergeCells>',  # 20 s, 370 MB
        b'<mergeCells count="1"><mergeCell ref="A1:XFD1048576"/></mergeCells>',
        b'<mergeCells count="1"><mergeCell ref="A:XFD"/></mergeCells>',
        b"<mergeCells>" + b'<mergeCell ref="H1:I1"/>' * 5001 + b"</mergeCells>",
        b'<hyperlinks><hyperlink ref="A1:XFD1048576" location="x"/></hyperlinks>',
    ],
)
def test_ranges_that_cover_whole_columns_are_refused(returned: "Returned", addition: bytes) -> None:
    assert "merged" in reason(returned.patched({SECTION: before_end(addition)}))


@pytest.mark.parametrize(
    ("part", "declarations"),
    [
        (SECTION, LAUGHS),
        ("xl/workbook.xml", LAUGHS),
        ("xl/sharedStrings.xml", b'<!ENTITY a "%s">' % (b"x" * 100_000)),
        (SECTION, b'<!ENTITY a SYSTEM "file:///etc/hostname">'),
        ("docProps/core.xml", b'<!ENTITY a SYSTEM "http://localhost/">'),
    ],
)
def test_declarations_of_entities_are_refused(
    returned: "Returned", part: str, declarations: bytes
) -> None:
    path = returned.patched({part: lambda _: DOCTYPE % declarations})
    assert "no spreadsheet program writes" in reason(path)


def test_entities_are_found_in_another_encoding_too(returned: "Returned") -> None:
    text = '<?xml version="1.0" encoding="UTF-16"?><!DOCTYPE x [<!ENTITY a "b">]><x/>'
    path = returned.patched({SECTION: lambda _: text.encode("utf-16")})
    assert "no spreadsheet program writes" in reason(path)


def test_deeply_nested_elements_are_refused(returned: "Returned") -> None:
    nested = b"<x>" * 50_000 + b"</x>" * 50_000
    path = returned.patched({SECTION: before_end(nested)})
    assert "no spreadsheet program writes" in reason(path)


@pytest.mark.parametrize(
    "addition",
    [
        "<x " + " ".join(f'a{one}=""' for one in range(MOST_NAMES + 1)) + "/>",
        "".join(f"<x{one}/>" for one in range(MOST_NAMES + 1)),
    ],
    ids=["of attributes", "of elements"],
)
def test_more_names_than_programs_write_are_refused_before_a_parser_keeps_them(
    returned: "Returned", addition: str
) -> None:
    # Seven hundred thousand take 260 megabytes.
    long = addition + " " * LONG
    assert "no spreadsheet program writes" in reason(
        returned.patched({SECTION: before_end(long.encode())})
    )


def test_a_long_text_full_of_words_and_equals_signs_is_no_list_of_names(
    returned: "Returned",
) -> None:
    words = " ".join(f"a{one}:=b{one}" for one in range(100_000))
    text = f'<dataValidations><dataValidation prompt="{words}"/></dataValidations>'.encode()
    assert len(text) > LONG
    assert returned.read(returned.patched({SECTION: before_end(text)})).identity.student == "s001"


@pytest.mark.parametrize(
    "change",
    [
        lambda part: part.replace(b"<sheetData>", b'<dimension ref="A1:XFD1048576"/><sheetData>'),
        before_end(b'<sheetCalcPr fullCalcOnLoad="1"/>'),
        lambda part: part.replace(
            b"</sheetData>", b'<row r="1048576"><c r="XFD1048576"><v>1</v></c></row></sheetData>'
        ),
        lambda part: part.replace(
            b"</sheetData>", b'<row r="2000000000"><c><v>1</v></c></row></sheetData>'
        ),
    ],
    ids=["a lie about the size", "harmless", "a far cell", "a far row"],
)
def test_sheets_are_never_walked_through(
    returned: "Returned", change: Callable[[bytes], bytes]
) -> None:
    submission = returned.read(returned.patched({SECTION: change}))
    assert submission.identity.student == "s001"


def named(name: str, text: str) -> Callable[[bytes], bytes]:
    """Add a defined name to the workbook."""
    made = f'<definedName name="{name}" localSheetId="0">{text}</definedName></definedNames>'
    return lambda part: part.replace(b"</definedNames>", made.encode())


def custom_format(code: bytes) -> Callable[[bytes], bytes]:
    """Declare a number format beside those of the workbook."""
    declared = b'<numFmts count="1"><numFmt numFmtId="190" formatCode="%s"/></numFmts>' % code
    return lambda part: re.sub(b"<numFmts.*?</numFmts>", b"", part).replace(
        b"<fonts", declared + b"<fonts", 1
    )


HARMLESS: dict[str, dict[str, Callable[[bytes], bytes]]] = {
    "print titles of 50 kB": {"xl/workbook.xml": named("_xlnm.Print_Titles", "a!$A:$A," * 6000)},
    "names of whole columns": {"xl/workbook.xml": named("_xlnm.Print_Area", "a!$A:$XFD")},
    "950 000 ranges in one validation": {
        SECTION: before_end(
            b'<dataValidations><dataValidation sqref="%s"/></dataValidations>' % (b"A1 " * 950_000)
        )
    },
    "many shared texts": {
        "xl/sharedStrings.xml": lambda part: part.replace(
            b"</sst>", b"<si><t>abc</t></si>" * 50_000 + b"</sst>"
        )
    },
    "a drawing and a table that are not there": {
        SECTION: before_end(
            b'<drawing xmlns:r="r" r:id="r9"/><tableParts><tablePart xmlns:r="r" r:id="r8"/>'
            b"</tableParts>"
        )
    },
    "damaged styles of letters": {
        "xl/styles.xml": lambda part: re.sub(
            b"<fonts.*</fonts>", b"<fonts><font><sz/></font></fonts>", part
        )
    },
    "a date of its properties that is a year": {
        "docProps/core.xml": lambda part: re.sub(rb">\d{4}-[^<]*<", b">2026<", part)
    },
}


@pytest.mark.parametrize("changes", HARMLESS.values(), ids=list(HARMLESS))
def test_what_no_answer_needs_refuses_nothing_and_costs_nothing(
    returned: "Returned", changes: dict[str, Callable[[bytes], bytes]]
) -> None:
    assert returned.read(returned.patched(changes)).identity.student == "s001"


def test_a_huge_picture_refuses_nothing(blank: bytes, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(blank)
    with zipfile.ZipFile(path, "a", zipfile.ZIP_DEFLATED) as target:
        target.writestr("xl/media/photo.png", b"\x89PNG" + bytes(preflight.LARGEST_TOTAL))
    assert isinstance(read_workbook(path), RawWorkbook)


def test_names_of_parts_with_backslashes_and_capitals_are_read(
    blank: bytes, tmp_path: Path
) -> None:
    path = tmp_path / "answers.xlsx"
    with zipfile.ZipFile(io.BytesIO(blank)) as source:
        parts = [(name.replace("/", "\\").upper(), source.read(name)) for name in source.namelist()]
    path.write_bytes(archive(*parts))
    assert isinstance(read_workbook(path), RawWorkbook)


def test_the_workbook_is_the_one_that_a_spreadsheet_program_opens(
    returned: "Returned", tmp_path: Path
) -> None:
    """The part of the usual name may be a decoy: relationships tell which one counts."""
    relations = {"_rels/.rels": lambda part: part.replace(b"xl/workbook.xml", b"xl/other.xml")}
    path = returned.patched(relations)
    assert isinstance(read_workbook(path), Rejected)
    decoy = tmp_path / "decoy.xlsx"
    decoy.write_bytes(returned.patched({"xl/workbook.xml": lambda _: b"<workbook/>"}).read_bytes())
    assert "none of the answer cells" in reason(decoy)


def test_two_parts_of_one_name_are_refused(blank: bytes, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    with zipfile.ZipFile(io.BytesIO(blank)) as source:
        parts = [(name, source.read(name)) for name in source.namelist()]
    path.write_bytes(archive(*parts, ("XL/workbook.xml", b"<workbook/>")))
    assert "no spreadsheet program writes" in reason(path)


@pytest.mark.parametrize("method", [zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2])
def test_methods_that_spreadsheets_do_not_write_are_refused_unopened(
    blank: bytes, tmp_path: Path, method: int
) -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(blank)
    with zipfile.ZipFile(path, "a", method) as target:
        target.writestr("xl/extra.xml", b"<x/>" * 500)
    whole = path.read_bytes()
    place = whole.index(b"xl/extra.xml") + 20
    for data in (whole, whole[:place] + b"\xff" * 9 + whole[place + 9 :]):
        path.write_bytes(data)
        assert "no spreadsheet program writes" in reason(path)


@pytest.mark.parametrize("encoding", ["true", "utf-99", "zip", "rot13", "undefined"])
def test_an_encoding_that_there_is_not_refuses_the_workbook(
    returned: "Returned", encoding: str
) -> None:
    head = f'<?xml version="1.0" encoding="{encoding}"?>'.encode()
    path = returned.patched({SECTION: lambda part: head + part[part.index(b"<worksheet") :]})
    assert "save it again" in reason(path)


@pytest.mark.parametrize("code", [b"[" * 100_000, b"&quot;" * 50_000, b"0" * 501])
def test_a_number_format_longer_than_any_program_writes_is_not_looked_at(
    returned: "Returned", code: bytes
) -> None:
    raw = read_workbook(returned.patched({"xl/styles.xml": custom_format(code)}))
    assert isinstance(raw, RawWorkbook)
    assert {cell.number_format for cell in raw.answers.values()} == {"General"}


def test_a_style_with_a_format_that_is_not_declared_is_a_plain_one(returned: "Returned") -> None:
    def undeclared(part: bytes) -> bytes:
        return re.sub(rb'(<xf numFmtId=)"\d+"', rb'\1"199"', part)

    raw = read_workbook(returned.patched({"xl/styles.xml": undeclared}))
    assert isinstance(raw, RawWorkbook)
    assert {cell.number_format for cell in raw.answers.values()} == {"General"}


def test_every_refusal_has_a_code_and_a_sentence() -> None:
    assert set(REASONS) == set(WhyRefused)
    refused = [Rejected.because("a.xlsx", "", one) for one in WhyRefused]
    assert all(str(one.reason) and one.code for one in refused)


def test_a_missing_part_is_told(blank: bytes, tmp_path: Path) -> None:
    path = tmp_path / "answers.xlsx"
    with zipfile.ZipFile(io.BytesIO(blank)) as source:
        kept = [(name, source.read(name)) for name in source.namelist()]
    path.write_bytes(archive(*(member for member in kept if "sharedStrings" not in member[0])))
    assert "cannot be read" in reason(path) or "missing" in reason(path)


def test_a_style_that_does_not_exist_costs_no_answer(returned: "Returned") -> None:
    quantity, path = returned.stored("12.5")
    with zipfile.ZipFile(path) as source:
        parts = {name: source.read(name) for name in source.namelist()}
    parts[SECTION] = parts[SECTION].replace(b' s="', b' s="99')
    path.write_bytes(archive(*parts.items()))
    raw = read_workbook(path)
    assert isinstance(raw, RawWorkbook)
    assert raw.answers[quantity].value == 12.5
    assert "styles of the workbook are damaged" in str(raw.remarks)


def test_xml_that_is_not_closed_refuses_the_workbook(returned: "Returned") -> None:
    path = returned.patched({SECTION: lambda part: part[: len(part) // 2]})
    assert "save it again" in reason(path)


def test_somebody_else_s_workbook_is_refused(tmp_path: Path) -> None:
    book = Workbook()
    path = tmp_path / "mine.xlsx"
    book.save(path)
    assert "none of the answer cells" in reason(path)


def test_a_file_that_is_not_there_is_the_caller_s_problem(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        read_workbook(tmp_path / "nothing.xlsx")
