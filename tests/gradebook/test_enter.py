"""What a person typed becomes a mark, or all that is wrong with it is said at once."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.errors import NextStep
from gripcourse.gradebook.enter import Draft, EntryFault, Standing, mark_of
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark
from gripcourse.grading.model import Outcome, Report
from gripcourse.policy.rubric import Level, Rubric, RubricLine
from gripcourse.text.words import LANGUAGES, Texts

MakeReport = Callable[..., Report]


def texts(text: str) -> Texts:
    return Texts(dict.fromkeys(LANGUAGES, text))


RUBRIC = Rubric(
    "drawing",
    texts("Drawing"),
    (
        RubricLine("sizes", 0.4, texts("Sizes"), ()),
        RubricLine("assembly", 0.3, texts("Assembly"), ()),
        RubricLine("standards", 0.3, texts("Standards"), ()),
    ),
)
STEPPED = replace(
    RUBRIC,
    lines=(
        *RUBRIC.lines[:2],
        replace(
            RUBRIC.lines[2],
            levels=tuple(Level(credit, texts(str(credit))) for credit in (0.0, 0.5, 1.0)),
        ),
    ),
)
ALL = {"sizes": 1.0, "assembly": 0.5, "standards": 0.0}


@dataclass(frozen=True, slots=True)
class GradingContext:
    """One student whose file was graded."""

    standing: Standing
    now: datetime

    def enter(self, draft: Draft) -> Mark:
        mark, faults = mark_of(draft, self.standing, "Петров", self.now)
        assert mark is not None, [str(one.what) for one in faults]
        return mark

    def faults(self, draft: Draft) -> tuple[EntryFault, ...]:
        mark, faults = mark_of(draft, self.standing, "Петров", self.now)
        assert mark is None
        return faults

    def fault(self, draft: Draft) -> EntryFault:
        (fault,) = self.faults(draft)
        return fault


@pytest.fixture(scope="session")
def context(
    report: MakeReport, attempts: Callable[..., Sequence[Attempt]], morning: datetime
) -> GradingContext:
    (attempt,) = attempts(report())
    standing = Standing(
        known=frozenset({"s01", "s02"}),
        attempt=replace(attempt, number=3),
        marked={},
        rubrics={"drawing": RUBRIC},
    )
    return GradingContext(standing, morning)


def draft(
    quantity: str = "drawing", lines: dict[str, float] | None = None, **rest: object
) -> Draft:
    return Draft("s01", quantity, lines or {}, **rest)  # type: ignore[arg-type]


class TestAMark:
    def test_lines_add_up_by_their_shares(self, context: GradingContext) -> None:
        mark = context.enter(draft(lines=ALL, comment="см. разрез"))
        assert mark.credit == pytest.approx(0.4 + 0.3 * 0.5)
        assert mark.lines == ALL
        assert (mark.attempt, mark.marker, mark.marked_at) == (3, "Петров", context.now)
        assert mark.comment == "см. разрез"

    def test_full_lines_are_the_whole_item_to_the_last_bit(self, context: GradingContext) -> None:
        assert context.enter(draft(lines=dict.fromkeys(ALL, 1.0))).credit == 1.0

    def test_points_count_instead_of_the_lines(self, context: GradingContext) -> None:
        mark = context.enter(draft(lines=ALL, points=4.0))
        assert mark.credit == pytest.approx(0.4)
        assert mark.lines == ALL

    def test_points_or_a_share_do_without_lines(self, context: GradingContext) -> None:
        assert context.enter(draft(points=7.5)).credit == 0.75
        assert context.enter(draft(credit=0.25)).credit == 0.25

    def test_points_that_a_document_rounded_up_are_all_points(
        self, context: GradingContext
    ) -> None:
        assert context.enter(draft(points=10.004)).credit == 1.0

    def test_what_we_could_not_judge_takes_points_and_a_comment(
        self, context: GradingContext
    ) -> None:
        mark = context.enter(draft("stroke", points=0.5, comment="верно до знака"))
        assert mark.credit == 0.5

    def test_an_automatic_result_is_overruled_only_on_purpose(
        self, context: GradingContext
    ) -> None:
        wanted = draft("bore", points=2.0, comment="другой каталог")
        assert "'bore' was judged automatically" in str(context.fault(wanted).what)
        assert context.fault(wanted).step is NextStep.OVERRULE
        assert "stroke, drawing" in str(context.fault(wanted).remedy)
        assert context.enter(replace(wanted, override=True)).credit == 1.0

    @given(st.fixed_dictionaries(dict.fromkeys(ALL, st.floats(0, 1))))
    def test_any_shares_of_the_lines_make_a_share_of_the_item(
        self, context: GradingContext, lines: dict[str, float]
    ) -> None:
        credit = context.enter(draft(lines=lines)).credit
        assert credit is not None
        assert min(lines.values()) - 1e-12 <= credit <= max(lines.values()) + 1e-12


class TestFaults:
    @pytest.mark.parametrize(
        ("wanted", "field", "what", "remedy"),
        [
            (draft(), "points", "No points are given", "sizes, assembly, standards"),
            (draft(lines={**ALL, "sizes": 1.5}), "line:sizes", "The share is 1.5", "from 0 to 1"),
            (draft(lines={**ALL, "sizes": -0.1}), "line:sizes", "is −0.1", "from 0 to 1"),
            (draft(lines={**ALL, "sizes": float("nan")}), "line:sizes", "share", "from 0 to 1"),
            (draft(lines={**ALL, "size": 1.0}), "line:size", "no line 'size'", "'sizes'?"),
            (draft(lines={"sizes": 1.0}), "line:assembly", "assembly, standards", "each line"),
            (draft(points=10.1), "points", "so many points: 10.1", "from 0 to 10."),
            (draft(points=-1.0), "points", "so many points: −1", "from 0 to 10."),
            (draft(credit=1.01), "credit", "The share is 1.01", "from 0 to 1"),
            (draft(lines=ALL, credit=0.5), "credit", "given twice", "beside lines"),
            (draft("drawings", points=1.0), "quantity", "no item 'drawings'", "stroke, drawing"),
            (draft("stroke", points=1.0), "comment", "needs a comment", "for the student"),
            (
                draft("stroke", {"sizes": 1.0}, comment="да"),
                "line:sizes",
                "not marked from a rubric",
                "Give points",
            ),
            (
                draft("bore", points=1.0, override=True, comment=" "),
                "comment",
                "needs a comment",
                "for the student",
            ),
            (
                draft(withdraw=True, comment="ошибка"),
                "withdraw",
                "There is no mark of 'drawing'",
                "counts already",
            ),
        ],
    )
    def test_each_is_named_by_its_field_with_a_remedy(
        self, context: GradingContext, wanted: Draft, field: str, what: str, remedy: str
    ) -> None:
        fault = context.fault(wanted)
        assert fault.field == field
        assert what in str(fault.what)
        assert remedy in str(fault.remedy)

    def test_an_unknown_student_is_named_with_the_nearest_one(
        self, context: GradingContext
    ) -> None:
        nobody = GradingContext(replace(context.standing, attempt=None), context.now)
        fault = nobody.fault(replace(draft(points=1.0), student="s1"))
        assert fault.field == "student"
        assert "no student 's1'" in str(fault.what)
        assert "'s01'?" in str(fault.remedy)

    def test_a_student_whose_file_was_never_graded_is_known_all_the_same(
        self, context: GradingContext
    ) -> None:
        waiting = GradingContext(replace(context.standing, attempt=None), context.now)
        fault = waiting.fault(replace(draft(points=1.0), student="s02"))
        assert "No file of s02 has been graded yet" in str(fault.what)
        assert fault.step is NextStep.GRADE

    def test_all_come_at_once(self, context: GradingContext) -> None:
        lines = {"sizes": 2.0, "size": 1.0, "assembly": 0.5}
        fields = [one.field for one in context.faults(draft(lines=lines, points=99.0, credit=3.0))]
        assert fields == ["credit", "points", "credit", "line:sizes", "line:size", "line:standards"]

    def test_a_line_with_levels_stands_on_one_of_them(self, context: GradingContext) -> None:
        stepped = GradingContext(
            replace(context.standing, rubrics={"drawing": STEPPED}), context.now
        )
        assert stepped.enter(draft(lines={**ALL, "standards": 0.5})).lines["standards"] == 0.5
        fault = stepped.fault(draft(lines={**ALL, "standards": 0.6}))
        assert fault.field == "line:standards"
        assert "no level 0.6" in str(fault.what)
        assert "0; 0.5; 1" in str(fault.remedy)


class TestWithdrawal:
    @pytest.fixture
    def marked(self, context: GradingContext, mark: Callable[..., Mark]) -> GradingContext:
        attempt = context.standing.attempt
        assert attempt is not None
        entry = GradebookEntry(mark("bore", 1.0, number=1), attempt)
        return GradingContext(replace(context.standing, marked={"bore": entry}), context.now)

    def test_it_is_a_mark_of_its_own_with_a_reason(self, marked: GradingContext) -> None:
        taken = marked.enter(draft("bore", withdraw=True, comment="не тот студент"))
        assert (taken.credit, taken.comment) == (None, "не тот студент")

    def test_it_needs_a_reason(self, marked: GradingContext) -> None:
        assert marked.fault(draft("bore", withdraw=True)).field == "comment"

    def test_it_gives_no_points(self, marked: GradingContext) -> None:
        both = draft("bore", withdraw=True, points=1.0, comment="ошибка")
        assert "either entered or withdrawn" in str(marked.fault(both).what)


def test_an_item_without_points_can_be_marked(
    context: GradingContext, report: MakeReport, attempts: Callable[..., Sequence[Attempt]]
) -> None:
    (worthless,) = attempts(report(drawing=(Outcome.MANUAL, 0.0, 0.0)))
    standing = replace(context.standing, attempt=worthless)
    assert GradingContext(standing, context.now).enter(draft(points=0.0)).credit == 0
