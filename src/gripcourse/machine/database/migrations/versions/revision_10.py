"""What persons said of whose a file is: who was asked once need not answer again."""

import sqlalchemy as sa
from alembic import op

revision = "10"
down_revision = "9"


def upgrade() -> None:
    """Add the table; of what was said before nothing is known."""
    op.create_table(
        "gradebook_word",
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("file", sa.String, nullable=False),
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("student", sa.String, nullable=False),
        sa.Column("said_at", sa.DateTime, nullable=False),
    )
