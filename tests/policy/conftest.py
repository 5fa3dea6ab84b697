"""A copy of the reference course, with one scheme, that a test may break."""

from support.drafts import draft, one_scheme, said, sound
