"""The certificates by which a cluster is spoken to: named in Dask's own settings."""

import ssl
from pathlib import Path

from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, message

_SETTINGS = "distributed.comm.tls."


def demand_certificates(address: str) -> None:
    """Make sure that a scheduler can be asked by `tls://`.

    Raises:
        UsageError: Dask's settings name no certificates, or such as cannot be used.
    """
    from distributed import Security  # noqa: PLC0415 (only who has a cluster pays)

    security = Security()
    settings: dict[str, str | None] = security.get_tls_config_for_role("client")
    named = {
        "ca-file": settings["ca_file"],
        "client.cert": settings["cert"],
        "client.key": settings["key"],  # may stand in the file of the certificate
    }
    missing = [f"{_SETTINGS}{name}" for name in ("ca-file", "client.cert") if not named[name]]
    if missing:
        raise _refused(
            message(
                "{address} is spoken to with certificates, and the settings of Dask name none:"
                " {missing} not set.",
                address=address,
                missing=", ".join(missing),
            )
        )
    for name, file in named.items():
        # A text of several lines is the certificate itself.
        if file and "\n" not in file and not Path(file).is_file():
            said = message(
                "The settings of Dask name a file that is not there: {setting} is {file}.",
                setting=f"{_SETTINGS}{name}",
                file=file,
            )
            raise _refused(said)
    try:
        security.get_connection_args("client")
    except (ssl.SSLError, OSError) as fault:
        said = message(
            "The certificates that the settings of Dask name cannot be used ({files}): {reason}",
            files=", ".join(one for one in named.values() if one and "\n" not in one),
            reason=fault.strerror or str(fault),
        )
        raise _refused(said) from fault


def _refused(what: Message) -> UsageError:
    remedy = message(
        "Name the files in ~/.config/dask/tls.yaml; where the scheduler was started without"
        " certificates, write tcp:// instead of tls://."
    )
    return UsageError([Problem("", "", what, remedy, parameter="cluster")])
