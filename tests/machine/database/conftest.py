"""A PostgreSQL server for the statements about databases."""

from support.databases import postgresql_server
