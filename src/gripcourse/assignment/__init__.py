"""What one student is handed: the sheet, the workbook and the register of what was issued."""
