"""What an answer was judged against, in words."""

from collections.abc import Mapping
from types import MappingProxyType

from gripcourse.grading.model import Against
from gripcourse.text.words import Message, message

# What was judged against nothing has no word.
AGAINST_WORDS: Mapping[Against, Message] = MappingProxyType(
    {
        Against.REFERENCE: message("the reference"),
        Against.OWN_INPUTS: message("your own numbers"),
        Against.PRINTED: message("as printed"),
        Against.ALTERNATIVE: message("another reading"),
    }
)
