"""What Alembic runs; see `database.migrate`."""
