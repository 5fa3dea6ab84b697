"""The words of Moodle's grading worksheet in the languages that it is exported in.

Every column is known by its heading, never by its place. The words are those of Moodle's language
packs; a newer pack may word one differently: it gets its line here.
"""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType
from typing import Final


class MoodleColumn(StrEnum):
    """A column that something is read from or written to."""

    IDENTIFIER = "Identifier"
    NAME = "Full name"
    GRADE = "Grade"
    MAXIMUM = "Maximum grade"
    SCALE = "Scale"
    CHANGEABLE = "Grade can be changed"
    HANDED_IN_AT = "Last modified (submission)"
    GRADED_AT = "Last modified (grade)"
    COMMENT = "Feedback comments"


REQUIRED: Final = (MoodleColumn.IDENTIFIER, MoodleColumn.GRADE, MoodleColumn.GRADED_AT)
"""Without these Moodle refuses the whole file."""

HEADINGS: Final[Mapping[str, Mapping[MoodleColumn, str]]] = MappingProxyType({
    "en": {column: column.value for column in MoodleColumn},
    "ru": {
        MoodleColumn.IDENTIFIER: "Идентификатор",
        MoodleColumn.NAME: "Полное имя",
        MoodleColumn.GRADE: "Оценка",
        MoodleColumn.MAXIMUM: "Максимальная оценка",
        MoodleColumn.SCALE: "Шкала",
        MoodleColumn.CHANGEABLE: "Оценка может быть изменена",
        MoodleColumn.HANDED_IN_AT: "Последнее изменение (ответ)",
        MoodleColumn.GRADED_AT: "Последнее изменение (оценка)",
        MoodleColumn.COMMENT: "Отзыв в виде комментария",
    },
    "uk": {
        MoodleColumn.IDENTIFIER: "Ідентифікатор",
        MoodleColumn.NAME: "Повна назва",
        MoodleColumn.GRADE: "Оцінка",
        MoodleColumn.MAXIMUM: "Максимальна оцінка",
        MoodleColumn.SCALE: "Шкала",
        MoodleColumn.CHANGEABLE: "Оцінка може бути змінена",
        MoodleColumn.HANDED_IN_AT: "Востаннє змінювалося (здача)",
        MoodleColumn.GRADED_AT: "Востаннє змінювалося (оцінка)",
        MoodleColumn.COMMENT: "Відгук - коментарем",
    },
})  # fmt: skip

NOT_CHANGEABLE: Final = frozenset({"No", "Нет", "Ні"})

MONTHS: Final[Mapping[str, tuple[str, ...]]] = MappingProxyType({
    "ru": (
        *("января", "февраля", "марта", "апреля", "мая", "июня"),
        *("июля", "августа", "сентября", "октября", "ноября", "декабря"),
    ),
    "uk": (
        *("січня", "лютого", "березня", "квітня", "травня", "червня"),
        *("липня", "серпня", "вересня", "жовтня", "листопада", "грудня"),
    ),
    "en": (
        *("january", "february", "march", "april", "may", "june"),
        *("july", "august", "september", "october", "november", "december"),
    ),
})  # fmt: skip
"""As dates are written; a Ukrainian site writes English ones too."""
