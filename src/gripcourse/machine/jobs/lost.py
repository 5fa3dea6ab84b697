"""Jobs that came to nothing on our side."""

import re
from dataclasses import dataclass

# Our own errors are whole sentences; the others mean nothing without their names.
_OWN_ERROR = re.compile(r"^gripcourse\.errors\.\w+: ")


@dataclass(frozen=True, slots=True)
class Lost:
    """A job that came to nothing on our side; `trace` says why."""

    trace: str

    @property
    def reason(self) -> str:
        """The last line of the trace: what happened, without where."""
        return _OWN_ERROR.sub("", self.trace.strip().rpartition("\n")[2])


class JobLostError(Exception):
    """A job came to nothing where nothing is worth having without it; its text is the trace."""
