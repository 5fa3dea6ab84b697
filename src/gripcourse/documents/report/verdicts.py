"""How an outcome is shown: a sign that prints in grey, a word, and what it was judged against."""

from collections.abc import Mapping
from types import MappingProxyType

from gripcourse.grading.model import Against, Outcome
from gripcourse.text.words import Message, message

SIGNS: Mapping[Outcome, str] = MappingProxyType(
    {
        Outcome.CORRECT: "✓",
        Outcome.CARRIED: "↪",
        Outcome.SLIP: "≈",
        Outcome.WRONG: "✗",
        Outcome.BLANK: "–",
        Outcome.UNREADABLE: "?",
        Outcome.NOT_JUDGED: "…",
        Outcome.MANUAL: "✎",
    }
)

OUTCOME_WORDS: Mapping[Outcome, Message] = MappingProxyType(
    {
        Outcome.CORRECT: message("correct"),
        Outcome.CARRIED: message("carried forward"),
        Outcome.SLIP: message("known slip"),
        Outcome.WRONG: message("wrong"),
        Outcome.BLANK: message("blank"),
        Outcome.UNREADABLE: message("unreadable"),
        Outcome.NOT_JUDGED: message("not judged"),
        Outcome.MANUAL: message("by a person"),
    }
)

# What was judged against nothing has no word.
AGAINST_WORDS: Mapping[Against, Message] = MappingProxyType(
    {
        Against.REFERENCE: message("the reference"),
        Against.OWN_INPUTS: message("your own numbers"),
        Against.PRINTED: message("as printed"),
    }
)
