"""What the desk keeps is counted within a student, once, and by all servers alike."""

from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime, timedelta, timezone

import pytest

from gripcourse.access.desk.model import Allowance, TooOftenError
from gripcourse.access.desk.store import Desk, open_desk

NOW = datetime(2026, 10, 1, 9, 30, 0, 123456, UTC)
A, B = "a" * 64, "b" * 64


@pytest.fixture
def desk(place: str) -> Desk:
    return open_desk(place, "small")


def test_what_is_handed_in_is_numbered_within_its_student(desk: Desk) -> None:
    for student, digest in (("s02", A), ("s01", A), ("s01", B), ("s01", A)):
        desk.add_hand_in(student, digest, 7, "Звіт.xlsx", NOW)
    found = [(one.student, one.number, one.digest[0]) for one in desk.hand_ins()]
    assert found == [("s01", 1, "a"), ("s01", 2, "b"), ("s01", 3, "a"), ("s02", 1, "a")]
    assert desk.hand_ins("s02")[0].at == NOW


def test_a_moment_is_the_same_in_every_time_zone(desk: Desk) -> None:
    kyiv = timezone(timedelta(hours=3))
    desk.add_hand_in("s01", A, 7, "a.xlsx", NOW.astimezone(kyiv))
    assert desk.hand_ins("s01")[0].at == NOW


def test_clicks_at_several_servers_hand_in_once(desk: Desk) -> None:
    servers = [open_desk(desk.engine.url.render_as_string(hide_password=False), "small")] * 4
    with ThreadPoolExecutor(len(servers)) as pool:
        kept = list(pool.map(lambda one: one.add_hand_in("s01", A, 7, "a.xlsx", NOW), servers))
    assert {one.number for one in kept} == {1}
    assert len(desk.hand_ins()) == 1


def test_several_servers_together_let_no_more_through_than_is_allowed(desk: Desk) -> None:
    place, rate = desk.engine.url.render_as_string(hide_password=False), Allowance(5, 600)
    servers = [open_desk(place, "small") for _ in range(4)]

    def hand_in(number: int) -> bool:
        digest, now = f"{number:064}", NOW - timedelta(seconds=number)
        try:
            servers[number % 4].add_hand_in("s01", digest, 7, "a.xlsx", now, rate)
        except TooOftenError:
            return False
        return True

    with ThreadPoolExecutor(4) as pool:
        assert sum(pool.map(hand_in, range(12))) == rate.times
    assert len(desk.hand_ins("s01")) == rate.times
    desk.add_hand_in("s02", A, 7, "a.xlsx", NOW, rate)
    desk.add_hand_in("s01", A, 7, "a.xlsx", NOW + timedelta(seconds=600), rate)


def test_requests_are_allowed_so_often_and_later_again(desk: Desk) -> None:
    rate = Allowance(1, 600)
    desk.add_request("s01", "bore", "Look.", NOW, rate)
    # A clock that is a little behind asks in vain as well.
    for seconds in (0, 599, -599):
        with pytest.raises(TooOftenError):
            desk.add_request("s01", "bore", "Look.", NOW + timedelta(seconds=seconds), rate)
    desk.add_request("s01", "bore", "Look.", NOW + timedelta(seconds=600), rate)
    assert len(desk.requests()) == 2


def test_servers_together_tell_no_more_than_the_policy_says_and_keep_every_check(
    desk: Desk,
) -> None:
    place = desk.engine.url.render_as_string(hide_password=False)
    servers = [open_desk(place, "small") for _ in range(4)]
    with ThreadPoolExecutor(4) as pool:
        logged = list(pool.map(lambda n: servers[n % 4].log_check("s01", A, 3, NOW), range(12)))
    assert sorted(one.left for one in logged if one.told) == [0, 1, 2]
    assert [one.left for one in logged if not one.told] == [0] * 9
    found = desk.checks("s01")
    assert [one.number for one in found] == list(range(1, 13))
    assert set(found) == set(logged)
    assert desk.log_check("s02", A, 3, NOW).left == 2


def test_a_check_of_which_only_the_reading_is_told_uses_nothing_up(desk: Desk) -> None:
    logged = [desk.log_check("s01", A, None, NOW) for _ in range(3)]
    assert {(one.told, one.left) for one in logged} == {(False, None)}
    assert desk.log_check("s01", A, 1, NOW).told
    assert not desk.log_check("s01", A, 1, NOW).told


def test_checks_are_allowed_so_often_by_all_servers_together(desk: Desk) -> None:
    rate = Allowance(2, 600)
    for _ in range(rate.times):
        desk.log_check("s01", A, None, NOW, rate)
    with pytest.raises(TooOftenError):
        open_desk(desk.engine.url.render_as_string(hide_password=False), "small").log_check(
            "s01", A, 3, NOW, rate
        )
    assert [one.told for one in desk.checks("s01")] == [False, False]


def test_courses_in_one_database_know_nothing_of_each_other(desk: Desk) -> None:
    other = Desk(desk.engine, "large")
    other.revoke("s01", "Петров", NOW)
    other.add_publication(1, "Петров", "", NOW)
    assert (desk.revoked("s01"), other.revoked("s01")) == (0, 1)
    assert desk.publications() == ()
    assert other.publications()[0].published is True


def test_a_sign_in_is_good_once_and_for_its_course(desk: Desk) -> None:
    later = NOW + timedelta(hours=1)
    desk.add_sign_in("token", "Д-р Рэй", later)
    assert not Desk(desk.engine, "large").begin_session("token", "session", later, NOW)
    assert not desk.begin_session("token", "session", later, later)
    assert desk.begin_session("token", "session", later, NOW)
    assert not desk.begin_session("token", "second", later, NOW)
    assert (desk.session_name("session", NOW), desk.session_name("second", NOW)) == (
        "Д-р Рэй",
        None,
    )
    assert desk.session_name("session", later) is None
    desk.end_session("session", NOW)
    desk.end_session("session", NOW)
    assert desk.session_name("session", NOW) is None


def test_a_sentence_of_any_length_and_any_characters_is_kept(desk: Desk) -> None:
    desk.add_request("s01", "bore", "Чому « ' \\ %s :x ? " + "ы" * 5000, NOW)
    desk.add_request("s01", "bore", "a\0b\ud800c", NOW)
    long, odd = desk.requests("s01")
    assert len(long.sentence) > 5000
    assert odd.sentence == "a\ufffdb\ufffdc"
