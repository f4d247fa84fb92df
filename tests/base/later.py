"""A module that nothing imports by a statement."""


def double(number: int) -> int:
    return 2 * number
