"""Whoever has a variant gets no second one because a later list writes something otherwise."""

import pytest

from gripcourse.issuing.made_ids import with_ids
from gripcourse.variants.model import Student


def person(name: str, group: str = "АВ-31", id_: str = "", email: str = "") -> Student:
    return Student(id_, name, group, email, "", "")


OLEH = "Дем’янчук Олег Петрович"


@pytest.mark.parametrize(
    ("known", "listed"),
    [
        (person(OLEH, id_="7"), person("Дем`янчук Олег Петрович")),
        (person("Іванюк Ірина", id_="7"), person("Iванюк Iрина")),
        (person(OLEH, "АВ-31", "7"), person(OLEH, "AB 31")),
        (person(OLEH, id_="00123"), person(OLEH, id_="123")),
        (person(OLEH, id_="0012", email="o@x"), person("Дем’янчук О.", id_="12", email="O@x")),
        (person(OLEH, id_="дем-янчук-олег-петрович"), person(OLEH, id_="4117")),
        (person(OLEH, id_="дем-янчук-олег-петрович-2"), person(OLEH, id_="4117")),
    ],
)
def test_who_is_known_keeps_the_id_and_the_group_of_the_register(
    known: Student, listed: Student
) -> None:
    (student,), _, problems = with_ids([listed], [known])
    assert not problems
    assert (student.id, student.name, student.group) == (known.id, listed.name, known.group)


def test_it_is_said_whose_id_in_the_list_does_not_count() -> None:
    _, (said,), _ = with_ids([person(OLEH, id_="123")], [person(OLEH, id_="00123")])
    assert "123 → 00123" in str(said)


@pytest.mark.parametrize(
    ("known", "listed"),
    [
        (person(OLEH, "АВ-31", "7"), person(OLEH, "АВ-32")),
        (person(OLEH, id_="7"), person("Олег Дем’янчук")),
        (person(OLEH, id_="7", email="o@x"), person(OLEH, email="o@y")),
        (person(OLEH, id_="7"), person(OLEH, id_="8")),
        (person(OLEH, id_="7"), person("Дем?янчук Олег Петрович", id_="8")),
    ],
)
def test_who_may_be_known_is_asked_about(known: Student, listed: Student) -> None:
    _, _, [(place, (what, remedy))] = with_ids([listed], [known])
    assert place == 0
    assert "(7, АВ-31), who has a variant" in str(what)
    assert "write the id 7" in str(remedy)


def test_who_is_in_another_group_is_asked_about_where_the_id_was_made_here() -> None:
    known = person(OLEH, "АВ-31", "дем-янчук-олег-петрович")
    _, _, problems = with_ids([person(OLEH, "АВ-32", "4117")], [known])
    assert [place for place, _ in problems] == [0]


@pytest.mark.parametrize(
    "answer", [[person(OLEH, "АВ-32", "7")], [person(OLEH, id_="7"), person(OLEH, "АВ-32", "8")]]
)
def test_both_answers_to_that_question_are_understood(answer: list[Student]) -> None:
    students, _, problems = with_ids(answer, [person(OLEH, "АВ-31", "7")])
    assert not problems
    assert list(students) == answer


@pytest.mark.parametrize(
    ("known", "listed"),
    [
        (person(OLEH, "АВ-31", "7", "o@x"), person(OLEH, "АВ-32", email="o@y")),
        (person(OLEH, "АВ-31", "7"), person(OLEH, "АВ-32", "8")),
        (person(OLEH, id_="7"), person("Дем’янчук Ольга Петрівна")),
        (person("Дем’янчук", id_="7"), person(OLEH)),
        (person(OLEH, id_="123"), person("Коваль Іван", id_="0123")),
    ],
)
def test_whoever_is_plainly_another_gets_an_id_of_their_own(
    known: Student, listed: Student
) -> None:
    (student,), _, problems = with_ids([listed], [known])
    assert not problems
    assert student.id not in {"", known.id}


def test_a_group_is_written_as_the_register_writes_it_but_for_who_is_known_by_id() -> None:
    known = [person(OLEH, "АВ-31", "7"), person("Коваль Іван", "АВ-31", "8")]
    listed = [
        person("Мороз Ольга", "AB 31", "9"),
        person("Коваль Іван", "ав31"),
        person(OLEH, "АВ31", "7"),
    ]
    students, _, _ = with_ids(listed, known)
    assert [one.group for one in students] == ["АВ-31", "АВ-31", "АВ31"]


def test_of_a_list_of_thousands_each_is_looked_up_not_compared_with_all() -> None:
    # Comparing each with each would be a hundred million comparisons, half an hour.
    listed = [person(f"Дем’янчук Олег{one}", f"АВ-{one // 25}") for one in range(10_000)]
    known = [person(one.name, one.group, str(at)) for at, one in enumerate(listed)]
    students, _, problems = with_ids(listed, known)
    assert not problems
    assert [one.id for one in students] == [one.id for one in known]


def test_namesakes_in_their_thousands_get_an_id_each() -> None:
    students, _, _ = with_ids([person(OLEH, f"АВ-{one}") for one in range(5_000)], [])
    assert len({one.id for one in students}) == 5_000
    first = "дем-янчук-олег-петрович"
    assert [one.id for one in students[:2]] == [first, f"{first}-2"]
