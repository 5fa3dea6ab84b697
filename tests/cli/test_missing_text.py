"""Who handed nothing in is told, and whose file may be a work though nobody looked at it."""

from pathlib import Path

from gripcourse.cli.grading_text import grading_text
from gripcourse.text.words import Words
from gripcourse.usecases.grading.collect import PassedOver, WhyNot
from gripcourse.usecases.grading.grade import GradingOutcome
from gripcourse.variants.model import Student

ABSENT = (
    Student("s1", "Смирнова Анна Петровна", "", "", "", ""),
    Student("s2", "Бондарь Олег", "", "", "", ""),
)


def said_of(*passed_over: PassedOver) -> str:
    outcome = GradingOutcome(
        (), {}, None, needs_person=True, passed_over=passed_over, grades_only=True, missing=ABSENT
    )
    return grading_text(outcome, Path("out"), Words("en"))


def test_an_archive_in_a_platforms_folder_may_be_the_work_of_who_handed_in_nothing() -> None:
    folder = "РГР.zip/Смирнова Анна_921_assignsubmission_file"
    said = said_of(PassedOver(f"{folder}/work.zip", WhyNot.ARCHIVE))
    assert "may be the work of: Смирнова Анна Петровна." in said
    typed = PassedOver("c.zip/бондарьолег_12_text.html", WhyNot.TEXT_DOCUMENT)
    assert "may be the work of: Бондарь Олег." in said_of(typed)
    assert "may be the work of" not in said_of(PassedOver(f"{folder}/a.pdf", WhyNot.OTHER))
    assert "may be the work of" not in said_of(PassedOver("Смирнова/work.zip", WhyNot.ARCHIVE))


def test_files_of_one_name_that_were_not_looked_at_are_told_apart() -> None:
    texts = [
        PassedOver(f"РГР.zip/{name}_1_assignsubmission_onlinetext/t.html", WhyNot.TEXT_DOCUMENT)
        for name in ("Анна", "Олег")
    ]
    said = said_of(*texts)
    assert "Анна_1_assignsubmission_onlinetext/t.html" in said
    assert "Олег_1_assignsubmission_onlinetext/t.html" in said
