"""Whatever is sent, the server answers as its own description says."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import HealthCheck, given, settings

from gripcourse.web.rest.app import OPERATIONS, REST
from gripcourse.web.rest.declare import PLACES, ApiOperation
from web.rest.conftest import Api

if TYPE_CHECKING:
    from schemathesis import Case

# Its import takes a second: only the process that runs these tests pays for it.
# ruff: noqa: PLC0415

EXAMPLES = 4
FIXED = {"number": 1, "page": 1, "student": "s02", "item": "general_view_drawing"}


@dataclass(frozen=True, slots=True)
class Described:
    """The description, and a client that stays open."""

    schema: Any
    client: Any
    api: Api


@pytest.fixture(scope="module")
def described(api: Api) -> Iterator[Described]:
    import schemathesis
    from schemathesis.python.asgi import get_client

    app = api.app()
    with pytest.MonkeyPatch.context() as patch, get_client(app) as client:
        api.batches_end_at_once(patch)
        yield Described(schemathesis.openapi.from_asgi(f"{REST}/openapi.json", app), client, api)


def asked_wrongly(operation: ApiOperation) -> bool:
    """Tell whether something that is sent can be of another kind than described."""
    numbers = any(kind for _, kind in PLACES.findall(operation.path))
    return numbers or operation.takes is not None or operation.searches is not None


CASES = [
    pytest.param(one, mode, id=f"{one.method} {one.path} {mode}")
    for mode in ("positive", "negative")
    for one in OPERATIONS
    if mode == "positive" or asked_wrongly(one)
]


@pytest.mark.usefixtures("server")
@pytest.mark.parametrize(("operation", "mode"), CASES)
def test_every_answer_is_as_described(
    described: Described, operation: ApiOperation, mode: str
) -> None:
    from schemathesis import GenerationMode

    path = PLACES.sub(r"{\1}", operation.path)
    token = described.api.token(operation.role)
    headers = {"Authorization": f"Bearer {token}", "Accept-Language": "uk"}
    names = [name for name, _ in PLACES.findall(path)]
    # What is made up names nobody: what is there is asked for as well.
    fixed = {name: FIXED[name] for name in names} if mode == "positive" else {}
    cases = described.schema[path][operation.method].as_strategy(
        GenerationMode(mode), path_parameters=fixed or None, headers=headers
    )

    @settings(
        max_examples=EXAMPLES,
        derandomize=True,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    @given(cases)
    def ask(case: "Case") -> None:
        case.call_and_validate(session=described.client)

    ask()
