"""Sheets and cells that no spreadsheet program writes."""

from hostile.small_workbook import (
    PARTS,
    SHEET,
    after_cells,
    archive,
    holding,
    in_rows,
    patched,
    replaced,
    stored,
)


def a_whole_column_merged() -> bytes:
    return replaced(SHEET, "E13:F13", "B1:B1048576")


def a_whole_sheet_merged() -> bytes:
    return replaced(SHEET, "E13:F13", "A1:XFD1048576")


def columns_merged_without_rows() -> bytes:
    return replaced(SHEET, "E13:F13", "A:XFD")


def fifty_thousand_merged_ranges() -> bytes:
    return after_cells('<mergeCells><mergeCell ref="H1:I1"/></mergeCells>' * 50_000)


def a_merged_range_that_is_none() -> bytes:
    return replaced(SHEET, "E13:F13", "#REF!:ZZZZ0")


def a_merged_range_from_right_to_left() -> bytes:
    return replaced(SHEET, "E13:F13", "F13:E5")


def merged_ranges_over_each_other() -> bytes:
    over = '<mergeCells><mergeCell ref="E5:E9"/><mergeCell ref="E9:E12"/></mergeCells>'
    return after_cells(over)


def a_link_over_the_whole_sheet() -> bytes:
    return after_cells('<hyperlinks><hyperlink ref="A1:XFD1048576" location="x"/></hyperlinks>')


def a_lie_about_the_size() -> bytes:
    return replaced(SHEET, "A1:F13", "A1:XFD1048576")


def a_size_that_is_none() -> bytes:
    return replaced(SHEET, "A1:F13", "-1:$$")


def a_cell_in_the_last_corner() -> bytes:
    return in_rows('<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>')


def a_row_far_below_the_last() -> bytes:
    return in_rows('<row r="2000000000"><c><v>1</v></c></row>')


def a_row_with_a_number_of_four_thousand_digits() -> bytes:
    return in_rows(f'<row r="{"9" * 4000}"><c><v>1</v></c></row>')


def rows_with_negative_numbers() -> bytes:
    return in_rows('<row r="-5"><c r="E-5"><v>1</v></c></row>')


def rows_in_any_order() -> bytes:
    return in_rows('<row r="3"><c r="E3"><v>1</v></c></row><row r="1"><c r="E1"><v>2</v></c></row>')


def the_same_row_twice() -> bytes:
    return in_rows('<row r="5"><c r="E5"><v>777</v></c></row>')


def the_same_cell_twice() -> bytes:
    return holding('<c r="E5"><v>1</v></c><c r="E5"><v>2</v></c>')


def a_cell_in_a_row_that_is_not_its_own() -> bytes:
    return in_rows('<row r="20"><c r="E5"><v>777</v></c></row>')


def cells_without_addresses() -> bytes:
    return patched(SHEET, lambda part: part.replace(b' r="E5"', b"").replace(b' r="C5"', b""))


def a_cell_with_an_address_of_many_letters() -> bytes:
    return holding(f'<c r="{"E" * 9000}5"><v>1</v></c>')


def a_cell_with_digits_of_another_script() -> bytes:
    return holding('<c r="E٥"><v>١٢٣</v></c>')


def a_quarter_of_a_million_cells() -> bytes:
    return in_rows('<row r="30">' + "<c/>" * 250_000 + "</row>")


def elements_inside_each_other() -> bytes:
    return after_cells("<x>" * 50_000 + "</x>" * 50_000)


def cells_inside_a_cell() -> bytes:
    return holding('<c r="E5"><c r="E5"><c r="E5"><v>1</v></c></c></c>')


def rows_inside_a_row() -> bytes:
    return in_rows('<row r="5"><row r="5"><c r="E5"><v>1</v></c></row></row>')


def values_that_are_twins() -> bytes:
    return holding('<c r="E5"><v>1</v><v>2</v></c>')


