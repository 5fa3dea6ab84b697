"""What is the same for all platforms of a maker, and what their administrators type in for us."""

from dataclasses import dataclass
from typing import Any, Final

from gripcourse.access.lti.launch import LINE_ITEM_SCOPE, MEMBERS_SCOPE, SCORE_SCOPE
from gripcourse.access.lti.platforms import Platform, origin_of
from gripcourse.access.lti.user_rule import UserRule

_CANVAS: Final = "https://canvas.instructure.com"
_CANVAS_SIGN_IN: Final = "https://sso.canvaslms.com"


@dataclass(frozen=True, slots=True)
class Endpoints:
    """Where a platform is asked, and what its tokens say of who made them."""

    issuer: str
    authorization_url: str
    token_url: str
    jwks_url: str
    frames: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Admission:
    """What we are called there, and who is let in from there."""

    client_id: str
    deployments: tuple[str, ...]
    contexts: tuple[str, ...]
    known_by: tuple[UserRule, ...]


def moodle(address: str) -> Endpoints:
    """Return where a Moodle is asked that has this address."""
    base = address.rstrip("/")
    below = f"{base}/mod/lti"
    frames = (origin_of(base),)
    return Endpoints(base, f"{below}/auth.php", f"{below}/token.php", f"{below}/certs.php", frames)


def canvas(address: str) -> Endpoints:
    """Return where Canvas is asked as its maker runs it, for a school that has this address."""
    return Endpoints(
        _CANVAS,
        f"{_CANVAS_SIGN_IN}/api/lti/authorize_redirect",
        f"{_CANVAS_SIGN_IN}/login/oauth2/token",
        f"{_CANVAS_SIGN_IN}/api/lti/security/jwks",
        (origin_of(address.rstrip("/")),),
    )


def platform_of(name: str, endpoints: Endpoints, admission: Admission) -> Platform:
    """Put a platform together."""
    return Platform(
        name=name,
        issuer=endpoints.issuer,
        client_id=admission.client_id,
        authorization_url=endpoints.authorization_url,
        token_url=endpoints.token_url,
        jwks_url=endpoints.jwks_url,
        deployments=admission.deployments,
        contexts=admission.contexts,
        known_by=admission.known_by,
        frames=endpoints.frames,
        token_audience=endpoints.token_url,
    )


@dataclass(frozen=True, slots=True)
class ToolAddresses:
    """Our addresses that an administrator types in.

    Attributes:
        opens: what is opened.
        login: where a launch begins.
        launch: where its answer is brought.
        keys: the public halves of our keys.
    """

    opens: str
    login: str
    launch: str
    keys: str


def tool_addresses(base: str) -> ToolAddresses:
    """Return our addresses on a server."""
    below = f"{base.rstrip('/')}/lti"
    return ToolAddresses(
        f"{below}/launch", f"{below}/login", f"{below}/launch", f"{below}/keys.json"
    )


def canvas_configuration(title: str, addresses: ToolAddresses) -> dict[str, Any]:
    """Return what Canvas takes as the JSON of a developer key."""
    placed = {
        "placement": "assignment_selection",
        "message_type": "LtiResourceLinkRequest",
        "target_link_uri": addresses.opens,
        "windowTarget": "_blank",
    }
    extension = {
        "platform": "canvas.instructure.com",
        # Without it there are neither names nor addresses by which a student could be known.
        "privacy_level": "public",
        "settings": {
            "platform": "canvas.instructure.com",
            "text": title,
            "windowTarget": "_blank",
            "placements": [placed, {**placed, "placement": "link_selection"}],
        },
    }
    return {
        "title": title,
        "description": title,
        "target_link_uri": addresses.opens,
        "oidc_initiation_url": addresses.login,
        "redirect_uris": [addresses.launch],
        "public_jwk_url": addresses.keys,
        "scopes": [SCORE_SCOPE, LINE_ITEM_SCOPE, MEMBERS_SCOPE],
        "extensions": [extension],
    }
