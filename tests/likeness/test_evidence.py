"""Who copied is told with its odds; who did not is left alone."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.model import ComparedWork, Evidence, NumberKind
from gripcourse.likeness.typed_numbers import Typed, TypedNumbers
from gripcourse.policy.model import LikenessRule

if TYPE_CHECKING:
    from .conftest import School

RULE = LikenessRule(1e3, 3, 3)
SEEDS = (1,)


def told(found: tuple[Evidence, ...]) -> dict[str, set[str]]:
    """Whom each student's work is like."""
    alike: dict[str, set[str]] = {}
    for one in found:
        alike.setdefault(one.students[0], set()).update(one.students[1:])
    return alike


@pytest.mark.parametrize("seed", SEEDS)
def test_nobody_of_an_honest_cohort_is_told(school: "School", seed: int) -> None:
    works = school.honest(seed)
    assert len(works) == 300
    wrong = sum(not one.explained for work in works for one in work.numbers)
    assert wrong > 1000  # misread values, common errors, slips: enough to be mistaken for copies
    assert find_evidence(works, school.issued, RULE) == ()


def test_nobody_is_told_even_at_even_odds(school: "School") -> None:
    assert find_evidence(school.honest(4), school.issued, LikenessRule(1.0, 3, 3)) == ()


@pytest.mark.parametrize("seed", range(4))
def test_among_variants_with_one_given_apart_only_copied_mistakes_are_told(
    near_school: "School", seed: int
) -> None:
    """Who computed with another's mass has all the numbers of a faultless copy, and is honest."""
    assert find_evidence(near_school.honest(seed), near_school.issued, RULE) == ()
    works, sources = near_school.copying(seed, 1.0, 0.25)
    alike = told(find_evidence(works, near_school.issued, RULE))
    seen = sum(source in alike.get(student, set()) for student, source in sources.items())
    assert seen >= 0.25 * len(sources) > 4
    assert set(alike) <= set(sources) | set(sources.values())


@pytest.fixture(scope="module")
def copied(school: "School") -> Callable[[float], tuple[tuple[Evidence, ...], Mapping[str, str]]]:
    """Let a quarter copy a share of the answers: what is found, and who copied from whom."""

    @cache
    def find(share: float) -> tuple[tuple[Evidence, ...], Mapping[str, str]]:
        works, sources = school.copying(5, share, 0.25)
        return find_evidence(works, school.issued, RULE), sources

    return find


@pytest.mark.parametrize(("share", "least"), [(1.0, 0.99), (0.8, 0.99), (0.5, 0.95)])
def test_who_copied_is_told_with_the_source(
    copied: Callable[[float], tuple[tuple[Evidence, ...], Mapping[str, str]]],
    share: float,
    least: float,
) -> None:
    evidence, sources = copied(share)
    alike = told(evidence)
    found = sum(source in alike.get(student, set()) for student, source in sources.items())
    assert len(sources) > 50
    assert found >= least * len(sources)
    # Who was copied from shares wrong answers with the copy, and so do two copies of one work.
    assert set(alike) <= set(sources) | set(sources.values())


def test_copies_with_every_number_moved_a_little_are_told(school: "School") -> None:
    works, sources = school.copying(6, 1.0, 0.25, moved=0.01)
    alike = told(find_evidence(works, school.issued, RULE))
    seen = sum(source in alike.get(student, set()) for student, source in sources.items())
    assert len(sources) > 50
    # Students here err in up to two answers of five: what they pass on is half their own variant's,
    # and is told by what they typed themselves.
    assert seen >= 0.9 * len(sources)
    assert set(alike) <= set(sources) | set(sources.values())


def test_whose_work_was_copied_is_told_as_owner(
    copied: Callable[[float], tuple[tuple[Evidence, ...], Mapping[str, str]]],
) -> None:
    found, sources = copied(1.0)
    taken = {one.students for one in found if one.kind is NumberKind.OTHER_VARIANT}
    suspected = {
        (one.students[0], other)
        for one in found
        if one.kind is NumberKind.SAME_ANSWERS
        for other in one.students[1:]
    }
    owners = {one.students[0] for one in found if one.kind is NumberKind.COPIED_FROM}
    assert not {(copier, source) for source, copier in suspected} & taken
    assert owners
    assert owners <= set(sources.values())


