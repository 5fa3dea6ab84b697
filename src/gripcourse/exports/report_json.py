"""A report as one line of JSON; what a worker has put into words already is taken as it is."""

import json
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Final

from gripcourse.exports.make_report_result import finding_result, report_result
from gripcourse.exports.plain import to_plain
from gripcourse.grading.folded import Derivation, derived
from gripcourse.grading.model import Finding, Report
from gripcourse.policy.scales import Scale
from gripcourse.text.words import Words

_NO_FINDINGS: Final = '"findings": []'


def findings_json(findings: Collection[Finding], language: str) -> str:
    """Return findings as JSON, in sentences of a language."""
    words = Words(language)
    return _line([to_plain(finding_result(one, words)) for one in findings])


def said_in(language: str) -> Derivation[str]:
    """Return the derivation of `findings_json` in a language."""
    return Derivation(f"json {language}", partial(findings_json, language=language))


def report_json(report: Report, words: Words, scales: Sequence[Scale], around: str = "") -> str:
    """Return the plain form of `report_result` as JSON, without line ends.

    Args:
        report: to be put into words.
        words: their language.
        scales: of the policy.
        around: what `json_around` says of just this report; empty where nobody knows it.
    """
    said = derived(report.findings, said_in(words.language))
    # In a text of JSON no quote stands without a backslash: it is there once.
    known = around or json_around(report, words.language, scales)
    before, after = known.split(_NO_FINDINGS, 1)
    return f"{before}{_NO_FINDINGS.removesuffix('[]')}{said}{after}"


def json_around(report: Report, language: str, scales: Sequence[Scale]) -> str:
    """Return what `report_json` does as if the report had no findings."""
    return _line(report_result(replace(report, findings=()), Words(language), scales).to_dict())


def _line(plain: Mapping[str, object] | Sequence[object]) -> str:
    # Without indents it takes a third of the time.
    return json.dumps(plain, ensure_ascii=False, allow_nan=False)
