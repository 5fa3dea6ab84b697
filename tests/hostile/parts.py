"""Names, styles, texts, properties and declarations that no spreadsheet program writes."""

from itertools import product
from string import ascii_uppercase

from hostile.small_workbook import (
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
)

_END_OF_NAMES = b"</definedNames>"
_FORCE = "'1. Расчёт'!$E$5"
_LAUGHS = b"".join(
    b'<!ENTITY %c "&%c;&%c;">' % (name + 1, name, name) for name in range(ord("a"), ord("z"))
)


def _declared(part: str, declarations: bytes) -> bytes:
    """Put a document type before a part, and its entity into it."""
    head = b'<?xml version="1.0"?><!DOCTYPE x [%s]>' % declarations
    return patched(part, lambda data: head + data[data.index(b"\n") :].replace(b">", b">&a;", 1))


def _encoded(name: str) -> bytes:
    return replaced(SHEET, 'encoding="UTF-8"', f'encoding="{name}"')


def _name(text: str, name: str = "_xlnm.Print_Titles") -> bytes:
    made = f'<definedName name="{name}" localSheetId="0">{text}</definedName>'.encode()
    return replaced(WORKBOOK, _END_OF_NAMES, made + _END_OF_NAMES)


def _format(code: str) -> bytes:
    return replaced(STYLES, 'formatCode="0.0"', f'formatCode="{code}"')


def an_entity_that_doubles_itself() -> bytes:
    return _declared(SHEET, b'<!ENTITY a "ha">' + _LAUGHS)


def an_entity_that_doubles_itself_in_the_workbook() -> bytes:
    return _declared(WORKBOOK, b'<!ENTITY a "ha">' + _LAUGHS)


def a_long_entity() -> bytes:
    return _declared(TEXTS, b'<!ENTITY a "%s">' % (b"x" * 100_000))


def an_entity_that_is_a_file() -> bytes:
    return _declared(SHEET, b'<!ENTITY a SYSTEM "file:///etc/hostname">')


def an_entity_from_the_network() -> bytes:
    return _declared("docProps/core.xml", b'<!ENTITY a SYSTEM "http://localhost/">')


def a_document_type_from_the_network() -> bytes:
    head = b'<!DOCTYPE x SYSTEM "http://localhost/x.dtd">'
    return patched(STYLES, lambda data: head + data[data.index(b"\n") :])


def a_parameter_entity() -> bytes:
    return _declared(SHEET, b'<!ENTITY % p SYSTEM "file:///etc/hostname"> %p; <!ENTITY a "">')


def an_attribute_that_has_a_default() -> bytes:
    head = b'<!DOCTYPE worksheet [<!ATTLIST v x CDATA "1">]>'
    return patched(SHEET, lambda data: head + data[data.index(b"\n") :])


def a_style_sheet_of_its_own() -> bytes:
    head = b'<?xml version="1.0"?><?xml-stylesheet href="file:///etc/hostname"?>'
    return patched(SHEET, lambda data: head + data[data.index(b"\n") :])


def another_part_included() -> bytes:
    include = '<i:include xmlns:i="http://www.w3.org/2001/XInclude" href="file:///etc/hostname"/>'
    return replaced(SHEET, "</sheetData>", include + "</sheetData>")


def an_encoding_named_true() -> bytes:
    return _encoded("true")


def an_encoding_that_unpacks() -> bytes:
    return _encoded("zip")


def an_encoding_that_turns_letters() -> bytes:
    return _encoded("rot13")


def an_encoding_of_seven_bits() -> bytes:
    return _encoded("utf-7")


def an_encoding_with_a_name_of_fifty_thousand_letters() -> bytes:
    return _encoded("u" * 50_000)


def a_part_in_an_encoding_of_offices() -> bytes:
    def rewritten(data: bytes) -> bytes:
        return data.decode().replace("UTF-8", "windows-1251").encode("cp1251")

    return patched(TEXTS, rewritten)


def a_version_of_xml_that_there_is_not() -> bytes:
    return replaced(SHEET, 'version="1.0"', 'version="9.9"')


def a_comment_of_five_megabytes() -> bytes:
    return replaced(WORKBOOK, "<sheets>", f"<!--{'x' * 5_000_000}--><sheets>")


def print_titles_of_fifty_kilobytes() -> bytes:
    return _name("a!$A:$A," * 6000)


def names_of_whole_columns() -> bytes:
    return _name("'1. Расчёт'!$A:$XFD")