def three(
    values: list[list[float]], *, students: tuple[str, ...] = ("a", "b", "c")
) -> IssuedValues:
    """Issued values of a few students: five quantities each."""
    table = np.array(values)
    names = tuple(f"q{column}" for column in range(table.shape[1]))
    families = np.tile(np.arange(table.shape[1]), (len(table), 1))
    kind = np.arange(len(table))
    discrete = np.zeros(table.shape[1], bool)
    return IssuedValues(students, names, [SparseTable.of_table(table)], kind, families, discrete)


ISSUED = three(
    [
        [1234.0, 56.7, 8.91, 0.2345, 67.8],
        [2345.0, 78.9, 1.23, 0.4567, 89.1],
        [3456.0, 91.2, 3.45, 0.6789, 12.3],
    ]
)


def work(
    student: str, values: list[float], *, explained: bool = False, slip: str = ""
) -> ComparedWork:
    numbers = (
        Typed(f"q{column}", value, 10.0 ** (np.floor(np.log10(value)) - 2) / 2, explained, slip)
        for column, value in enumerate(values)
    )
    return ComparedWork(student, TypedNumbers.of(numbers), "")


def odds(works: list[ComparedWork], kind: NumberKind, issued: IssuedValues = ISSUED) -> float:
    found = find_evidence(works, issued, LikenessRule(1e-12, 1, 0))
    return max((one.odds for one in found if one.kind is kind), default=0.0)


RIGHT = {name: list(ISSUED.dense(range(5))[row]) for row, name in enumerate(ISSUED.owners)}


def test_the_values_of_another_variant_are_told_though_its_owner_handed_in_nothing() -> None:
    [found] = find_evidence([work("a", RIGHT["b"])], ISSUED, RULE)
    assert found.kind is NumberKind.OTHER_VARIANT
    assert found.students == ("a", "b")
    assert found.odds > 1e6
    assert set(found.rests_on) == set(ISSUED.quantities)


def test_what_is_right_for_oneself_says_nothing() -> None:
    same = three([RIGHT["a"], RIGHT["a"], RIGHT["c"]])
    works = [work("a", RIGHT["a"], explained=True), work("b", RIGHT["a"], explained=True)]
    assert find_evidence(works, same, LikenessRule(1e-12, 1, 0)) == ()


def test_equal_wrong_answers_count_for_both() -> None:
    wrong = [777.0, 33.3, 5.55, 0.999, 44.4]
    found = find_evidence([work("a", wrong), work("b", wrong)], ISSUED, RULE)
    assert {one.students for one in found} == {("a", "b"), ("b", "a")}
    assert {one.kind for one in found} == {NumberKind.SAME_ANSWERS}


def test_wrong_answers_of_another_that_were_moved_a_little_count() -> None:
    """Nobody's variant explains them: only the other's work does."""
    wrong = [777.0, 33.3, 5.55, 0.999, 44.4]
    moved = [772.0, 33.5, 5.51, 0.991, 44.7]
    apart = [752.0, 34.5, 5.31, 0.961, 45.7]
    assert odds([work("a", wrong), work("b", moved)], NumberKind.SAME_ANSWERS) > 1e3
    assert odds([work("a", wrong), work("b", apart)], NumberKind.SAME_ANSWERS) < 1


def test_own_right_answers_beside_copied_ones_weaken_the_evidence() -> None:
    mixed = work("a", RIGHT["b"])
    own = [
        replace(one, value=value, explained=True)
        for one, value in zip(mixed.numbers, RIGHT["a"], strict=True)
    ]
    halves = [
        replace(mixed, numbers=TypedNumbers.of((*tuple(mixed.numbers)[:n], *own[n:])))
        for n in (5, 4, 3, 2)
    ]
    all_odds = [odds([one], NumberKind.OTHER_VARIANT) for one in halves]
    assert all_odds == sorted(all_odds, reverse=True)
    assert len(set(all_odds)) == len(all_odds)


