"""A broken course: each fault is one problem, with its file, its key, what is wrong, what to do."""

import shutil
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.errors import Problem

if TYPE_CHECKING:
    from support.drafts import Draft

SECTIONS = "variants/sections/"
SCHEME = "variants/schemes/rack_parallelogram/scheme.toml"
EXAMPLE = "variants/schemes/rack_parallelogram/worked_example.toml"


@dataclass(frozen=True, slots=True)
class Fault:
    """An edit of one file, and the problem that it must give; see `faults.toml`."""

    file: str
    old: str
    new: str
    key: str
    what: str
    remedy: str
    place: str = ""
    group: int = 0

    def is_said_by(self, problem: Problem) -> bool:
        """Tell whether a problem names the place of this fault, what is wrong and what to do."""
        return (
            (problem.file, str(problem.key)) == (self.place or self.file, self.key)
            and self.what in str(problem.what)
            and self.remedy in str(problem.remedy)
        )


FAULTS = {
    name: Fault(**fault)
    for name, fault in tomllib.loads(
        (Path(__file__).parent / "faults.toml").read_text(encoding="utf-8")
    ).items()
}


GROUPS = sorted({fault.group for fault in FAULTS.values()})


@pytest.mark.parametrize("group", GROUPS)
def test_each_fault_is_one_problem_with_its_place_and_remedy(draft: "Draft", group: int) -> None:
    """All at once that hide nothing of each other; an unreadable file hides what is in it."""
    faults = {name: fault for name, fault in FAULTS.items() if fault.group == group}
    for fault in faults.values():
        if "shuffled" in fault.new:
            _shuffle(draft)
        draft.edit(fault.file, fault.old, fault.new)
    problems = draft.problems()
    told = {
        name: sum(fault.is_said_by(problem) for problem in problems)
        for name, fault in faults.items()
    }
    assert {name: count for name, count in told.items() if count != 1} == {}
    strange = [
        (one.file, str(one.key), str(one.what))
        for one in problems
        if sum(fault.is_said_by(one) for fault in faults.values()) != 1
    ]
    assert strange == []


def _shuffle(draft: "Draft") -> None:
    titles = "# title: made up\n# title.ru: так\n# title.uk: так\n"
    heads = f"{titles}# column.size: d\n# column.mass: m\n"
    text = f"# source: made up\n# mark: made up\n{heads}size [mm],mass [kg]\n10,30\n20,10\n"
    draft.put("variants/catalogues/shuffled.csv", text.encode())


def test_an_unknown_name_is_underlined(draft: "Draft") -> None:
    fault = FAULTS["unknown name"]
    problem = draft.edit(fault.file, fault.old, fault.new).problem()
    line, carets = problem.excerpt.splitlines()
    assert line[carets.index("^") : carets.rindex("^") + 1] == "frictoin"


def test_a_given_that_nobody_uses_is_named(draft: "Draft", said: Callable[[Problem], str]) -> None:
    text = (
        '[quantity.colour]\nsection = "grip"\nkind = "given"\nsymbol = "c_c"\nunit = ""\n'
        'bounds = [0, 1]\nsource = { work = "guide" }\ntitle = "colour"'
    )
    draft.append(f"{SECTIONS}pin.toml", text).edit(EXAMPLE, "mass = 60", "mass = 60\ncolour = 1")
    problem = draft.problem()
    assert (problem.file, problem.key) == (f"{SECTIONS}pin.toml", "quantity.colour")
    assert "No formula uses the given 'colour'." in said(problem)
    assert "Use it, or remove it" in said(problem)


def test_a_quantity_in_two_parts_is_named_at_the_later_one(draft: "Draft") -> None:
    text = (
        '[quantity.lever_width]\nsection = "elements"\nkind = "given"\nsymbol = "h_В"\n'
        'unit = "mm"\nbounds = [1, 1000]\nsource = { work = "guide" }\ntitle = "lever"'
    )
    problem = draft.append(f"{SECTIONS}pin.toml", text).problem()
    assert (problem.file, problem.key) == (f"{SECTIONS}pin.toml", "quantity.lever_width")
    assert str(problem.what) == f"'lever_width' is declared in {SECTIONS}bent_lever.toml too."
    assert "[override.lever_width]" in str(problem.remedy)


