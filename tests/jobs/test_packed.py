"""What every job needs is sent as bytes and unpacked once."""

from gripcourse.batch.one_file import Desk
from gripcourse.jobs.packed import pack, unpack


def test_a_desk_comes_back_whole(desk: Desk) -> None:
    again = unpack(pack(desk))
    assert again.register == desk.register
    assert again.policy == desk.policy
    assert list(again.course.schemes) == list(desk.course.schemes)


def test_it_is_unpacked_once_for_many_jobs() -> None:
    packed = pack(["what", "every", "job", "needs"])
    assert unpack(packed) is unpack(bytes(bytearray(packed)))
    assert unpack(pack(["another"])) == ["another"]
