"""Run revisions in the transaction that `database.migrate` has begun."""

from alembic import context

from gripcourse.machine.database.migrate import VERSION_TABLE

context.configure(connection=context.config.attributes["connection"], version_table=VERSION_TABLE)
context.run_migrations()
