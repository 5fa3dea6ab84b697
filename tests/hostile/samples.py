"""Small sound files of the kinds that strangers send."""

import io
import json
import zipfile
from collections.abc import Mapping
from typing import Final

WORKSHEET: Final = """\
Identifier,"Full name",Status,Grade,"Maximum grade","Grade can be changed",\
"Last modified (grade)","Feedback comments"
"Participant 12","Ольга Иванова","Submitted",,100.00,Yes,-,
"Participant 3","Іван Ковальчук","Submitted",,100.00,Yes,"Saturday, 21 November 2026","<p>a,
b</p>"
"""
GRADEBOOK: Final = """\
Student,ID,SIS User ID,SIS Login ID,Section,РГР 1 (9876),Current Score
    Points Possible,,,,,"50.00",(read only)
"Иванова, Ольга",501,u1,ivanova@uni.ua,РТ-41,,70
"""
TYPED: Final = (
    *("General\n22941,5 Н", "0.0\n-12,5 кН", "0.00%\n5,5", "#,##0.0\\ кН\n1 234,5"),
    *("@\n1,5·10³ мм", "General\n−1,5e-3", "General\nда, выполняется", "General\n２２９４１"),
    *("0,,\n12.03.2026", "General\n45°30′15″", "General\n= 12,5 ± 0,1 мм", "General\n1e400"),
    *("General\n1/2", "General\nØ63H7", "\n10^6 Па"),
)
_DXF: Final = """0 SECTION 2 BLOCKS 0 BLOCK 2 b 70 0 10 0 20 0
0 LINE 8 0 10 0 20 0 11 5 21 5 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES
0 LINE 8 0 10 0 20 0 11 100 21 50 0 CIRCLE 8 0 10 40 20 40 40 20
0 ARC 8 0 10 0 20 0 40 9 50 0 51 90 0 TEXT 8 0 10 1 20 2 40 3.5 1 %%c63H7
0 INSERT 8 0 2 b 10 5 20 5 0 POLYLINE 8 0 66 1 70 1 0 VERTEX 8 0 10 0 20 0
0 VERTEX 8 0 10 9 20 9 0 SEQEND 8 0 0 ENDSEC 0 EOF"""


def _with_members(members: Mapping[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as made:
        for name, content in members.items():
            made.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def works_of_many() -> bytes:
    names = ("s01/a.xlsx", "s01/b.xlsx", "Ольга_12_assignsubmission_file/ответ.xlsx", "c/")
    return _with_members(dict.fromkeys((*names, "ivanovaolga_LATE_12_34_a.xlsx"), bytes(999)))


def solution() -> bytes:
    source = {"work": "a", "equation": "1", "note": ""}
    value = {
        "symbol": "F",
        "title": "force",
        "unit": "N",
        "value": 1.5,
        "kind": "formula",
        "section": "loads",
        "source": source,
    }
    solution = {
        "schema": "gripcourse/solution/1",
        "scheme": "flat",
        "variant": "1",
        "options": {},
        "convention": "corrected",
        "values": {"force": value},
        "assumed": ["x"],
    }
    return json.dumps(solution).encode()


def grades() -> bytes:
    file = {"file": "a", "fate": "graded", "student": "s", "why": "", "message": ""}
    made = {"schema": "gripcourse/grades/1", "reports": [], "needs_person": True, "files": [file]}
    return json.dumps(made).encode()


def drawn() -> bytes:
    """Return a drawing of the oldest kind: a code on one line, its value on the next."""
    return "\n".join(_DXF.split()).encode()
