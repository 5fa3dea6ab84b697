"""Without LibreOffice the key workbooks are not proved, and that is said."""

from gripcourse.course.model import Course
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.samples import SampleSource, trials_of
from gripcourse.proofs.workbooks import prove_workbooks


def test_a_machine_without_libreoffice_leaves_it_open(course: Course) -> None:
    scheme = course.schemes["screw"]
    trials = {scheme.id: tuple(trials_of(SampleSource(course, (), 1, 1), scheme))}
    [result] = prove_workbooks(trials, None)
    assert (result.verdict, result.compared, result.problems) == (Verdict.OPEN, 0, ())
    assert "Not proved here" in str(result.note)
