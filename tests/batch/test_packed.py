"""What every job needs is sent as bytes and unpacked once."""

from gripcourse.batch.one_file import GradingContext
from gripcourse.jobs.packed import pack, unpack


def test_a_desk_comes_back_whole(context: GradingContext) -> None:
    again = unpack(pack(context))
    assert again.register == context.register
    assert again.policy == context.policy
    assert list(again.course.schemes) == list(context.course.schemes)


def test_it_is_unpacked_once_for_many_jobs() -> None:
    packed = pack(["what", "every", "job", "needs"])
    assert unpack(packed) is unpack(bytes(bytearray(packed)))
    assert unpack(pack(["another"])) == ["another"]
