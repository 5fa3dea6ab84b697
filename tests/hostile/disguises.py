"""Archives of which programs see different things, and files under a name that is not theirs."""

import io
import json
import struct
import zipfile
import zlib
from collections.abc import Mapping

from hostile.small_workbook import (
    PARTS,
    RELATIONS,
    SHEET,
    TEXTS,
    WORKBOOK,
    archive,
    holding,
    in_rows,
    patched,
    replaced,
)

_FORCE = b'<c r="E5" s="1"><v>22941.5</v></c>'
_OTHER_FORCE = b'<c r="E5" s="1"><v>777</v></c>'
_END = b"PK\x05\x06"


def _entry(name: bytes, data: bytes, size: int, start: int, more: bytes = b"") -> bytes:
    head = struct.pack("<4sHHHHHHIIIHHHHHII", b"PK\1\2", 20, 20, 0, 8, 0, 33, zlib.crc32(data),
                       size, len(data), len(name), len(more), 0, 0, 0, 0, start)  # fmt: skip
    return head + name + more


def _local(name: bytes, data: bytes, packed: bytes) -> bytes:
    head = struct.pack("<4sHHHHHIIIHH", b"PK\3\4", 20, 0, 8, 0, 33, zlib.crc32(data),
                       len(packed), len(data), len(name), 0)  # fmt: skip
    return head + name + packed


def _deflated(data: bytes) -> bytes:
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    return packer.compress(data) + packer.flush()


def _by_hand(
    members: Mapping[bytes, bytes], inner: Mapping[bytes, bytes] | None = None, more: bytes = b""
) -> bytes:
    """Pack members whose own names may be others than those of the directory."""
    inner, body, directory = inner or {}, b"", b""
    for name, data in members.items():
        packed = _deflated(data)
        directory += _entry(name, data, len(packed), len(body), more)
        body += _local(inner.get(name, name), data, packed)
    return body + directory + _last(len(members), len(directory), len(body))


def _last(count: int, size: int, start: int) -> bytes:
    return struct.pack("<4sHHHHIIH", _END, 0, 0, count, count, size, start, 0)


def _parts() -> dict[bytes, bytes]:
    return {name.encode(): data for name, data in PARTS.items()}


def members_over_each_other() -> bytes:
    """Let two thousand entries share one packed gigabyte, as the bomb without nesting does."""
    data = b"<x>" + b" " * 7_000_000 + b"</x>"
    packed = _deflated(data)
    body = _local(b"xl/a.xml", data, packed)
    names = [b"xl/%d.xml" % number for number in range(900)]
    directory = b"".join(_entry(name, data, len(packed), 0) for name in names)
    return body + directory + _last(len(names), len(directory), len(body))


def names_inside_that_are_not_those_of_the_directory() -> bytes:
    sheet = SHEET.encode()
    return _by_hand(_parts(), {sheet: b"xl/worksheets/sheet7.xml"})


def another_name_in_a_field_besides() -> bytes:
    """Say by the field of another packer that each name is a different one."""
    name = b"xl/worksheets/evil.xml"
    more = struct.pack("<HHBI", 0x7075, 5 + len(name), 1, zlib.crc32(b"x")) + name
    return _by_hand(_parts(), more=more)


def a_name_that_ends_before_it_ends() -> bytes:
    parts = _parts()
    parts[SHEET.encode() + b"\0.png"] = parts[SHEET.encode()].replace(_FORCE, _OTHER_FORCE)
    return _by_hand(parts)


def two_names_that_differ_by_a_dot_and_a_slash() -> bytes:
    other = PARTS[SHEET].replace(_FORCE, _OTHER_FORCE)
    return archive({**PARTS, "xl/./worksheets//sheet1.xml": other})


def two_names_that_differ_by_an_accent() -> bytes:
    return archive({**PARTS, "xl/\u0439.xml": b"<x/>", "xl/\u0438\u0306.xml": b"<x/>"})


def two_directories_that_differ() -> bytes:
    """Point the longer directory to another workbook than the usual one."""
    other = archive({**PARTS, SHEET: PARTS[SHEET].replace(_FORCE, _OTHER_FORCE)})
    data = archive(PARTS)
    end, end_of_other = data.rindex(_END), other.rindex(_END)
    count, size, start = struct.unpack_from("<HII", other, end_of_other + 10)
    body = data[:end] + other[:end_of_other]
    record = struct.pack("<4sQHHIIQQQQ", b"PK\6\6", 44, 45, 45, 0, 0, count, count, size,
                         end + start)  # fmt: skip
    locator = struct.pack("<4sIQI", b"PK\6\7", 0, len(body), 1)
    return body + record + locator + data[end:]