def names_of_answers_scattered_over_all_columns() -> bytes:
    """Look through each column of answers: seven million places."""
    names = "".join(
        f"<definedName name=\"answer.{one}{other}{row}\">'1. Расчёт'!${one}{other}${row}"
        "</definedName>"
        for one, other in product(ascii_uppercase, repeat=2)
        for row in (1, 9_000)
    )
    return replaced(WORKBOOK, _END_OF_NAMES, names.encode() + _END_OF_NAMES)


def fifty_thousand_names() -> bytes:
    return patched(
        WORKBOOK,
        lambda part: part.replace(
            _END_OF_NAMES, b'<definedName name="x">a!$A$1</definedName>' * 50_000 + _END_OF_NAMES
        ),
    )


def fifty_thousand_names_of_answers() -> bytes:
    many = "".join(
        f"<definedName name=\"answer.x{number}\">'1. Расчёт'!$A${number + 1}</definedName>"
        for number in range(50_000)
    )
    return replaced(WORKBOOK, _END_OF_NAMES, many.encode() + _END_OF_NAMES)


def an_answer_in_the_last_row() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'1. Расчёт'!$E$1048576")


def an_answer_of_a_whole_column() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'1. Расчёт'!$E:$E")


def an_answer_of_a_huge_range() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'1. Расчёт'!$A$1:$XFD$1048576")


def an_answer_past_the_last_row() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'1. Расчёт'!$E$9999999")


def an_answer_in_row_zero() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'1. Расчёт'!$E$0")


def an_answer_in_another_file() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'[1]1. Расчёт'!$E$5")


def an_answer_on_a_sheet_that_is_gone() -> bytes:
    return replaced(WORKBOOK, _FORCE, "#REF!$E$5")


def an_answer_that_is_a_formula() -> bytes:
    return replaced(WORKBOOK, _FORCE, "OFFSET('1. Расчёт'!$E$5,0,0)")


def an_answer_that_is_a_number() -> bytes:
    return replaced(WORKBOOK, _FORCE, "22941")


def an_answer_with_a_reference_of_fifty_thousand_letters() -> bytes:
    return replaced(WORKBOOK, _FORCE, "'" * 50_000 + "!$E$5")


def two_places_of_one_answer() -> bytes:
    return _name("'1. Расчёт'!$E$13", "answer.force")


def all_answers_in_one_cell() -> bytes:
    def same(part: bytes) -> bytes:
        for row in range(6, 14):
            part = part.replace(b"$E$%d<" % row, b"$E$5<")
        return part

    return patched(WORKBOOK, same)


def two_sheets_of_one_title() -> bytes:
    return replaced(WORKBOOK, "_gripcourse", "1. Расчёт")


def a_sheet_title_that_is_a_path() -> bytes:
    return replaced(WORKBOOK, "1. Расчёт", "../../x")


def a_sheet_title_of_a_megabyte() -> bytes:
    return replaced(WORKBOOK, "1. Расчёт", "Р" * 500_000)


def a_sheet_listed_two_hundred_times() -> bytes:
    entry = b'<sheet name="x" sheetId="9" r:id="r1"/>'
    return replaced(WORKBOOK, b"</sheets>", entry * 200 + b"</sheets>")


def a_workbook_without_sheets() -> bytes:
    return archive({**PARTS, WORKBOOK: b"<workbook/>"})


def a_workbook_that_is_no_xml() -> bytes:
    return archive({**PARTS, WORKBOOK: b"not xml"})


def days_counted_from_1904() -> bytes:
    return replaced(WORKBOOK, "<workbookPr/>", '<workbookPr date1904="1"/>')


def days_counted_from_nowhere() -> bytes:
    return replaced(WORKBOOK, "<workbookPr/>", '<workbookPr date1904="perhaps"/>')


def a_format_of_open_brackets() -> bytes:
    return _format("[" * 100_000)


def a_format_of_quotation_marks() -> bytes:
    return _format("&quot;" * 50_000)


def a_short_format_that_is_hard_to_search() -> bytes:
    return _format("&quot;" + "[" * 240 + "_\\*" * 80)


def a_format_of_thousands() -> bytes:
    return _format("0" + "," * 480)


def a_format_of_time_without_end() -> bytes:
    return _format("[h]" * 160)


def a_format_that_writes_a_unit() -> bytes:
    return _format("0.0&quot; кН&quot;")


def a_format_of_a_hundred_thousand() -> bytes:
    many = b'<numFmt numFmtId="900" formatCode="0"/>' * 90_000
    return replaced(STYLES, b"</numFmts>", many + b"</numFmts>")


