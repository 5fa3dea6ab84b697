"""Rules among the options of a scheme: which choices go together, and which givens are one."""

from collections.abc import Mapping
from dataclasses import dataclass

from gripcourse.text.words import Texts


@dataclass(frozen=True, slots=True)
class OptionRule:
    """What holds where certain choices are made.

    Attributes:
        when: choices by option; the rule counts where each of these options has one of its own.
        requires: choices by option; then each of these options must have one of its own.
        same: givens that are then one and the same number; it is drawn for the first of them.
        note: why, in a sentence.
        file, key: where it is declared, for messages.
    """

    when: Mapping[str, tuple[str, ...]]
    requires: Mapping[str, tuple[str, ...]]
    same: tuple[str, ...]
    note: Texts
    file: str
    key: str

    @property
    def options(self) -> tuple[str, ...]:
        """The options that it names, each once."""
        return tuple(dict.fromkeys((*self.when, *self.requires)))

    def counts(self, options: Mapping[str, str]) -> bool:
        """Tell whether the rule counts for choices; one that is not made yet decides nothing."""
        return all(options.get(option) in choices for option, choices in self.when.items())

    def broken_by(self, options: Mapping[str, str]) -> str:
        """Return the option whose choice the rule forbids beside the others; empty for none."""
        if not self.counts(options):
            return ""
        return next(
            (
                option
                for option, choices in self.requires.items()
                if option in options and options[option] not in choices
            ),
            "",
        )
