"""What pages and programs ask for alike: counted, done by one call of the library, and kept."""

import hashlib
from dataclasses import replace
from typing import Final

from gripcourse.access.desk.model import HandIn, Publication, RegradeRequest, TooOftenError
from gripcourse.api.results import CheckResult
from gripcourse.errors import UsageError
from gripcourse.gradebook.joined import family
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.jobs.lost import Lost
from gripcourse.text.shown import shown
from gripcourse.text.words import Words, message
from gripcourse.usecases.publishing.publish import publish, published_to, withdraw
from gripcourse.usecases.serving.hand_in import Receipt, hand_in
from gripcourse.usecases.serving.taken import checks_of
from gripcourse.variants.model import Issued
from gripcourse.web.checking import CheckedBothWays, CheckJob
from gripcourse.web.rates import CHECKS, HAND_INS, REQUESTS
from gripcourse.web.refusals import (
    NO_FILE,
    NOT_FOUND,
    Code,
    WebRefusal,
    refusal_of_problem,
    unless_in_conflict,
)
from gripcourse.web.site import Site
from gripcourse.web.uploads import count, too_often

LONGEST_SENTENCE: Final = 1000
LONGEST_REASON: Final = 300
ALREADY_SO: Final = message("That is already marked so.")


def check(
    site: Site, student: str, file: NamedBytes | None, words: Words
) -> CheckResult | WebRefusal:
    """Say how a workbook is read, and by policy whether its numbers fit; it is logged.

    What compares no numbers, because no section is complete, takes none of the times.

    Raises:
        HTTPException: it was too often.
    """
    if file is None:
        return NO_FILE
    joins = site.context.joins()
    known = checks_of(site.context.desk, student, joins)
    count(site, CHECKS, student, (one.at for one in known))
    found = site.checkers.do(CheckJob(file, family({student}, joins), words.language))
    if isinstance(found, Lost):
        said = message("This file could not be read within the limits of the server.")
        return WebRefusal(Code.BEYOND_LIMITS, said)
    assert isinstance(found, CheckedBothWays)  # noqa: S101 (what the workers return)
    digest = hashlib.sha256(file.data).hexdigest()
    # Who was told something under another id, before both were joined, was told it.
    before = sum(one.told for one in known if one.student != student)
    times = max(0, site.context.policy.check.times - before)
    most = times if found.compares else None
    try:
        logged = site.context.desk.log_check(student, digest, most, site.clock(), CHECKS)
    except TooOftenError as fault:
        raise too_often(CHECKS) from fault
    if found.told is None:
        return found.reading
    if not found.compares:
        return replace(found.told, left=checks_left(site, student))
    return replace(found.told if logged.told else found.reading, left=logged.left)


def checks_left(site: Site, student: str) -> int:
    """Return how often more than the reading will be told."""
    told = sum(one.told for one in checks_of(site.context.desk, student, site.context.joins()))
    return max(0, site.context.policy.check.times - told)


def keep_file(site: Site, issued: Issued, file: NamedBytes | None) -> Receipt | WebRefusal:
    """Keep a file that a student hands in; the receipt is there when it is safe.

    Raises:
        HTTPException: it was too often.
    """
    if file is None:
        return NO_FILE
    known = site.context.desk.hand_ins(issued.student.id)
    count(site, HAND_INS, issued.student.id, (one.at for one in known))
    try:
        return hand_in(site.context, issued, file, site.clock(), HAND_INS)
    except TooOftenError as fault:
        raise too_often(HAND_INS) from fault
    except UsageError as refused:
        return refusal_of_problem(refused, Code.FILE_NOT_KEPT)


def kept_file(site: Site, student: str, number: int, of: str = "") -> HandIn | None:
    """Return a file that a student handed in; None for no such.

    Args:
        site: of the course.
        student: the id that stands for the person, or one that was joined with it.
        number: of the receipt.
        of: the id under which it was handed in; empty for the student's own.
    """
    context = site.context
    if of and of not in family({student}, context.joins()):
        return None
    found = (one for one in context.desk.hand_ins(of or student) if one.number == number)
    return next(found, None)


def ask_again(site: Site, student: str, item: str, said: str) -> RegradeRequest | WebRefusal:
    """Keep that a student asks for an item of the published results to be looked at again.

    Raises:
        HTTPException: it was too often.
    """
    published = published_to(site.context, student)
    items = () if published is None else [one.quantity for one in published.report.findings]
    if item not in items:
        return NOT_FOUND
    sentence = shown(" ".join(said.split()))
    if not sentence or len(sentence) > LONGEST_SENTENCE:
        said_back = message("Say in a sentence what should be looked at again.")
        return WebRefusal(Code.NO_SENTENCE, said_back)
    desk = site.context.desk
    count(site, REQUESTS, student, (one.at for one in desk.requests(student)))
    try:
        return desk.add_request(student, item, sentence, site.clock(), REQUESTS)
    except TooOftenError as fault:
        raise too_often(REQUESTS) from fault


def let_see(site: Site, by: str, why: str) -> Publication | WebRefusal:
    """Let students see what was graded."""
    if site.graded is None:
        return NOT_FOUND
    wanted = site.context, site.graded, by, reason(why), site.clock()
    return unless_in_conflict(lambda: publish(*wanted))


def take_back(site: Site, by: str, why: str) -> Publication | WebRefusal:
    """Let students see nothing any more."""
    wanted = site.context, by, reason(why), site.clock()
    return unless_in_conflict(lambda: withdraw(*wanted))


def reason(why: str) -> str:
    """Return a reason as it is kept: one line, not too long."""
    return shown(" ".join(why.split()))[:LONGEST_REASON]