def test_a_missing_rubric_is_named_with_its_file(draft: "Draft") -> None:
    problem = draft.remove("grader/rubric/general_view.toml").problem()
    assert problem.file == f"{SECTIONS}drawings.toml"
    assert problem.key == "quantity.general_view_drawing.rubric"
    assert str(problem.what) == "There is no rubric 'general_view'."
    assert str(problem.remedy) == "Write grader/rubric/general_view.toml."


def test_a_name_of_a_part_that_is_not_there_leads_to_that_part(draft: "Draft") -> None:
    file = f"{SECTIONS}friction_grip.toml"
    problem = draft.edit(file, "/(2*friction)", "/(2*friction)*jaw_angle/jaw_angle").problem()
    assert (problem.file, problem.key) == (file, "quantity.grip_force.formula")
    assert f"a part that declares it, as {SECTIONS}prism_angle.toml" in str(problem.remedy)


def test_a_part_that_cannot_be_read_hides_what_seems_undeclared(draft: "Draft") -> None:
    file = f"{SECTIONS}friction_grip.toml"
    draft.append(file, "[override.pin_stress_allowed]\nbounds = [1, 2]")
    (problem,) = draft.put(f"{SECTIONS}pin.toml", b"[").problems()
    assert problem.file == f"{SECTIONS}pin.toml"


def test_a_circle_hides_what_seems_unused_in_it(draft: "Draft") -> None:
    fault = FAULTS["circle"]
    draft.edit(fault.file, "dynamic_factor*lifting_load/(2*friction)", "drive_force")
    assert [one.key for one in draft.problems()] == [fault.key]


def test_a_part_that_no_scheme_uses_is_named(draft: "Draft") -> None:
    (draft.root / SECTIONS / "spare.toml").write_text("", encoding="utf-8")
    problem = draft.problem()
    assert problem.file == f"{SECTIONS}spare.toml"
    assert str(problem.what) == "No scheme uses this part."


def test_a_fault_of_a_shared_part_is_not_repeated_where_a_scheme_changes_it(
    draft: "Draft",
) -> None:
    file = f"{SECTIONS}drive_force.toml"
    old = 'ru = "силовое передаточное отношение P/F для расчёта привода", '
    problem = draft.edit(file, old, "").problem()
    assert (problem.file, problem.key) == (file, "quantity.force_ratio.title.ru")


def test_a_slip_of_an_empirical_formula_may_leave_a_name_out(draft: "Draft") -> None:
    slip = (
        '[[quantity.module_required.slip]]\nid = "form_left_out"\ncredit = 0\nhint = "Y"\n'
        'formula = "14*cbrt(gear_torque*load_factor/(gear_teeth**2*face_width_factor'
        '*tooth_stress_allowed))"\n'
    )
    before = "[[quantity.module_required.as_printed]]"
    draft.edit(SCHEME, before, slip + before)
    assert draft.problems() == ()


def test_five_faults_in_five_files_are_five_problems(draft: "Draft") -> None:
    broken = [
        FAULTS[name]
        for name in (
            "unknown name",
            "missing Russian title",
            "wrong dimension",
            "unknown series",
            "missing given in the worked example",
        )
    ]
    assert len({fault.file for fault in broken}) == 5
    for fault in broken:
        draft.edit(fault.file, fault.old, fault.new)
    found = {(problem.file, problem.key) for problem in draft.problems()}
    assert found == {(fault.file, fault.key) for fault in broken}
    assert len(draft.problems()) == 5


def test_the_reference_course_has_no_problem(draft: "Draft") -> None:
    assert draft.problems() == ()


def test_a_fault_of_a_shared_part_is_told_once_for_all_schemes(draft: "Draft") -> None:
    first = draft.root / "variants/schemes/rack_parallelogram"
    second = Path(shutil.copytree(first, first.with_name("another_rack")))
    scheme = second / "scheme.toml"
    text = scheme.read_text(encoding="utf-8").replace('"rack_parallelogram"', '"another_rack"')
    scheme.write_text(text, encoding="utf-8")
    assert draft.problems() == ()
    for name in ("unknown name", "symbol used twice", "unknown unit", "wrong dimension of a slip"):
        draft.edit(FAULTS[name].file, FAULTS[name].old, FAULTS[name].new)
    assert len(draft.problems()) == 4


def test_no_place_on_the_machine_is_named(draft: "Draft") -> None:
    fault = FAULTS["unknown unit"]
    problem = draft.edit(fault.file, fault.old, fault.new).problem()
    assert not Path(problem.file).is_absolute()