def a_value_with_elements_inside() -> bytes:
    return holding('<c r="E5"><v>1<b>2</b>3</v></c>')


def a_number_that_is_none() -> bytes:
    return stored("NaN")


def a_number_without_end() -> bytes:
    return stored("INF")


def a_number_with_a_comma() -> bytes:
    return stored("1,5")


def a_number_of_ten_thousand_digits() -> bytes:
    return stored("9" * 10_000)


def a_number_of_four_thousand_digits() -> bytes:
    return stored("9" * 3999)


def a_number_beyond_all() -> bytes:
    return stored("1e999999999")


def a_number_in_another_base() -> bytes:
    return stored("0x1F")


def a_number_with_underlines() -> bytes:
    return stored("1_000")


def a_number_in_digits_of_another_script() -> bytes:
    return stored("١٢٣")


def a_number_between_spaces_and_line_ends() -> bytes:
    return stored(" \n 12.5 \n ")


def a_boolean_that_is_neither() -> bytes:
    return stored("2", "b")


def an_error_that_there_is_not() -> bytes:
    return stored("#OWNED!" * 999, "e")


def a_date_that_there_is_not() -> bytes:
    return stored("99999-99-99", "d")


def a_date_with_a_zone() -> bytes:
    return stored("2026-02-03T10:00:00+99:99", "d")


def a_date_number_beyond_all() -> bytes:
    return holding('<c r="E5" s="2"><v>1e300</v></c>')


def a_date_number_below_all() -> bytes:
    return holding('<c r="E5" s="2"><v>-99999999</v></c>')


def a_date_number_of_four_thousand_digits() -> bytes:
    return holding(f'<c r="E5" s="2"><v>{"9" * 3999}</v></c>')


def a_kind_of_cell_that_there_is_not() -> bytes:
    return stored("5", "quantum")


def a_text_past_the_last() -> bytes:
    return stored("4", "s")


def a_text_before_the_first() -> bytes:
    return stored("-1", "s")


def a_text_whose_index_is_a_power() -> bytes:
    return stored("1²", "s")


def a_text_whose_index_is_none() -> bytes:
    return stored("", "s")


def a_style_past_the_last() -> bytes:
    return holding('<c r="E5" s="4"><v>5</v></c>')


def a_style_before_the_first() -> bytes:
    return holding('<c r="E5" s="-1"><v>5</v></c>')


def a_style_of_many_digits() -> bytes:
    return holding(f'<c r="E5" s="{"9" * 5000}"><v>5</v></c>')


def a_formula_of_a_megabyte() -> bytes:
    return holding(f'<c r="E5"><f>{"1+" * 500_000}1</f><v>5</v></c>')


def a_formula_without_a_result() -> bytes:
    return holding('<c r="E5"><f>E13*2</f></c>')


def a_formula_with_an_empty_result() -> bytes:
    return holding('<c r="E5" t="str"><f>IF(1,"","")</f><v></v></c>')


def a_formula_that_asks_another_program() -> bytes:
    return holding("<c r=\"E5\"><f>cmd|' /C calc'!A0</f><v>5</v></c>")


def a_formula_that_asks_the_network() -> bytes:
    return holding('<c r="E5"><f>WEBSERVICE("http://localhost/")</f><v>5</v></c>')


def an_inline_text_without_one() -> bytes:
    return holding('<c r="E5" t="inlineStr"/>')


def an_inline_text_of_a_megabyte() -> bytes:
    return holding(f'<c r="E5" t="inlineStr"><is><t>{"9" * 1_000_000}</t></is></c>')


def a_text_of_signs_that_nobody_sees() -> bytes:
    return holding('<c r="E5" t="inlineStr"><is><t>\u202e12\u200b\ufeff\u2066</t></is></c>')


def a_text_that_would_be_a_formula() -> bytes:
    return holding('<c r="E5" t="inlineStr"><is><t>=HYPERLINK("http://localhost")</t></is></c>')


