"""The server: students check and hand in by a browser, instructors have a desk.

It parses, makes one call of a use case, and shows a page; it never judges a workbook itself.
"""
