"""What we fill in is what the platforms' own importers take, by the rules that their source states.

The rules are told here in our own words, from Moodle's `mod/assign/feedback/offline/locallib.php`
(`process_import_grades`), `importgradeslib.php` beside it and `lib/csvlib.class.php`, and from
`lib/gradebook_importer.rb` of Canvas. The programs themselves are not run here; Moodle's once was,
see `docs/decisions/0025-learning-platforms.md`.
"""

import csv
import io
import re
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime

import pytest

from gripcourse.exports.platforms.canvas import fill_gradebook
from gripcourse.exports.platforms.moodle_worksheet import (
    FilledWorksheet,
    fill_worksheet,
    read_worksheet,
)
from gripcourse.exports.platforms.works import GradedWork
from gripcourse.machine.content import NamedBytes

Works = Callable[[dict[str, str]], tuple[GradedWork, ...]]
SHEETS = {
    "en": (
        "Identifier,Grade,Maximum grade,Last modified (grade),Feedback comments",
        "Participant 12,{grade},100.00,{date},",
        "Saturday, 21 November 2026, 8:07 AM",
        "60.25",
    ),
    "ru": (
        "Идентификатор,Оценка,Максимальная оценка,Последнее изменение (оценка),Отзыв",
        "Участник12,{grade},100.00,{date},",
        "суббота, 21 ноября 2026, 08:07",
        '"60,25"',
    ),
    "uk": (
        "Ідентифікатор,Оцінка,Максимальна оцінка,Востаннє змінювалося (оцінка),Відгук - коментарем",
        "Учасник12,{grade},100.00,{date},",
        "Saturday 21 November 2026 08:07 AM",
        '"60,25"',
    ),
}
HIDDEN = {"en": "Participant ", "ru": "Участник", "uk": "Учасник"}
COMMA = {"en": ".", "ru": ",", "uk": ","}
GRADED = datetime(2026, 11, 21, 8, 7, 40)  # noqa: DTZ001 (the server's own clock)


def moodle_updates(
    content: bytes, language: str, known: Mapping[int, tuple[float, datetime]]
) -> dict[int, float]:
    """Return the grades that Moodle takes, by participant; it says how many they are.

    Args:
        content: of the worksheet.
        language: of the session that imports it.
        known: grade and time of it, of each participant who has one.
    """
    text = content.decode().removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    header, *rows = csv.reader(io.StringIO(text))
    assert {len(row) for row in rows} == {len(header)}  # else the whole file is refused
    words = SHEETS[language][0].split(",")
    identifier, grade, date = (header.index(words[at]) for at in (0, 1, 3))
    taken: dict[int, float] = {}
    for row in rows:
        # As many bytes are cut off as the word for a hidden name has.
        number = int(row[identifier].encode()[len(HIDDEN[language].encode()) :].decode())
        new = php_float(row[grade], COMMA[language])
        before = known.get(number)
        stale = before is not None and (before[1] - php_time(row[date])).total_seconds() > 60
        if new is None or stale or (before is not None and before[0] == new) or not 0 <= new <= 100:
            continue
        taken[number] = new
    return taken


def php_float(text: str, separator: str) -> float | None:
    """Read a number as PHP casts a text to one: what begins like it, and 0 for a word."""
    bare = text.replace(" ", "").replace(separator, ".")
    if not bare:
        return None
    begin = re.match(r"-?\d+(\.\d+)?", bare)
    return float(begin[0]) if begin else 0.0


def php_time(text: str) -> datetime:
    """Read a date that PHP's `strtotime` is sure of; what it cannot read is the year 1970."""
    for form in ("%Y-%m-%d %H:%M", "%A, %d %B %Y, %I:%M %p", "%A %d %B %Y %I:%M %p"):
        try:
            return datetime.strptime(text, form)  # noqa: DTZ007 (as above)
        except ValueError:
            continue
    return datetime(1970, 1, 1)  # noqa: DTZ001 (as above)


def worksheet(
    language: str, works: Works, *, graded: bool, grade: str | None = None
) -> FilledWorksheet:
    header, row, date, old = SHEETS[language]
    cells = {"grade": (grade or old) if graded else "", "date": f'"{date}"' if graded else "-"}
    source = NamedBytes("Grades.csv", f"{header}\n{row.format(**cells)}\n".encode("utf-8-sig"))
    found = works({"Участник_12_assignsubmission_file/s.xlsx": "s17"})
    return fill_worksheet(read_worksheet(source), found, lambda _: "ok")


