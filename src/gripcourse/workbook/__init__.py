"""Workbooks: where each cell is, the answer workbook and the instructor's key workbook."""
