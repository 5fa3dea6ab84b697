"""Defects with which spreadsheet programs open a workbook, and show its answers as they were."""

import re

from hostile.small_workbook import (
    PARTS,
    PROPERTIES,
    RELATIONS,
    SHEET,
    STYLES,
    TEXTS,
    WORKBOOK,
    after_cells,
    archive,
    patched,
    replaced,
    with_members,
)

_RELATED = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_END_OF_RELATIONS = "</Relationships>"


def _cut(part: str) -> bytes:
    return patched(part, lambda data: data[: len(data) // 2])


def _without(part: str) -> bytes:
    return archive({name: data for name, data in PARTS.items() if name != part})


def _related(kind: str, target: str) -> bytes:
    made = f'<Relationship Id="r9" Type="{_RELATED}/{kind}" Target="{target}"/>'
    return replaced(RELATIONS, _END_OF_RELATIONS, made + _END_OF_RELATIONS)


def all_styles_past_the_last() -> bytes:
    return patched(SHEET, lambda data: re.sub(rb' s="(\d)"', rb' s="9\1"', data))


def styles_that_are_gone() -> bytes:
    return _without(STYLES)


def styles_that_nobody_names() -> bytes:
    return replaced(RELATIONS, "/styles", "/stiles")


def styles_cut_in_the_middle() -> bytes:
    return _cut(STYLES)


def styles_of_no_bytes() -> bytes:
    return archive({**PARTS, STYLES: b""})


def styles_without_formats_of_cells() -> bytes:
    return patched(STYLES, lambda data: re.sub(rb"<cellXfs.*</cellXfs>", b"", data))


def a_format_twice_as_long_as_any() -> bytes:
    return replaced(STYLES, 'formatCode="0.0"', f'formatCode="{"0" * 600}"')


def own_properties_cut_in_the_middle() -> bytes:
    return _cut(PROPERTIES)


def properties_cut_in_the_middle() -> bytes:
    return _cut("docProps/core.xml")


def types_of_content_cut_in_the_middle() -> bytes:
    return _cut("[Content_Types].xml")


def a_theme_cut_in_the_middle() -> bytes:
    return with_members(xl__theme__theme1_xml=b"<a:theme><a:colors>")


def a_pivot_table_cut_in_the_middle() -> bytes:
    return with_members(xl__pivotCache__pivotCacheDefinition1_xml=b"<pivotCacheDefinition><x")


def a_drawing_with_a_letter_that_nobody_declared() -> bytes:
    return with_members(xl__drawings__drawing1_xml=b"<x:wsDr>&nbsp;</x:wsDr>")


def comments_cut_in_the_middle() -> bytes:
    return with_members(xl__comments1_xml=b"<comments")


def an_order_of_computing_cut_in_the_middle() -> bytes:
    return with_members(xl__calcChain_xml=b"<calcChain><c")


def relations_of_a_sheet_cut_in_the_middle() -> bytes:
    return with_members(xl__worksheets___rels__sheet1_xml_rels=b"<Relationships")


def another_workbook_cut_in_the_middle() -> bytes:
    return with_members(xl__externalLinks__externalLink1_xml=b"<externalLink>")


def an_encoding_of_a_drawing_that_there_is_not() -> bytes:
    return with_members(xl__drawings__drawing1_xml=b'<?xml version="1.0" encoding="utf-99"?><x/>')


def a_pivot_table_that_is_gone() -> bytes:
    return _related("pivotCacheDefinition", "pivotCache/none.xml")


def another_workbook_that_is_gone() -> bytes:
    return _related("externalLink", "externalLinks/none.xml")


def properties_that_are_gone() -> bytes:
    return archive({name: data for name, data in PARTS.items() if not name.startswith("docProps")})


def types_of_content_that_are_gone() -> bytes:
    return _without("[Content_Types].xml")


def formats_on_conditions_that_mean_nothing() -> bytes:
    rule = '<cfRule type="x" dxfId="999" priority="-1"><formula>((</formula></cfRule>'
    return after_cells(f'<conditionalFormatting sqref="#REF!">{rule}</conditionalFormatting>')


def print_titles_of_a_sheet_that_is_gone() -> bytes:
    made = '<definedName name="_xlnm.Print_Titles" localSheetId="99">#REF!</definedName>'
    return replaced(WORKBOOK, "<definedNames>", f"<definedNames>{made}")


def targets_from_the_root() -> bytes:
    return replaced(RELATIONS, 'Target="', 'Target="/xl/')


def targets_with_backslashes() -> bytes:
    return replaced(RELATIONS, 'Target="worksheets/', 'Target="worksheets\\')


def targets_written_as_addresses() -> bytes:
    return replaced(RELATIONS, "worksheets/sheet1", "worksheets/%73heet1")


def targets_with_dots() -> bytes:
    return replaced(RELATIONS, "worksheets/sheet1", "./theme/../worksheets/sheet1")


def names_of_members_in_capitals() -> bytes:
    return archive({name.upper(): data for name, data in PARTS.items()})


def names_of_members_with_backslashes() -> bytes:
    return archive({name.replace("/", "\\"): data for name, data in PARTS.items()})


def names_of_members_that_begin_with_a_dot() -> bytes:
    return archive({f"./{name}": data for name, data in PARTS.items()})


def a_folder_of_another_name() -> bytes:
    return archive(
        {
            name.replace("xl/", "book/"): data.replace(b'"xl/', b'"book/')
            for name, data in PARTS.items()
        }
    )


def the_strict_format() -> bytes:
    strict = b"http://purl.oclc.org/ooxml/"
    usual = b"http://schemas.openxmlformats.org/"
    return archive(
        {
            name: data.replace(usual + b"spreadsheetml/2006/main", strict + b"spreadsheetml/main")
            .replace(usual + b"officeDocument/2006/relationships", strict + b"relationships")
            .replace(b"/custom-properties", b"/customProperties")
            for name, data in PARTS.items()
        }
    )


def signs_written_by_their_numbers() -> bytes:
    return replaced(TEXTS, "<t> мм</t>", "<t>_x0020_мм_x000D_\n</t>")


def texts_with_their_pronunciation() -> bytes:
    return replaced(TEXTS, "</r></si>", '</r><rPh sb="0" eb="1"><t>99</t></rPh></si>')


def a_part_of_another_program_with_many_comments() -> bytes:
    return archive({**PARTS, "customXml/item1.xml": b"<x>" + b"1<!-- -->" * 20_000 + b"</x>"})
