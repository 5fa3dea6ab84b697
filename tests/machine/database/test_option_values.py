"""An option of a database URL that PostgreSQL never takes so is named, with what it may be."""

import pytest
from sqlalchemy.engine import make_url

from gripcourse.errors import GradebookError
from gripcourse.machine.database.opening import engine_of
from gripcourse.machine.database.option_values import refuse_values

PLACE = "postgresql://teacher@localhost/course?"


@pytest.mark.parametrize(
    ("options", "permitted"),
    [
        ("sslmode=bad", "disable, allow, prefer, require, verify-ca, verify-full"),
        ("sslmode=require&target_session_attrs=master", "any, read-write, read-only, primary"),
        ("connect_timeout=soon", "0, 1, 2"),
        ("port=65536", "65535"),
        ("port=five", "65535"),
        ("keepalives=yes", "0, 1"),
        ("ssl_min_protocol_version=1.2", "TLSv1, TLSv1.1, TLSv1.2, TLSv1.3"),
    ],
)
def test_a_value_that_there_is_not_is_told_with_those_that_there_are(
    options: str, permitted: str
) -> None:
    with pytest.raises(GradebookError) as caught:
        engine_of(PLACE + options)
    [problem] = caught.value.problems
    name = options.rpartition("&")[2].partition("=")[0]
    assert f"option {name} of this URL" in str(problem.what)
    assert permitted in str(problem.remedy)


def test_a_password_in_the_place_of_a_value_is_not_shown() -> None:
    with pytest.raises(GradebookError) as caught:
        engine_of(PLACE + "sslmode=hunter2")
    assert "hunter2" not in str(caught.value)


@pytest.mark.parametrize(
    "options",
    [
        "sslmode=verify-full&sslrootcert=/etc/ca.pem",
        "host=one,two&port=5432,5433&target_session_attrs=primary",
        "host=one&host=two&port=5432&port=5433",
        "connect_timeout=-1&keepalives_idle=30&application_name=anything",
    ],
)
def test_what_postgresql_takes_is_left_to_it(options: str) -> None:
    refuse_values(make_url(PLACE + options))
