"""Archives that no spreadsheet program writes, and files that are none."""

import gzip
import io
import struct
import zipfile

from hostile.small_workbook import (
    HIDDEN,
    PARTS,
    PROPERTIES,
    RELATIONS,
    SHEET,
    STYLES,
    TEXTS,
    WORKBOOK,
    archive,
    patched,
    replaced,
    with_members,
)

_OLE = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"
_END = b"PK\x05\x06"
_ENTRY = b"PK\x01\x02"


def _without(part: str) -> bytes:
    return archive({name: data for name, data in PARTS.items() if name != part})


def _header_changed(offset: int, value: bytes) -> bytes:
    """Change a field of the first entry of the directory."""
    data = archive(PARTS)
    place = data.index(_ENTRY) + offset
    return data[:place] + value + data[place + len(value) :]


def an_empty_file() -> bytes:
    return b""


def one_byte() -> bytes:
    return b"P"


def only_the_sign_of_an_archive() -> bytes:
    return b"PK\x03\x04"


def an_archive_of_nothing() -> bytes:
    return _END + bytes(18)


def random_looking_bytes() -> bytes:
    return bytes((7 * place * place) % 251 for place in range(5000))


def a_protected_workbook() -> bytes:
    return _OLE + bytes(504) + "EncryptedPackage".encode("utf-16-le")


def an_old_workbook() -> bytes:
    return _OLE + bytes(504) + "Workbook".encode("utf-16-le")


def an_old_workbook_with_an_archive_inside() -> bytes:
    return _OLE + bytes(504) + archive(PARTS)


def a_compressed_workbook() -> bytes:
    return gzip.compress(archive(PARTS), mtime=0)


def a_workbook_in_an_archive() -> bytes:
    return archive({"answers.xlsx": archive(PARTS)})


def a_page_with_a_table() -> bytes:
    return b"<html><table><tr><td>1</td></tr></table></html>"


def a_flat_workbook_of_another_program() -> bytes:
    return b"<?xml version='1.0'?><Workbook xmlns='urn:schemas-microsoft-com:office:spreadsheet'/>"


def a_table_of_text() -> bytes:
    return "Сила;22941\r\n".encode("cp1251")


def an_open_document() -> bytes:
    return archive(
        {"mimetype": b"application/vnd.oasis.opendocument.spreadsheet", "content.xml": b"<x/>"}
    )


def a_binary_workbook() -> bytes:
    return archive({"xl/workbook.bin": b"\0"})


def a_text_document() -> bytes:
    return archive({"word/document.xml": b"<w/>"})


def a_page_layout_file() -> bytes:
    return b"%PDF-1.7 ..."


def a_photo() -> bytes:
    return b"\xff\xd8\xff\xe0 JFIF"


