"""A learning platform on this machine: its own keys, its own reading of the standard.

It speaks HTTP and signs and verifies with bare RSA, sharing nothing with the code that it tests.
"""

import base64
import html
import json
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Final
from urllib.parse import parse_qs, parse_qsl, urlsplit

from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import padding, rsa

CLAIM: Final = "https://purl.imsglobal.org/spec/lti/claim/"
LEARNER: Final = "http://purl.imsglobal.org/vocab/lis/v2/membership#Learner"
TEACHER: Final = "http://purl.imsglobal.org/vocab/lis/v2/membership#Instructor"
ELSEWHERE_TEACHER: Final = "http://purl.imsglobal.org/vocab/lis/v2/institution/person#Instructor"
SCORE: Final = "https://purl.imsglobal.org/spec/lti-ags/scope/score"
LINE_ITEM: Final = "https://purl.imsglobal.org/spec/lti-ags/scope/lineitem"
MEMBERS: Final = "https://purl.imsglobal.org/spec/lti-nrps/scope/contextmembership.readonly"
CLIENT_ID: Final = "tool-7"
TOOL: Final = "http://testserver"


def base64url(data: bytes) -> str:
    return base64.urlsafe_b64encode(data).rstrip(b"=").decode()


def from_base64url(text: str) -> bytes:
    return base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))


def new_key() -> rsa.RSAPrivateKey:
    return rsa.generate_private_key(65537, 2048)


