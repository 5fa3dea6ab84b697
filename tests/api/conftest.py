"""The library on a course whose assignments were issued once for all tests."""

from support.library import own, table