def half_a_workbook() -> bytes:
    data = archive(PARTS)
    return data[: len(data) // 2]


def a_workbook_without_its_last_bytes() -> bytes:
    return archive(PARTS)[:-9]


def a_workbook_without_its_first_bytes() -> bytes:
    return archive(PARTS)[30:]


def a_program_before_the_archive() -> bytes:
    return b"PK\x03\x04" + b"\0" * 600 + archive(PARTS)


def bytes_behind_the_archive() -> bytes:
    return archive(PARTS) + bytes(70_000)


def a_comment_that_is_another_archive() -> bytes:
    data = bytearray(archive(PARTS))
    inner = archive({WORKBOOK: b"<workbook/>"})
    data[-2:] = struct.pack("<H", len(inner))
    return bytes(data) + inner


def a_directory_that_begins_nowhere() -> bytes:
    data = bytearray(archive(PARTS))
    place = data.index(_END)
    data[place + 16 : place + 20] = b"\xff\xff\xff\x7f"
    return bytes(data)


def a_directory_with_more_entries_than_there_are() -> bytes:
    data = bytearray(archive(PARTS))
    place = data.index(_END)
    data[place + 8 : place + 12] = b"\xff\xff\xff\xff"
    return bytes(data)


def a_member_with_a_wrong_check_sum() -> bytes:
    return _header_changed(16, b"\1\2\3\4")


def a_member_that_says_it_is_small() -> bytes:
    return _header_changed(24, struct.pack("<I", 3))


def a_member_that_says_it_is_huge() -> bytes:
    return _header_changed(24, struct.pack("<I", 0xFFFFFFF0))


def a_member_that_is_encrypted() -> bytes:
    return _header_changed(8, b"\x01\0")


def a_member_of_an_unknown_method() -> bytes:
    return _header_changed(10, struct.pack("<H", 97))


def a_member_with_a_date_that_there_is_not() -> bytes:
    return _header_changed(12, b"\xff\xff\xff\xff")


def a_member_of_a_later_version() -> bytes:
    return _header_changed(6, b"\xff\xff")


def a_member_whose_name_is_no_text() -> bytes:
    return _header_changed(46, b"\xff\xfe\x80")


def members_by_lzma() -> bytes:
    return archive(PARTS, zipfile.ZIP_LZMA)


def members_by_bzip2() -> bytes:
    return archive(PARTS, zipfile.ZIP_BZIP2)


def a_damaged_member_by_lzma() -> bytes:
    data = bytearray(archive(PARTS, zipfile.ZIP_LZMA))
    data[60:90] = b"\xff" * 30
    return bytes(data)


def a_member_that_unpacks_to_a_gigabyte() -> bytes:
    """Take a sheet of spaces, packed 1 : 1000 once; ten megabytes stand for a gigabyte."""
    return replaced(SHEET, b"</sheetData>", b" " * 10_000_000 + b"</sheetData>")


def many_members_that_unpack_to_much() -> bytes:
    spaces = b"<x>" + b" " * 7_000_000 + b"</x>"
    return archive({**PARTS, **{f"xl/extra{n}.xml": spaces for n in range(5)}})


def a_picture_that_is_a_sheet() -> bytes:
    return with_members(xl__media__a_png=b"<x>" + b" " * 9_000_000 + b"</x>")


def a_picture_that_unpacks_to_much() -> bytes:
    return with_members(xl__media__a_png=b"\x89PNG" + bytes(30_000_000))


def too_many_members() -> bytes:
    return archive({**PARTS, **{f"xl/m{n}.xml": b"" for n in range(2000)}})


def members_with_paths_that_lead_out() -> bytes:
    out = {"../../../../tmp/escaped.xml": b"<x/>", "/etc/escaped": b"x", "C:\\escaped.xml": b"<x/>"}
    return archive({**PARTS, **out})


def two_members_of_one_name() -> bytes:
    stream = io.BytesIO(archive(PARTS))
    with zipfile.ZipFile(stream, "a") as target:
        target.writestr("XL/Workbook.xml", b"<workbook/>")
    return stream.getvalue()


def members_with_backslashes_and_capitals() -> bytes:
    return archive({name.replace("/", "\\").upper(): data for name, data in PARTS.items()})


def a_member_name_of_sixty_thousand_letters() -> bytes:
    return archive({**PARTS, "x" * 60_000 + ".xml": b"<x/>"})


def a_member_name_that_commands_a_terminal() -> bytes:
    return archive({**PARTS, "xl/\x1b]0;owned\x07\u202e.xml": b"<x"})


def no_workbook_inside() -> bytes:
    return _without(WORKBOOK)


def no_sheet_inside() -> bytes:
    return _without(SHEET)


def no_relations_of_the_workbook() -> bytes:
    return _without(RELATIONS)


def no_relations_at_all() -> bytes:
    return _without("_rels/.rels")


def no_table_of_texts() -> bytes:
    return _without(TEXTS)


def no_styles() -> bytes:
    return _without(STYLES)


def no_hidden_sheet() -> bytes:
    return _without(HIDDEN)


def no_properties() -> bytes:
    return _without(PROPERTIES)


def no_list_of_types() -> bytes:
    return _without("[Content_Types].xml")


def a_decoy_of_the_usual_name() -> bytes:
    parts = {**PARTS, "xl/other.xml": b"<workbook/>"}
    relations = PARTS["_rels/.rels"].replace(b"xl/workbook.xml", b"xl/other.xml")
    return archive({**parts, "_rels/.rels": relations})


def a_workbook_part_that_leads_out() -> bytes:
    return replaced("_rels/.rels", "xl/workbook.xml", "../../../etc/passwd")


def a_workbook_part_from_the_network() -> bytes:
    return replaced("_rels/.rels", 'Target="xl/workbook.xml"', 'Target="http://localhost/w.xml"')


def a_workbook_part_that_is_the_relations() -> bytes:
    return replaced("_rels/.rels", "xl/workbook.xml", "_rels/.rels")


def a_sheet_that_is_the_workbook() -> bytes:
    return replaced(RELATIONS, "worksheets/sheet1.xml", "workbook.xml")


def texts_that_are_a_sheet() -> bytes:
    return replaced(RELATIONS, "sharedStrings.xml", "worksheets/sheet1.xml")


def styles_that_are_the_texts() -> bytes:
    return replaced(RELATIONS, "styles.xml", "sharedStrings.xml")


def a_sheet_outside_of_the_file() -> bytes:
    external = b'Target="file:///etc/hostname" TargetMode="External"'
    return replaced(RELATIONS, b'Target="worksheets/sheet1.xml"', external)


def relations_by_the_hundred_thousand() -> bytes:
    many = b'<Relationship Id="x" Type="a/worksheet" Target="worksheets/sheet1.xml"/>' * 90_000
    return patched(
        RELATIONS, lambda part: part.replace(b"</Relationships>", many + b"</Relationships>")
    )