@pytest.mark.parametrize("language", SHEETS)
@pytest.mark.parametrize("known", [{}, {12: (60.25, GRADED)}])
def test_moodle_takes_every_grade_that_we_fill_in(
    language: str, known: dict[int, tuple[float, datetime]], works: Works
) -> None:
    filled = worksheet(language, works, graded=bool(known))
    taken = moodle_updates(filled.content, language, known)
    assert len(taken) == filled.updates == 1
    assert taken[12] == pytest.approx(100 * works({"s.xlsx": "s17"})[0].share, abs=0.005)


@pytest.mark.parametrize("language", SHEETS)
def test_a_grade_that_is_there_already_is_not_promised_as_an_update(
    language: str, works: Works
) -> None:
    same = f"{100 * works({'s.xlsx': 's17'})[0].share:.2f}"
    filled = worksheet(language, works, graded=True, grade=same)
    known = {12: (float(same), GRADED)}
    assert moodle_updates(filled.content, language, known) == {}
    assert (filled.filled, filled.updates) == (1, 0)


def test_a_grade_of_later_than_the_worksheet_is_not_overwritten(works: Works) -> None:
    filled = worksheet("ru", works, graded=True)
    later = GRADED.replace(hour=9)
    assert moodle_updates(filled.content, "ru", {12: (70.0, later)}) == {}


CANVAS = {
    "login": "Student,ID,SIS Login ID,Section,РГР (9),Final Score",
    "both": "Student,ID,SIS User ID,SIS Login ID,Section,РГР (9),Final Score",
    "user": "Student,ID,SIS User ID,Section,РГР (9),Final Score",
    "plain": "Student,ID,Section,РГР (9),Final Score",
    "names": "LastName,FirstName,ID,SIS Login ID,Section,РГР (9),Final Score",
    "root": "Student,ID,SIS User ID,SIS Login ID,Root Account,Section,Note,РГР (9),Final Score",
}


def canvas_table(header: str, works: Works, possible: str = "50") -> tuple[bytes, tuple[str, ...]]:
    width = header.count(",") + 1
    names = header.startswith("LastName")
    first = ["    Points Possible", *[""] * (width - 3), possible, "(read only)"]
    person = ["Иванова", *(["Ольга"] if names else []), "501", *[""] * width][:width]
    rows = "\n".join(",".join(row) for row in (first, person))
    source = NamedBytes("export.csv", f"{header}\n{rows}\n".encode("utf-8-sig"))
    filled = fill_gradebook(source, works({"ивановаольга_501_7_s.xlsx": "s17"}), "")
    return filled.content, tuple(map(str, filled.notes))


def last_of_student(header: Sequence[str]) -> str:
    """Return the heading that Canvas takes for the last one about a person."""
    named = header[0] == "LastName" and header[1] == "FirstName"
    assert named or ("Student" in header[0] and "ID" in header[1])
    count = at = 4 if named else 3
    if "SIS Login ID" in header[at - 1]:
        count += 1
    elif "SIS User ID" in header[at - 1] and "SIS Login ID" in header[at]:
        count += 2
    return header[count - 1]


@pytest.mark.parametrize("kind", CANVAS)
def test_canvas_finds_people_and_the_assignment_in_what_we_write(kind: str, works: Works) -> None:
    content, notes = canvas_table(CANVAS[kind], works)
    header, possible, person = csv.reader(io.StringIO(content.decode()))  # a mark would stay in it
    assert len({len(header), len(possible), len(person)}) == 1
    assert "Section" in last_of_student(header)
    assert header[header.index("Section") + 1 :] == ["РГР (9)"]  # by the number in brackets
    assert "Points Possible" in possible[0]
    assert person[2 if kind == "names" else 1] == "501"
    assert re.fullmatch(r"-?[0-9.,]+%?", person[-1])
    assert notes == ()


def test_a_column_that_canvas_leaves_alone_is_named(works: Works) -> None:
    _, notes = canvas_table(CANVAS["both"], works, "(read only)")
    assert ["read only" in note for note in notes] == [True]
