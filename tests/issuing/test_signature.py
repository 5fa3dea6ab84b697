"""A signature shows any change of what was issued, and no change of the person's data."""

import hmac
import stat
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.errors import RegisterError
from gripcourse.issuing.signature import (
    key_path,
    make_key,
    read_key,
    read_keys,
    rotate_key,
    sign,
    verify,
)
from gripcourse.machine.files import write_text
from gripcourse.variants.model import Variant

KEY = bytes(range(32))
VARIANT = Variant("007", "press", {"fluid": "oil"}, {"mass": 60.0, "friction": 0.15})


def test_what_is_signed_is_one_line_of_text_in_a_fixed_form() -> None:
    signed = (
        b'{"course":"small","given":{"friction":0.15,"mass":60.0},"options":{"fluid":"oil"},'
        b'"scheme":"press","student":"\\u043f","variant":"007"}'
    )
    assert sign(KEY, "small", "п", VARIANT) == hmac.new(KEY, signed, "sha256").hexdigest()


def test_the_order_of_the_values_does_not_matter() -> None:
    other = replace(VARIANT, given={"friction": 0.15, "mass": 60})
    assert sign(KEY, "small", "popov", other) == sign(KEY, "small", "popov", VARIANT)


@pytest.mark.parametrize(
    "other",
    [
        replace(VARIANT, id="008"),
        replace(VARIANT, scheme="pres"),
        replace(VARIANT, options={"fluid": "air"}),
        replace(VARIANT, given={"mass": 60.0, "friction": 0.15000000000000002}),
        replace(VARIANT, given={"mass": 60.0}),
    ],
)
def test_a_changed_variant_does_not_fit(other: Variant) -> None:
    signature = sign(KEY, "small", "popov", VARIANT)
    assert verify(KEY, "small", "popov", VARIANT, signature)
    assert not verify(KEY, "small", "popov", other, signature)


def test_another_student_course_or_key_does_not_fit() -> None:
    signature = sign(KEY, "small", "popov", VARIANT)
    assert not verify(KEY, "small", "ivanova", VARIANT, signature)
    assert not verify(KEY, "other", "popov", VARIANT, signature)
    assert not verify(bytes(32), "small", "popov", VARIANT, signature)


def test_of_two_programs_that_make_a_key_at_once_both_use_that_of_the_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = key_path(tmp_path)

    def another_program_is_faster(unfinished: Path, text: str, *, private: bool) -> None:
        write_text(path, KEY.hex(), private=private)
        write_text(unfinished, text, private=private)

    monkeypatch.setattr("gripcourse.issuing.signature.write_text", another_program_is_faster)
    assert make_key(path, bytes(32)) == KEY
    assert [one.name for one in path.parent.iterdir()] == ["key"]


@given(st.text(max_size=80))
def test_no_text_is_an_error(signature: str) -> None:
    assert not verify(KEY, "small", "popov", VARIANT, signature)


def test_a_key_is_written_once_and_read_back(tmp_path: Path) -> None:
    path = key_path(tmp_path)
    assert make_key(path, KEY) == KEY
    assert read_key(path) == KEY
    assert path.relative_to(tmp_path) == Path("private/key")
    with pytest.raises(RegisterError, match="already"):
        make_key(path, bytes(32))
    assert read_key(path) == KEY


@pytest.mark.skipif(sys.platform == "win32", reason="the mode bits are of POSIX systems")
def test_only_the_owner_can_read_the_key(tmp_path: Path) -> None:
    make_key(tmp_path / "key", KEY)
    assert stat.S_IMODE((tmp_path / "key").stat().st_mode) == 0o600


def test_a_short_key_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="32 bytes"):
        make_key(tmp_path / "key", b"short")
    assert not (tmp_path / "key").exists()


@pytest.mark.parametrize("content", ["", "abc", "g" * 64, "é" * 64, "0" * 63])
def test_a_damaged_key_says_what_to_do(tmp_path: Path, content: str) -> None:
    (tmp_path / "key").write_text(content, encoding="utf-8")
    with pytest.raises(RegisterError, match=r"damaged.*backup"):
        read_key(tmp_path / "key")


def test_a_missing_key_says_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(RegisterError, match=r"missing.*backup"):
        read_key(tmp_path / "key")


def test_a_new_key_signs_and_the_old_one_still_verifies(tmp_path: Path) -> None:
    path = tmp_path / "private" / "key"
    make_key(path, KEY)
    assert rotate_key(path, bytes(32)) == 2
    assert read_key(path) == bytes(32)
    assert read_keys(path) == (bytes(32), KEY)
    assert path.stat().st_mode & 0o777 == 0o600
    assert path.parent.stat().st_mode & 0o777 == 0o700


def test_a_missing_key_is_not_replaced(tmp_path: Path) -> None:
    with pytest.raises(RegisterError):
        rotate_key(tmp_path / "key", bytes(32))
    assert not list(tmp_path.iterdir())
