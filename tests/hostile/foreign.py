"""Workbooks as programs other than Excel write them, or as people repack them: all are sound."""

import io
import struct
import zipfile
from collections.abc import Callable
from typing import Final

from hostile.small_workbook import (
    HIDDEN,
    PARTS,
    RELATIONS,
    SHEET,
    STYLES,
    TEXTS,
    WORKBOOK,
    after_cells,
    archive,
    holding,
    replaced,
    with_members,
)

_FORCE: Final = '<c r="E5" s="1"><v>22941.5</v></c>'
_MAIN: Final = b'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'


class _Pipe(io.BytesIO):
    """What can only be written forwards, as a connection."""

    def seekable(self) -> bool:
        return False

    def tell(self) -> int:
        raise OSError


def _packed(change: Callable[[zipfile.ZipInfo], None]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as target:
        for name, data in PARTS.items():
            member = zipfile.ZipInfo(name)
            change(member)
            target.writestr(member, data, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def sizes_behind_the_members() -> bytes:
    """Stream it, as servers do: sizes are not known when a member begins."""
    stream = _Pipe()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as target:
        for name, data in PARTS.items():
            target.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def sizes_of_eight_bytes() -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as target:
        for name, data in PARTS.items():
            with target.open(zipfile.ZipInfo(name), "w", force_zip64=True) as member:
                member.write(data)
    return stream.getvalue()


def a_directory_of_eight_bytes() -> bytes:
    data = archive(PARTS)
    end = data.rindex(b"PK\x05\x06")
    count, size, start = struct.unpack_from("<HII", data, end + 10)
    record = struct.pack("<4sQHHIIQQQQ", b"PK\x06\x06", 44, 45, 45, 0, 0, count, count, size, start)
    locator = struct.pack("<4sIQI", b"PK\x06\x07", 0, end, 1)
    last = struct.pack("<4sHHHHIIH", b"PK\x05\x06", 0, 0, 65535, 65535, 2**32 - 1, 2**32 - 1, 0)
    return data[:end] + record + locator + last


def names_in_utf_8_by_an_older_packer() -> bytes:
    def unmarked(member: zipfile.ZipInfo) -> None:
        member.flag_bits |= 0x800
        member.create_system = 3

    return _packed(unmarked)


def folders_as_members() -> bytes:
    return archive({"xl/": b"", "xl/worksheets/": b"", "_rels/": b"", "docProps/": b"", **PARTS})


def what_a_macintosh_packs_besides() -> bytes:
    double = b"\0\x05\x16\x07\0\x02\0\0Mac OS X        \0\x02"
    return archive(
        {**PARTS, "__MACOSX/xl/._workbook.xml": double, "__MACOSX/._xl": double, ".DS_Store": b"\0"}
    )


def what_windows_packs_besides() -> bytes:
    return archive({**PARTS, "desktop.ini": b"[.ShellClassInfo]", "xl/Thumbs.db": b"\xd0\xcf"})


def a_prefix_before_all_elements() -> bytes:
    """Write it as the libraries of Microsoft and 1C do."""

    def prefixed(data: bytes) -> bytes:
        text = data.replace(_MAIN, _MAIN.replace(b"xmlns=", b"xmlns:x="))
        head, _, body = text.partition(b"?>\n")
        body = body.replace(b"</", b"\0").replace(b"<", b"<x:").replace(b"\0", b"</x:")
        return head + b"?>\n" + body

    parts = {name: prefixed(PARTS[name]) for name in (WORKBOOK, SHEET, HIDDEN, TEXTS, STYLES)}
    return archive({**PARTS, **parts})


def a_formula_that_others_share() -> bytes:
    return holding('<c r="E5" s="1"><f t="shared" ref="E5:E6" si="0">1+1</f><v>22941.5</v></c>')


def a_formula_that_shares_another() -> bytes:
    return holding('<c r="E5" s="1"><f t="shared" si="0"/><v>22941.5</v></c>')


def a_formula_of_an_array() -> bytes:
    return holding('<c r="E5" s="1"><f t="array" ref="E5">SUM(A1*2)</f><v>22941.5</v></c>')


def a_formula_that_spills() -> bytes:
    """Write it as newest Excel does: with a number of metadata."""
    cell = '<c r="E5" s="1" cm="1"><f t="array" ref="E5">_xlfn.LET(_xlpm.a,1,_xlpm.a)</f>'
    data = holding(f"{cell}<v>22941.5</v></c>")
    with zipfile.ZipFile(io.BytesIO(data)) as made:
        parts = {name: made.read(name) for name in made.namelist()}
    return archive({**parts, "xl/metadata.xml": b"<metadata/>"})


def a_formula_of_a_table_of_data() -> bytes:
    return holding('<c r="E5" s="1"><f t="dataTable" ref="E5" r1="A1"/><v>22941.5</v></c>')


def a_function_of_its_own() -> bytes:
    name = '<definedName name="MyForce">_xlfn.LAMBDA(_xlpm.m,_xlpm.m*9.81)</definedName>'
    return replaced(WORKBOOK, "<definedNames>", f"<definedNames>{name}")


def names_of_formulas_of_other_kinds() -> bytes:
    several = "".join(
        f'<definedName name="own{number}">{text}</definedName>'
        for number, text in enumerate(
            (
                "OFFSET(a!$A$1,1,1)",
                "a!$A$1,a!$B$2",
                "a:b!$A$1",
                "Table1[[#All],[x]]",
                "{1,2}",
                "#REF!",
            )
        )
    )
    return replaced(WORKBOOK, "<definedNames>", f"<definedNames>{several}")


def a_comment_inside_a_number() -> bytes:
    return holding('<c r="E5" s="1"><!-- by hand --><v>22941.5</v></c>')


def a_number_with_all_its_digits() -> bytes:
    return holding('<c r="E5" s="1"><v>22941.500000000000</v></c>')


def a_number_as_a_power() -> bytes:
    return holding('<c r="E5" s="1"><v>2.29415E4</v></c>')


def a_cell_with_rules_for_its_look() -> bytes:
    return after_cells(
        '<extLst><ext uri="{x}" xmlns:x14="x"><x14:conditionalFormattings>'
        "<x14:conditionalFormatting/></x14:conditionalFormattings></ext></extLst>"
    )


def what_newer_programs_only_may_read() -> bytes:
    choice = (
        '<mc:AlternateContent xmlns:mc="m"><mc:Choice Requires="x15"><x15ac:absPath'
        ' xmlns:x15ac="x" url="C:\\Users\\Ольга\\"/></mc:Choice></mc:AlternateContent>'
    )
    return replaced(WORKBOOK, "<workbookPr/>", f"<workbookPr/>{choice}")


def remarks_of_several_people() -> bytes:
    return with_members(
        xl__threadedComments__threadedComment1_xml=b'<ThreadedComments><threadedComment ref="E5"'
        b' personId="{1}" id="{2}"><text>5</text></threadedComment></ThreadedComments>',
        xl__persons__person_xml=b'<personList><person displayName="x" id="{1}"/></personList>',
        xl__comments1_xml=b'<comments><commentList><comment ref="E5"><text><t>77</t></text>'
        b"</comment></commentList></comments>",
    )


def what_wps_writes_besides() -> bytes:
    built = b'<property name="KSOProductBuildVer"><lpwstr>1049-11.2.0.11537</lpwstr></property>'
    own = PARTS["docProps/custom.xml"].replace(b"</Properties>", built + b"</Properties>")
    return archive({**PARTS, "docProps/custom.xml": own})


def texts_without_a_table() -> bytes:
    """Write every text into its cell, as libraries do that stream."""
    texts = ("Величина", "63 мм", "да", "s001")
    parts: dict[str, bytes] = dict(PARTS)
    for name in (SHEET, HIDDEN):
        data = parts[name].decode()
        for number, text in enumerate(texts):
            old = f't="s"><v>{number}</v>'
            data = data.replace(old, f't="inlineStr"><is><t>{text}</t></is>')
        parts[name] = data.encode()
    del parts[TEXTS]
    parts[RELATIONS] = PARTS[RELATIONS].replace(b"sharedStrings", b"nothing")
    return archive(parts)


def texts_of_many_looks() -> bytes:
    looks = "<rPr><sz val='9'/><color rgb='FF000000'/><rFont val='Calibri'/></rPr>"
    return replaced(TEXTS, "<r><t>63</t></r>", f"<r>{looks}<t>6</t></r><r>{looks}<t>3</t></r>")


def relations_in_another_order_with_more() -> bytes:
    more = b'<Relationship Id="r0" Type="x/calcChain" Target="calcChain.xml"/>'
    return replaced(RELATIONS, b'relationships">', b'relationships">' + more)
