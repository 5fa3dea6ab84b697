"""Digests of results: a batch that is graded again need not read the results themselves."""

import sqlalchemy as sa
from alembic import op

revision = "8"
down_revision = "7"


def upgrade() -> None:
    """Add the column; attempts that were kept before have none, and their results are read."""
    op.add_column("gradebook_attempt", sa.Column("results_digest", sa.String(64)))