def public_jwk(key: rsa.RSAPrivateKey, key_id: str) -> dict[str, str]:
    numbers = key.public_key().public_numbers()
    n, e = (
        base64url(one.to_bytes((one.bit_length() + 7) // 8, "big"))
        for one in (numbers.n, numbers.e)
    )
    return {"kty": "RSA", "kid": key_id, "n": n, "e": e, "alg": "RS256", "use": "sig"}


def signed(header: Mapping[str, Any], claims: Mapping[str, Any], key: rsa.RSAPrivateKey) -> str:
    said = ".".join(base64url(json.dumps(one).encode()) for one in (header, claims))
    made = key.sign(said.encode(), padding.PKCS1v15(), hashes.SHA256())
    return f"{said}.{base64url(made)}"


def verified(token: str, keys: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return what is said in a token that one of these keys has signed."""
    head, body, signature = token.split(".")
    header = json.loads(from_base64url(head))
    (key,) = [one for one in keys["keys"] if one["kid"] == header["kid"]]
    n, e = (int.from_bytes(from_base64url(key[one]), "big") for one in ("n", "e"))
    try:
        rsa.RSAPublicNumbers(e, n).public_key().verify(
            from_base64url(signature),
            f"{head}.{body}".encode(),
            padding.PKCS1v15(),
            hashes.SHA256(),
        )
    except InvalidSignature:
        return None
    return dict(json.loads(from_base64url(body)))


@dataclass(slots=True)
class StandIn:
    """A learning platform with one course.

    Attributes:
        key: signs; published as `key_id`.
        address: of the platform, set when it runs.
        now: its clock.
        users: claims of each person, by `login_hint`.
        tool_keys: fetches the tool's public keys, as the platform would by their address.
        scores: what was put into its gradebook: column and score.
        columns: that the tool made.
        refuses: users of whom it takes no score.
        faults: what it answers to scores instead of taking them, in turn.
        asked: how often its keys were fetched.
        down: whether it answers its keys with an error.
        may_answer: set unless who asks for its keys has to wait.
    """

    key: rsa.RSAPrivateKey
    now: Callable[[], float]
    key_id: str = "k1"
    address: str = ""
    users: dict[str, dict[str, Any]] = field(default_factory=dict)
    tool_keys: Callable[[], Mapping[str, Any]] = field(default=dict)
    scores: list[tuple[str, dict[str, Any]]] = field(default_factory=list)
    columns: list[dict[str, Any]] = field(default_factory=list)
    refuses: set[str] = field(default_factory=set)
    faults: list[int] = field(default_factory=list)
    tokens: dict[str, str] = field(default_factory=dict)
    assertions: set[str] = field(default_factory=set)
    asked: int = 0
    down: bool = False
    may_answer: threading.Event = field(default_factory=threading.Event)

    def __post_init__(self) -> None:
        self.may_answer.set()

    def claims(self, hint: str, nonce: str, **changes: Any) -> dict[str, Any]:  # noqa: ANN401
        """Return what it says of somebody; a change to None leaves a claim out."""
        said = {
            "iss": self.address,
            "aud": CLIENT_ID,
            "iat": int(self.now()),
            "exp": int(self.now()) + 300,
            "nonce": nonce,
            "sub": f"user-{hint}",
            f"{CLAIM}version": "1.3.0",
            f"{CLAIM}message_type": "LtiResourceLinkRequest",
            f"{CLAIM}deployment_id": "1",
            f"{CLAIM}target_link_uri": f"{TOOL}/",
            f"{CLAIM}resource_link": {"id": "activity-5"},
            f"{CLAIM}context": {"id": "course-2", "title": "Grippers"},
            f"{CLAIM}roles": [LEARNER],
            "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint": {
                "scope": [SCORE, LINE_ITEM],
                "lineitem": f"{self.address}/lines/1?type_id=2",
                "lineitems": f"{self.address}/lines",
            },
            "https://purl.imsglobal.org/spec/lti-nrps/claim/namesroleservice": {
                "context_memberships_url": f"{self.address}/members",
                "service_versions": ["2.0"],
            },
            **self.users.get(hint, {}),
            **changes,
        }
        return {name: one for name, one in said.items() if one is not None}

    def token(self, claims: Mapping[str, Any]) -> str:
        return signed({"alg": "RS256", "kid": self.key_id, "typ": "JWT"}, claims, self.key)


def _answer_get(platform: StandIn, request: BaseHTTPRequestHandler) -> None:
    parts = urlsplit(request.path)
    asked = {name: one[0] for name, one in parse_qs(parts.query).items()}
    if parts.path == "/jwks":
        platform.asked += 1
        platform.may_answer.wait()
        if platform.down:
            _send(request, 503, b"")
        else:
            _json(request, {"keys": [public_jwk(platform.key, platform.key_id)]})
    elif parts.path == "/auth":
        _authorize(platform, request, asked)
    elif parts.path == "/lines" and _may(platform, request, LINE_ITEM):
        named = asked.get("resource_id")
        _json(request, [one for one in platform.columns if one["resourceId"] == named])
    elif parts.path == "/members" and _may(platform, request, MEMBERS):
        second = asked.get("page") == "2"
        link = {} if second else {"Link": f'<{platform.address}/members?page=2>; rel="next"'}
        people = list(platform.users.items())
        shown = people[2:] if second else people[:2]
        members = [
            {
                "user_id": f"user-{hint}",
                "status": "Active",
                "roles": one.get(f"{CLAIM}roles", [LEARNER]),
                "name": one.get("name", ""),
                "email": one.get("email", ""),
                "lis_person_sourcedid": one.get(f"{CLAIM}lis", {}).get("person_sourcedid", ""),
            }
            for hint, one in shown
        ]
        _json(request, {"id": "x", "context": {"id": "course-2"}, "members": members}, link)
    else:
        _send(request, 404, b"")


def _authorize(
    platform: StandIn, request: BaseHTTPRequestHandler, asked: Mapping[str, str]
) -> None:
    wanted = {
        "scope": "openid",
        "response_type": "id_token",
        "response_mode": "form_post",
        "prompt": "none",
        "client_id": CLIENT_ID,
        "redirect_uri": f"{TOOL}/lti/launch",
    }
    if any(asked.get(name) != one for name, one in wanted.items()):
        _send(request, 400, b"")
        return
    token = platform.token(platform.claims(asked["login_hint"], asked["nonce"]))
    fields = {"id_token": token, "state": asked["state"]}
    inputs = "".join(
        f'<input type="hidden" name="{name}" value="{html.escape(one)}">'
        for name, one in fields.items()
    )
    page = f'<form action="{asked["redirect_uri"]}" method="post">{inputs}</form>'
    _send(request, 200, page.encode(), {"Content-Type": "text/html"})


def _answer_post(platform: StandIn, request: BaseHTTPRequestHandler) -> None:
    body = request.rfile.read(int(request.headers["Content-Length"]))
    parts, kind = urlsplit(request.path), request.headers["Content-Type"]
    if parts.path == "/token":
        _give_access(platform, request, dict(parse_qsl(body.decode())))
    elif parts.path == "/lines" and _may(platform, request, LINE_ITEM):
        made = {**json.loads(body), "id": f"{platform.address}/lines/9"}
        platform.columns.append(made)
        _json(request, made)
    elif parts.path.endswith("/scores") and _may(platform, request, SCORE):
        if platform.faults:
            _send(request, platform.faults.pop(0), b"")
            return
        score = json.loads(body)
        right = kind == "application/vnd.ims.lis.v1.score+json"
        if not right or score["userId"] in platform.refuses:
            _send(request, 422, b"{}")
            return
        platform.scores.append((request.path, score))
        _send(request, 204, b"")
    else:
        _send(request, 404, b"")


def _give_access(
    platform: StandIn, request: BaseHTTPRequestHandler, asked: Mapping[str, str]
) -> None:
    said = verified(asked["client_assertion"], platform.tool_keys())
    right = (
        said is not None
        and asked["grant_type"] == "client_credentials"
        and asked["client_assertion_type"].endswith(":client-assertion-type:jwt-bearer")
        and said["iss"] == said["sub"] == CLIENT_ID
        and said["aud"] == f"{platform.address}/token"
        and said["iat"] <= platform.now() + 5 < said["exp"]
        and said["jti"] not in platform.assertions
    )
    if not right or said is None:
        _send(request, 401, b"")
        return
    platform.assertions.add(said["jti"])
    token = f"access-{len(platform.tokens)}"
    platform.tokens[token] = asked["scope"]
    _json(request, {"access_token": token, "token_type": "Bearer", "expires_in": 3600})


def _may(platform: StandIn, request: BaseHTTPRequestHandler, scope: str) -> bool:
    kind, _, token = request.headers.get("Authorization", "").partition(" ")
    return kind == "Bearer" and scope in platform.tokens.get(token, "").split()


def _json(
    request: BaseHTTPRequestHandler, plain: object, more: Mapping[str, str] | None = None
) -> None:
    headers = {"Content-Type": "application/json", **(more or {})}
    _send(request, 200, json.dumps(plain).encode(), headers)


def _send(
    request: BaseHTTPRequestHandler,
    status: int,
    body: bytes,
    headers: Mapping[str, str] | None = None,
) -> None:
    request.send_response(status)
    for name, value in {**(headers or {}), "Content-Length": str(len(body))}.items():
        request.send_header(name, value)
    request.end_headers()
    request.wfile.write(body)


@contextmanager
def running(now: Callable[[], float] = time.time) -> Iterator[StandIn]:
    """Run a platform on a free port of this machine."""
    platform = StandIn(new_key(), now)

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            _answer_get(platform, self)

        def do_POST(self) -> None:
            _answer_post(platform, self)

        def log_message(self, *_: object) -> None:
            """Say nothing."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    platform.address = f"http://127.0.0.1:{server.server_port}"
    thread = threading.Thread(target=server.serve_forever, args=(0.02,), daemon=True)
    thread.start()
    try:
        yield platform
    finally:
        server.shutdown()
        thread.join()
        server.server_close()
