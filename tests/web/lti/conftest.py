"""A course on a learning platform, as on its first day."""

from collections.abc import Iterator

import pytest
from starlette.types import ASGIApp

from gripcourse.policy.model import Policy
from support.lti_course import LtiCourse, on_its_first_day, open_lti_course


@pytest.fixture(scope="module")
def opened(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Iterator[LtiCourse]:
    with open_lti_course(tmp_path_factory.mktemp("lti"), policy) as made:
        yield made


@pytest.fixture
def school(opened: LtiCourse) -> Iterator[LtiCourse]:
    """The same course on its first day."""
    with on_its_first_day(opened) as made:
        yield made


@pytest.fixture(scope="module")
def one_server(opened: LtiCourse) -> ASGIApp:
    """A server for many visitors who are all refused."""
    return opened.app()
