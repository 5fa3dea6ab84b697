"""A returned workbook of unknown origin, read into answers and remarks."""
