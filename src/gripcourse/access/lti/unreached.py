"""Why a platform was not reached: a person has to know what to correct, and on which machine."""

import socket
import ssl
from collections.abc import Iterator, Mapping
from typing import Final
from urllib.parse import urlsplit

import httpx2

from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.text.words import Message, message

# Numbers of OpenSSL (x509_vfy.h), which the standard library passes on without names.
_UNKNOWN_AUTHORITY: Final = message("it is signed by nobody whom this machine trusts")
_FAULTS_OF_CERTIFICATES: Final[Mapping[int, Message]] = {
    9: message("it is not valid yet"),
    10: message("it has expired"),
    18: _UNKNOWN_AUTHORITY,
    19: _UNKNOWN_AUTHORITY,
    20: _UNKNOWN_AUTHORITY,
    21: _UNKNOWN_AUTHORITY,
    62: message("it is made out to another name"),
    64: message("it is made out to another name"),
}


def why_unreached(fault: Exception, address: str) -> PlatformFailedError:
    """Return what to say of a question that never arrived.

    Args:
        fault: of whatever carries questions.
        address: that was asked.
    """
    host = _host(address)
    for cause in _causes(fault):
        match cause:
            case ssl.SSLCertVerificationError():
                why = _FAULTS_OF_CERTIFICATES.get(cause.verify_code)
                said = message(
                    "The certificate of {host} is not accepted: {why}.",
                    host=host,
                    why=why or cause.verify_message,
                )
                return PlatformFailedError(said)
            case ssl.SSLError():
                said = message("{host} does not speak https at this address.", host=host)
                return PlatformFailedError(said)
            case socket.gaierror():
                said = message("No machine is known by the name {host}.", host=host)
                return PlatformFailedError(said, PlatformFailure.AWAY)
            case ConnectionRefusedError() | httpx2.ConnectTimeout():
                said = message("Nobody answers at {host}.", host=host)
                return PlatformFailedError(said, PlatformFailure.AWAY)
            case httpx2.ReadError() | httpx2.WriteError() | httpx2.RemoteProtocolError():
                said = message("{host} gave no answer that can be read.", host=host)
                return PlatformFailedError(said, PlatformFailure.AWAY)
    said = message("The platform cannot be reached: {fault}.", fault=type(fault).__name__)
    return PlatformFailedError(said, PlatformFailure.AWAY)


def _causes(fault: BaseException) -> Iterator[BaseException]:
    """Return a fault and what it came of; libraries wrap each other's."""
    waiting, seen = [fault], set[int]()
    while waiting:
        one = waiting.pop()
        if id(one) in seen:
            continue
        seen.add(id(one))
        yield one
        waiting += [cause for cause in (one.__context__, one.__cause__) if cause is not None]
        if isinstance(one, BaseExceptionGroup):
            waiting += one.exceptions


def _host(address: str) -> str:
    return urlsplit(address).netloc