def a_longer_directory_that_is_nowhere() -> bytes:
    data = archive(PARTS)
    end = data.rindex(_END)
    locator = struct.pack("<4sIQI", b"PK\6\7", 0, 2**63, 1)
    return data[:end] + locator + data[end:]


def sizes_beyond_all() -> bytes:
    more = struct.pack("<HHQQ", 1, 16, 2**63, 2**63)
    data = _by_hand(_parts(), more=more)
    place = data.index(b"PK\1\2")
    return data[: place + 20] + b"\xff" * 8 + data[place + 28 :]


def a_member_that_begins_before_the_file() -> bytes:
    data = bytearray(archive(PARTS))
    place = data.index(b"PK\1\2")
    data[place + 42 : place + 46] = b"\xf0\xff\xff\xff"
    return bytes(data)


def a_size_behind_a_member_that_lies() -> bytes:
    """Say by the directory that sizes stand behind the members, where others stand."""
    data = archive(PARTS)
    place = data.index(b"PK\1\2")
    flagged = data[: place + 8] + b"\x08\0" + data[place + 10 :]
    return flagged[:6] + b"\x08\0" + flagged[8:14] + bytes(12) + flagged[26:]


def a_packed_member_with_more_behind_it() -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_STORED) as target:
        for name, data in PARTS.items():
            target.writestr(zipfile.ZipInfo(name), _deflated(data) + b"x" * 50)
    return stream.getvalue()


def two_disks() -> bytes:
    data = bytearray(archive(PARTS))
    place = data.rindex(_END)
    data[place + 4 : place + 8] = b"\1\0\1\0"
    return bytes(data)


def a_sheet_in_four_byte_letters() -> bytes:
    return patched(SHEET, lambda data: data.decode().replace("UTF-8", "UTF-32").encode("utf-32"))


def a_sheet_in_letters_of_a_mainframe() -> bytes:
    return patched(
        SHEET, lambda data: data.decode().replace("UTF-8", "cp037").encode("cp037", "replace")
    )


def a_sheet_in_seven_bits_that_says_so() -> bytes:
    return patched(SHEET, lambda data: data.decode().replace("UTF-8", "UTF-7").encode("utf-7"))


def a_sheet_declared_twice() -> bytes:
    return patched(SHEET, lambda data: b'<?xml version="1.0"?>\n' + data)


def a_sheet_that_declares_itself_late() -> bytes:
    return patched(SHEET, lambda data: b"\n \n" + data)


def a_document_type_of_nothing() -> bytes:
    return replaced(SHEET, "<worksheet", "<!DOCTYPE worksheet><worksheet")


def a_number_written_in_pieces() -> bytes:
    return holding('<c r="E5"><v>22<!-- x -->941<![CDATA[.]]>5<?x y?></v></c>')


def a_number_of_references() -> bytes:
    return holding('<c r="E5"><v>&#50;&#x32;941&#46;5</v></c>')


def one_cell_for_old_programs_and_one_for_new() -> bytes:
    cell = _OTHER_FORCE.decode()
    return in_rows(
        '<mc:AlternateContent xmlns:mc="m"><mc:Choice Requires="x"><row r="5">'
        f'{cell}</row></mc:Choice><mc:Fallback><row r="5">{cell}</row></mc:Fallback>'
        "</mc:AlternateContent>"
    )


def an_address_by_row_and_column() -> bytes:
    return holding('<c r="R5C5"><v>777</v></c>')


def an_address_in_small_letters() -> bytes:
    return holding('<c r="e5"><v>777</v></c>')


def a_number_raised_to_a_power_by_its_look() -> bytes:
    looks = '<rPr><vertAlign val="superscript"/></rPr>'
    return holding(f'<c r="E5" t="inlineStr"><is><r><t>10</t></r><r>{looks}<t>6</t></r></is></c>')