def test_the_same_wrong_method_where_the_right_value_is_the_same_says_little() -> None:
    wrong = [777.0, 33.3, 5.55, 0.999, 44.4]
    works = [work("a", wrong), work("b", wrong)]
    twins = three([RIGHT["a"], RIGHT["a"], RIGHT["c"]])
    assert odds(works, NumberKind.SAME_ANSWERS, twins) < 1e-3 * odds(works, NumberKind.SAME_ANSWERS)


def test_common_slips_weigh_less_than_rare_ones() -> None:
    many = tuple(f"s{number}" for number in range(40))
    rng = np.random.default_rng(7)
    issued = three((rng.lognormal(3, 1, (40, 5))).tolist(), students=many)
    wrong = [777.0, 33.3, 5.55, 0.999, 44.4]

    def among(others: str) -> float:
        rest = [work(name, rng.lognormal(3, 1, 5).tolist(), slip=others) for name in many[2:]]
        pair = [work(name, wrong, slip="radius") for name in many[:2]]
        return odds([*pair, *rest], NumberKind.SAME_ANSWERS, issued)

    assert among("radius") < among("other")


def test_proportional_answers_count_once() -> None:
    apart = odds([work("a", RIGHT["b"])], NumberKind.OTHER_VARIANT)
    together = replace(ISSUED, families=np.zeros_like(ISSUED.families))
    once = odds([work("a", RIGHT["b"])], NumberKind.OTHER_VARIANT, together)
    assert once < 1e-4 * apart


def test_sizes_from_a_series_say_little() -> None:
    from_series = replace(ISSUED, discrete=np.ones(5, bool))
    sizes = odds([work("a", RIGHT["b"])], NumberKind.OTHER_VARIANT, from_series)
    assert sizes < 1e-3 * odds([work("a", RIGHT["b"])], NumberKind.OTHER_VARIANT)


def test_cells_filled_with_one_number_are_no_answers() -> None:
    works = [work(name, [11.1] * 5) for name in ("a", "b")]
    assert find_evidence(works, ISSUED, LikenessRule(1e-12, 1, 0)) == ()


def test_two_files_of_one_student_are_not_compared() -> None:
    wrong = [777.0, 33.3, 5.55, 0.999, 44.4]
    assert find_evidence([work("a", wrong), work("a", wrong)], ISSUED, RULE) == ()


def test_one_or_two_coincidences_are_not_evidence() -> None:
    mixed = [*RIGHT["b"][:2], 5.55, 0.999, 44.4]
    assert find_evidence([work("a", mixed)], ISSUED, LikenessRule(1e-12, 3, 0)) == ()


def test_zeros_and_numbers_beyond_reason_are_passed_over() -> None:
    numbers = TypedNumbers.of(
        Typed(f"q{n}", value, 0.0, False, None) for n, value in enumerate((0.0, np.inf))
    )
    assert find_evidence([ComparedWork("a", numbers, "")], ISSUED, LikenessRule(1e-12, 1, 0)) == ()


def test_a_policy_can_switch_the_search_off() -> None:
    assert find_evidence([work("a", RIGHT["b"])], ISSUED, LikenessRule(0.0, 3, 3)) == ()


def signed(*creators: str) -> list[ComparedWork]:
    return [
        ComparedWork(f"s{number}", TypedNumbers("", b"", b"", {}), name)
        for number, name in enumerate(creators)
    ]


def test_a_few_workbooks_with_one_author_are_told() -> None:
    found = find_evidence(signed("Petrov", " petrov", "Ivanova", "", ""), ISSUED, RULE)
    assert [one.students for one in found] == [("s0", "s1"), ("s1", "s0")]
    assert {one.kind for one in found} == {NumberKind.SAME_CREATOR}
    assert found[0].rests_on == ("Petrov",)


@pytest.mark.parametrize(
    "creators", [("User",) * 4 + ("Ivanova",), ("User", "User"), ("A", "B", "C"), ()]
)
def test_an_author_of_many_or_of_all_says_nothing(creators: tuple[str, ...]) -> None:
    assert find_evidence(signed(*creators), ISSUED, RULE) == ()


def test_an_empty_batch_has_no_evidence(school: "School") -> None:
    assert find_evidence([], school.issued, RULE) == ()
