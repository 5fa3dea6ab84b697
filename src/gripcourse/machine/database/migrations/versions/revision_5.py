"""Versions of what was issued: why and by whom, and which of them an attempt was judged against."""

import sqlalchemy as sa
from alembic import op

revision = "5"
down_revision = "4"


def upgrade() -> None:
    """Add columns of what was issued, and of attempts."""
    op.add_column("register_issued", sa.Column("declarations", sa.String(64)))
    op.add_column("register_issued", sa.Column("issued_by", sa.String))
    op.add_column("register_issued", sa.Column("why", sa.Text))
    op.add_column("gradebook_attempt", sa.Column("version", sa.Integer))
    op.add_column("gradebook_attempt", sa.Column("either_version", sa.Boolean))
