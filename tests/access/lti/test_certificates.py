"""A platform by https: what is wrong with its certificate is said, and nothing is sent there."""

import http.server
import ssl
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from ipaddress import ip_address
from pathlib import Path

import pytest
from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import NameOID

from gripcourse.access.lti.refused import PlatformFailedError, PlatformFailure
from gripcourse.access.lti.web_client import PlatformQuestion, ask, make_client

DAY = timedelta(days=1)


@dataclass(frozen=True, slots=True)
class Signer:
    """Whoever signs certificates."""

    key: ec.EllipticCurvePrivateKey
    certificate: x509.Certificate


def named(name: str) -> x509.Name:
    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, name)])


def certificate(
    name: str, key: ec.EllipticCurvePrivateKey, signer: Signer | None, ends: timedelta
) -> x509.Certificate:
    """Make one for a host, signed by somebody or by itself."""
    now = datetime.now(UTC)
    host = x509.IPAddress(ip_address(name)) if name[0].isdigit() else x509.DNSName(name)
    made = (
        x509.CertificateBuilder()
        .subject_name(named(name))
        .issuer_name(named(name) if signer is None else signer.certificate.subject)
        .public_key(key.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now + ends - 9 * DAY)
        .not_valid_after(now + ends)
        .add_extension(x509.SubjectAlternativeName([host]), critical=False)
        .add_extension(x509.BasicConstraints(ca=signer is None, path_length=None), critical=True)
    )
    return made.sign(key if signer is None else signer.key, hashes.SHA256())


@pytest.fixture
def authority(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Signer:
    """Return an authority of a university's own that this machine is told to trust."""
    key = ec.generate_private_key(ec.SECP256R1())
    made = Signer(key, certificate("ca.example", key, None, 5 * DAY))
    path = tmp_path / "authority.pem"
    path.write_bytes(made.certificate.public_bytes(serialization.Encoding.PEM))
    monkeypatch.setenv("SSL_CERT_FILE", str(path))
    return made


@contextmanager
def platform_with(
    folder: Path, name: str, signer: Signer | None, ends: timedelta
) -> Iterator[tuple[str, list[str]]]:
    """Run a server by https; return its address and the paths it was asked for."""
    key = ec.generate_private_key(ec.SECP256R1())
    path, asked = folder / "platform.pem", list[str]()
    made = certificate(name, key, signer, ends)
    secret = key.private_bytes(
        serialization.Encoding.PEM,
        serialization.PrivateFormat.PKCS8,
        serialization.NoEncryption(),
    )
    path.write_bytes(secret + made.public_bytes(serialization.Encoding.PEM))

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            asked.append(self.path)
            self.send_response(200)
            self.send_header("Content-Length", "2")
            self.end_headers()
            self.wfile.write(b"{}")

        def log_message(self, *_: object) -> None:
            """Say nothing."""

    class Server(http.server.ThreadingHTTPServer):
        def handle_error(self, *_: object) -> None:
            """Say nothing of who did not like the certificate."""

    server = Server(("127.0.0.1", 0), Handler)
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(path)
    server.socket = context.wrap_socket(server.socket, server_side=True)
    thread = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
    thread.start()
    try:
        yield f"127.0.0.1:{server.server_port}", asked
    finally:
        server.shutdown()
        thread.join()
        server.server_close()


def test_a_certificate_of_an_authority_that_the_machine_trusts_is_good(
    tmp_path: Path, authority: Signer
) -> None:
    with (
        platform_with(tmp_path, "127.0.0.1", authority, 5 * DAY) as (host, asked),
        make_client() as client,
    ):
        assert ask(client, PlatformQuestion(f"https://{host}/jwks")).content == {}
        with pytest.raises(PlatformFailedError) as caught:
            ask(client, PlatformQuestion(f"http://{host}/jwks"))
    assert "no answer that can be read" in str(caught.value.said)
    assert asked == ["/jwks"]


@pytest.mark.parametrize(
    ("name", "by_authority", "ends", "why"),
    [
        ("lms.example", True, 5 * DAY, "it is made out to another name"),
        ("127.0.0.2", True, 5 * DAY, "it is made out to another name"),
        ("127.0.0.1", False, 5 * DAY, "it is signed by nobody whom this machine trusts"),
        ("127.0.0.1", True, -DAY, "it has expired"),
        ("127.0.0.1", True, 30 * DAY, "it is not valid yet"),
    ],
)
def test_what_is_wrong_with_a_certificate_is_said(
    tmp_path: Path, authority: Signer, name: str, ends: timedelta, why: str, *, by_authority: bool
) -> None:
    signer = authority if by_authority else None
    with (
        platform_with(tmp_path, name, signer, ends) as (host, asked),
        make_client() as client,
        pytest.raises(PlatformFailedError) as caught,
    ):
        ask(client, PlatformQuestion(f"https://{host}/jwks"))
    assert str(caught.value.said) == f"The certificate of {host} is not accepted: {why}."
    assert caught.value.failure is PlatformFailure.REFUSED
    assert asked == []


def test_who_does_not_speak_https_is_named() -> None:
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), http.server.BaseHTTPRequestHandler)
    thread = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
    thread.start()
    host = f"127.0.0.1:{server.server_port}"
    try:
        with make_client() as client, pytest.raises(PlatformFailedError) as caught:
            ask(client, PlatformQuestion(f"https://{host}/jwks"))
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
    assert str(caught.value.said) == f"{host} does not speak https at this address."


@pytest.mark.parametrize(
    ("address", "said"),
    [
        ("https://lms.invalid/jwks", "No machine is known by the name lms.invalid."),
        ("https://127.0.0.1:9/jwks", "Nobody answers at 127.0.0.1:9."),
    ],
)
def test_where_nobody_answers_is_said(
    address: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("HTTPS_PROXY", "https_proxy", "ALL_PROXY", "all_proxy"):
        monkeypatch.delenv(name, raising=False)
    with make_client() as client, pytest.raises(PlatformFailedError) as caught:
        ask(client, PlatformQuestion(address))
    assert str(caught.value.said) == said
    assert caught.value.failure is PlatformFailure.AWAY
