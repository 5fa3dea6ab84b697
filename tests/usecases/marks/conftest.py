"""Marks in databases of either kind."""

from support.databases import either_place
