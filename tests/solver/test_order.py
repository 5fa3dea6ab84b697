"""What is needed comes before what needs it."""

from gripcourse.solver.order import in_order_of_need


def test_what_is_needed_comes_first_and_else_what_is_declared_first() -> None:
    needed = {"force": ("pressure", "area"), "area": ("bore",), "bore": (), "pressure": ()}
    assert in_order_of_need(needed) == ["bore", "area", "pressure", "force"]


def test_what_needs_itself_in_a_circle_has_no_place() -> None:
    assert in_order_of_need({"a": ("b",), "b": ("a",), "c": ("a",), "d": ()}) == ["d"]
