"""Why somebody is not let in, or a platform does not answer."""

from enum import StrEnum

from gripcourse.text.words import Message


class LaunchRefusal(StrEnum):
    """Why a launch opens nothing; each is a word in the log and on the page."""

    PLATFORM = "platform"  # nobody declared it
    STATE = "state"  # nothing that we gave out, or damaged
    LATE = "late"
    USED = "used"  # a second time
    BROWSER = "browser"  # began in another one, or without cookies
    KEYS = "keys"  # the platform does not tell with which keys it signs
    DENIED = "denied"  # the platform brings an error in the place of a token
    FORM = "form"  # no token at all
    ALGORITHM = "algorithm"
    KEY = "key"  # signed with one that the platform does not name
    SIGNATURE = "signature"
    ISSUER = "issuer"
    AUDIENCE = "audience"
    TIME = "time"  # out of date, or from the future
    NONCE = "nonce"  # an answer to another question
    DEPLOYMENT = "deployment"
    VERSION = "version"
    MESSAGE = "message"  # not the opening of an assignment
    CLAIMS = "claims"  # something is missing or of the wrong kind
    CONTEXT = "context"  # another course of the platform
    ROLE = "role"  # neither student nor instructor


class LaunchRefusedError(Exception):
    """A launch opens nothing.

    Attributes:
        refused: why.
        platform: its name here; empty where it is unknown.
        context: the platform's course, where this is what is refused.
    """

    def __init__(self, refused: LaunchRefusal, platform: str = "", context: str = "") -> None:
        super().__init__(f"{refused} {platform}".strip())
        self.refused = refused
        self.platform = platform
        self.context = context


class PlatformFailure(StrEnum):
    """In which way a platform did not do what it was asked to: what to do next hangs on it."""

    AWAY = "away"  # not reached, or no answer in time: perhaps it was done
    BUSY = "busy"  # asks us to come again later
    BROKEN = "broken"  # a fault of its own
    UNKNOWN = "unknown"  # what lets us in is no longer good
    REFUSED = "refused"  # as often as it is asked


class PlatformFailedError(Exception):
    """A platform did not do what it was asked to.

    Attributes:
        said: what it did instead, without anything secret.
        failure: in which way.
        status: of HTTP; 0 where there was none.
        pause: after how many seconds it wants to be asked again; None where it does not say.
    """

    def __init__(
        self,
        said: Message,
        failure: PlatformFailure = PlatformFailure.REFUSED,
        status: int = 0,
        pause: float | None = None,
    ) -> None:
        super().__init__(str(said))
        self.said = said
        self.failure = failure
        self.status = status
        self.pause = pause