def looks_inside_looks() -> bytes:
    looks = "<rPr>" * 40 + '<vertAlign val="superscript"/>' + "</rPr>" * 40
    return holding(f'<c r="E5" t="inlineStr"><is><r>{looks}<t>6</t></r></is></c>')


def thousands_of_pieces_of_a_text() -> bytes:
    looks = '<r><rPr><vertAlign val="superscript"/></rPr><t>6</t></r>'
    return replaced(TEXTS, "<si><t>да</t></si>", f"<si>{looks * 8_000}</si>")


def a_picture_that_is_the_value() -> bytes:
    return holding('<c r="E5" t="e" vm="1"><v>#VALUE!</v></c>')


def names_that_differ_by_capitals() -> bytes:
    name = "<definedName name=\"ANSWER.Force\">'1. Расчёт'!$E$13</definedName>"
    return replaced(WORKBOOK, "<definedNames>", f"<definedNames>{name}")


def a_name_that_is_a_function() -> bytes:
    text = "_xlfn.LAMBDA(_xlpm.x,_xlpm.x)"
    return replaced(WORKBOOK, "'1. Расчёт'!$E$5<", f"{text}<")


def a_name_over_several_sheets() -> bytes:
    return replaced(WORKBOOK, "'1. Расчёт'!$E$5<", "'1. Расчёт:_gripcourse'!$E$5<")


def a_name_that_moves() -> bytes:
    return replaced(WORKBOOK, "'1. Расчёт'!$E$5<", "'1. Расчёт'!E5<")


def a_name_of_two_areas() -> bytes:
    where = "'1. Расчёт'!$E$5,'1. Расчёт'!$E$6"
    return replaced(WORKBOOK, "'1. Расчёт'!$E$5<", f"{where}<")


def a_sheet_from_two_relations() -> bytes:
    twice = b'<Relationship Id="r1" Type="x/worksheet" Target="worksheets/sheet2.xml"/>'
    return replaced(RELATIONS, b"</Relationships>", twice + b"</Relationships>")


def a_folder_with_the_workbook_inside() -> bytes:
    """Pack the folder again, not what is in it, as people do who looked inside."""
    return archive({f"answers/{name}": data for name, data in PARTS.items()})


def a_table_of_another_computer() -> bytes:
    return archive({"Index/Document.iwa": b"\0", "Metadata/Properties.plist": b"bplist00"})


def a_link_to_a_drive() -> bytes:
    link = {"url": "https://docs.google.com/spreadsheets/d/x/edit", "doc_id": "x", "email": "a@b.c"}
    return json.dumps(link).encode()


def a_shortcut() -> bytes:
    return b"[InternetShortcut]\r\nURL=https://onedrive.live.com/?id=x\r\n"


def a_page_to_sign_in() -> bytes:
    return b"\n\n<!--[if IE]><![endif]-->\n<!doctype html><html><title>Sign in</title></html>"


def a_page_of_several_parts() -> bytes:
    return b"MIME-Version: 1.0\r\nContent-Type: multipart/related\r\n\r\n<html></html>"


def a_table_of_the_eighties() -> bytes:
    return b"ID;PWXL;N;E\r\nC;Y1;X1;K22941.5\r\nE\r\n"


def a_text_with_looks() -> bytes:
    return b"{\\rtf1\\ansi 22941.5}"


def a_file_of_zeros_after_a_power_cut() -> bytes:
    return bytes(16_384)


def an_archive_of_another_packer() -> bytes:
    return b"Rar!\x1a\x07\x01\x00" + bytes(100)


def an_archive_of_yet_another_packer() -> bytes:
    return b"7z\xbc\xaf\x27\x1c\x00\x04" + bytes(100)


def the_other_half_of_a_macintosh_file() -> bytes:
    return b"\0\x05\x16\x07\0\x02\0\0Mac OS X        " + bytes(60)


def a_placeholder_of_a_cloud() -> bytes:
    return b"bplist00\xd3\x01\x02\x03NSURLNameKeyanswers.xlsx"


def a_slide_show() -> bytes:
    return archive({"ppt/presentation.xml": b"<p/>"})


def a_photo_of_a_telephone() -> bytes:
    return b"\0\0\0\x18ftypheic\0\0\0\0mif1heic" + bytes(40)


def a_photo_of_the_web() -> bytes:
    return b"RIFF\x24\0\0\0WEBPVP8 " + bytes(40)
