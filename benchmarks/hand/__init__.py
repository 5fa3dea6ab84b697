"""A careful student's arithmetic: nothing of the course's engine is used in this folder.

Each formula stands here a second time on purpose, found from free bodies, virtual work and what the
issued workbook prints, so that the course's declarations can be held against it. Everything is
computed in the units of the sheet: N, mm, MPa, degrees, N·m.
"""
