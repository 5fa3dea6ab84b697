"""The library on a course whose assignments were issued once for all tests."""

from support.classroom import classroom, issued
from support.library import own, table
