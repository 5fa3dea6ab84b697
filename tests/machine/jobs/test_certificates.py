"""Who names a cluster by `tls://` is told which certificates are missing, or cannot be used."""

from pathlib import Path

import pytest

from gripcourse.errors import UsageError
from gripcourse.machine.jobs.certificates import demand_certificates
from gripcourse.text.words import Words

dask = pytest.importorskip("dask")
pytest.importorskip("distributed")  # its defaults: whoever imports them inside of others loses them
ADDRESS = "tls://10.0.0.1:8786"


def refusal(settings: dict[str, str]) -> UsageError:
    named = {f"distributed.comm.tls.{name}": file for name, file in settings.items()}
    with dask.config.set(named), pytest.raises(UsageError) as refused:
        demand_certificates(ADDRESS)
    return refused.value


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "write tcp:// instead of tls://"),
        ("ru", "напишите tcp:// вместо tls://"),
        ("uk", "напишіть tcp:// замість tls://"),
    ],
)
def test_settings_without_certificates_are_named_and_what_else_may_be_meant(
    language: str, said: str
) -> None:
    (problem,) = refusal({}).problems
    sentence = problem.say(Words(language))
    assert "distributed.comm.tls.ca-file, distributed.comm.tls.client.cert" in sentence
    assert ADDRESS in sentence
    assert said in sentence
    assert problem.parameter == "cluster"


def test_of_what_is_missing_only_that_is_named() -> None:
    said = str(refusal({"ca-file": "/etc/dask/ca.pem"}))
    assert "none: distributed.comm.tls.client.cert not set" in said


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    authority = tmp_path / "ca.pem"
    authority.write_text("", encoding="utf-8")
    said = str(refusal({"ca-file": str(authority), "client.cert": str(tmp_path / "own.pem")}))
    assert f"distributed.comm.tls.client.cert is {tmp_path / 'own.pem'}" in said


def test_a_file_that_is_no_certificate_is_named(tmp_path: Path) -> None:
    file = tmp_path / "own.pem"
    file.write_text("no certificate\n", encoding="utf-8")
    assert str(file) in str(refusal({"ca-file": str(file), "client.cert": str(file)}))
