"""What a person should look at before marks are published, by the codes that files hold."""

from enum import StrEnum


class FlagCode(StrEnum):
    """Why a submission is flagged; the value stands in JSON, in tables and in the policy."""

    ANSWERS_MISSING = "answers_missing"  # the workbook has no cells for them
    COPIED_FROM = "copied_from"  # others handed in what is this student's own
    GIVENS_CHANGED = "givens_changed"
    GIVENS_MISSING = "givens_missing"
    IDENTITY_CHANGED = "identity_changed"
    IDENTITY_MISSING = "identity_missing"
    INCIDENT = "incident"  # grading failed on our side
    ISSUED_TO_OTHER = "issued_to_other"
    CELLS_MOVED = "cells_moved"  # rows were sorted or inserted; answers were found by their titles
    MARK_OUTDATED = "mark_outdated"
    NOT_JUDGED = "not_judged"
    NOT_RECALCULATED = "not_recalculated"  # asked for, and LibreOffice could not open the file
    OTHER_VARIANT = "other_variant"
    REGRADE_WAITS = "regrade_waits"  # published; today's course or policy would say otherwise
    REJECTED = "rejected"
    REPORT_INCIDENT = "report_incident"  # the report of a judged submission failed on our side
    RESULTS_DIFFER = "results_differ"  # formulas store what LibreOffice does not come to
    SAME_ANSWERS = "same_answers"
    SAME_BYTES = "same_bytes"
    SAME_CREATOR = "same_creator"
    SEVERAL_FILES = "several_files"
    SIGNATURE = "signature"
    TIME_DOUBTFUL = "time_doubtful"  # clocks show it twice or never, and lateness depends on it
    UNKNOWN_STUDENT = "unknown_student"
    UNREADABLE = "unreadable"  # too many answers cannot be read: it is no mark, but a question
    WHO_HANDED_IN = "who_handed_in"  # workbook and path disagree, or nothing proves it