def a_hundred_and_fifty_thousand_styles() -> bytes:
    return replaced(STYLES, b"</cellXfs>", b"<xf/>" * 150_000 + b"</cellXfs>")


def styles_with_no_format() -> bytes:
    return replaced(STYLES, 'numFmtId="164"/>', 'numFmtId="199"/>')


def styles_whose_format_is_a_word() -> bytes:
    return replaced(STYLES, 'numFmtId="164"/>', 'numFmtId="none"/>')


def styles_without_styles() -> bytes:
    return archive({**PARTS, STYLES: b"<styleSheet/>"})


def eight_megabytes_of_styles() -> bytes:
    return replaced(STYLES, "</styleSheet>", f"<x>{' ' * 7_900_000}</x></styleSheet>")


def a_hundred_thousand_texts() -> bytes:
    return replaced(TEXTS, b"</sst>", b"<si/>" * 100_000 + b"</sst>")


def a_text_of_a_megabyte() -> bytes:
    return replaced(TEXTS, ">да<", f">{'да' * 300_000}<")


def a_text_of_many_runs() -> bytes:
    return replaced(TEXTS, "<r><t>63</t></r>", "<r><t>6</t></r>" * 50_000)


def a_text_inside_a_text() -> bytes:
    return replaced(TEXTS, "<t>да</t>", "<si><t>1</t></si><t>да</t>")


def a_text_of_half_a_letter() -> bytes:
    return replaced(TEXTS, ">да<", ">&#xD83D;<")


def a_text_of_no_letter() -> bytes:
    return replaced(TEXTS, ">да<", ">&#0;<")


def a_text_that_nobody_calls_so() -> bytes:
    return replaced(TEXTS, ">да<", ">&nobody;<")


def a_text_with_commands_of_a_terminal() -> bytes:
    return replaced(TEXTS, ">да<", ">_x001B_[31m&#x9b;2J<")


def an_identity_that_commands_a_terminal() -> bytes:
    return replaced(TEXTS, ">s001<", ">\u202e100s\u0085<")


def an_identity_of_a_megabyte() -> bytes:
    return replaced(TEXTS, ">s001<", f">{'s' * 1_000_000}<")


def properties_by_the_ten_thousand() -> bytes:
    many = b'<property name="gripcourse.student"><x>s002</x></property>' * 30_000
    return replaced(PROPERTIES, b"</Properties>", many + b"</Properties>")


def a_date_of_the_properties_that_is_a_year() -> bytes:
    return replaced("docProps/core.xml", "<creator>", "<created>2026</created><creator>")


def options_without_end() -> bytes:
    options = f'<property name="gripcourse.options"><x>{"a=b;" * 200_000}</x></property>'
    return replaced(PROPERTIES, "</Properties>", options + "</Properties>")


def a_million_comments_inside_a_number() -> bytes:
    return replaced(SHEET, b"<v>22941.5</v>", b"<v>" + b"1<!---->" * 900_000 + b"</v>")


def ten_thousand_comments_behind_a_long_text() -> bytes:
    return replaced(
        SHEET, b"<v>22941.5</v>", b"<v>" + b"1" * 7_700_000 + b"1<!---->" * 9_900 + b"</v>"
    )


def a_text_of_two_byte_letters_in_pieces_between_comments() -> bytes:
    pieces = "<v>" + ("1" * 20 + "<!---->") * 100_000 + "</v>"
    return patched(
        SHEET,
        lambda part: (
            part.decode()
            .replace("UTF-8", "UTF-16")
            .replace("<v>22941.5</v>", pieces)
            .encode("utf-16")
        ),
    )


def a_million_instructions_inside_a_text() -> bytes:
    return replaced(TEXTS, "<si>", "<si><t>" + "1<?a?>" * 900_000 + "</t></si><si>")


def a_relation_to_a_name_of_eight_megabytes() -> bytes:
    target = b"%C3" * 2_500_000
    many = b'<Relationship Id="x" Type="a/worksheet" Target="%s"/></Relationships>' % target
    return replaced(RELATIONS, b"</Relationships>", many)


def a_text_of_millions_of_words_that_every_title_shares() -> bytes:
    return replaced(TEXTS, "Величина", "я " * 2_400_000)


def a_text_of_millions_of_lines() -> bytes:
    return replaced(TEXTS, "Величина", "я\n" * 2_400_000)


def a_crossed_out_text_of_megabytes() -> bytes:
    crossed = "1\u0336" * 2_400_000
    return replaced(TEXTS, "<t> мм</t>", f"<t>{crossed}</t>")