def a_unit_raised_to_many_digits() -> bytes:
    text = f"5 мм^{'9' * 60}"
    return holding(f'<c r="E5" t="inlineStr"><is><t>{text}</t></is></c>')


def a_unit_of_many_factors() -> bytes:
    text = "5 " + "мм*" * 60 + "мм"
    return holding(f'<c r="E5" t="inlineStr"><is><t>{text}</t></is></c>')


def a_power_of_ten_of_many_digits() -> bytes:
    return holding(f'<c r="E5" t="inlineStr"><is><t>1e{"9" * 190}</t></is></c>')


def signs_that_are_digits_only_by_name() -> bytes:
    return holding('<c r="E5" t="inlineStr"><is><t>②⑦¹² ٣</t></is></c>')


def a_million_ranges_in_one_validation() -> bytes:
    return after_cells(
        f'<dataValidations><dataValidation sqref="{"A1 " * 950_000}"/></dataValidations>'
    )


def an_attribute_of_seven_megabytes() -> bytes:
    return holding(f'<c r="E5" x="{"a" * 7_000_000}"><v>5</v></c>')


def a_hundred_thousand_attributes() -> bytes:
    many = " ".join(f'a{number}="1"' for number in range(100_000))
    return holding(f'<c r="E5" {many}><v>5</v></c>')


def seven_hundred_thousand_attributes() -> bytes:
    many = " ".join(f'a{number:x}=""' for number in range(700_000))
    return holding(f'<c r="E5" {many}><v>5</v></c>')


def two_hundred_thousand_elements_each_of_which_is_called_otherwise() -> bytes:
    return after_cells("".join(f'<x{one:x} a{one:x}="{one:x}"/>' for one in range(199_000)))


def a_hundred_thousand_attributes_in_two_byte_letters() -> bytes:
    many = " ".join(f'a{number:x}=""' for number in range(100_000))
    text = f'<?xml version="1.0" encoding="UTF-16"?><worksheet {many}/>'
    return patched(SHEET, lambda _: text.encode("utf-16"))


def a_hundred_thousand_namespaces() -> bytes:
    many = " ".join(f'xmlns:a{number}="u{number}"' for number in range(100_000))
    return holding(f'<c r="E5" {many}><v>5</v></c>')


def a_drawing_that_is_not_there() -> bytes:
    return after_cells('<drawing xmlns:r="r" r:id="r9"/><legacyDrawing xmlns:r="r" r:id="r8"/>')


def a_sheet_of_another_namespace() -> bytes:
    return replaced(SHEET, "spreadsheetml/2006/main", "nobody")


def a_sheet_of_a_chart() -> bytes:
    return archive({**PARTS, SHEET: b"<chartsheet/>"})


def a_sheet_of_a_page() -> bytes:
    return archive({**PARTS, SHEET: b"<!DOCTYPE html><html><body>1</body></html>"})


def a_sheet_without_content() -> bytes:
    return archive({**PARTS, SHEET: b""})


def a_sheet_of_zeros() -> bytes:
    return archive({**PARTS, SHEET: bytes(100_000)})


def a_sheet_cut_in_the_middle() -> bytes:
    return patched(SHEET, lambda part: part[: len(part) // 2])


def two_sheets_in_one_part() -> bytes:
    return patched(SHEET, lambda part: part + part)


def a_sheet_with_a_zero_byte() -> bytes:
    return replaced(SHEET, "22941.5", b"22\x00941.5")


def a_sheet_that_is_no_unicode() -> bytes:
    return replaced(SHEET, "22941.5", b"\xff\xfe\xed\xa0\x80")


def a_sheet_in_two_byte_letters() -> bytes:
    def rewritten(part: bytes) -> bytes:
        return part.decode().replace("UTF-8", "UTF-16").encode("utf-16")

    return patched(SHEET, rewritten)


def a_sheet_in_two_byte_letters_that_says_otherwise() -> bytes:
    return patched(SHEET, lambda part: part.decode().encode("utf-16"))
