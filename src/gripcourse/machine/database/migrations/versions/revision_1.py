"""The gradebook: attempts with their results, marks with their lines."""

import sqlalchemy as sa
from alembic import op

revision = "1"
down_revision = None


def upgrade() -> None:
    """Make the tables that were there before there were revisions."""
    version = op.create_table(
        "gradebook_format",
        sa.Column("version", sa.Integer, primary_key=True, autoincrement=False),
    )
    op.bulk_insert(version, [{"version": 1}])
    op.create_table(
        "gradebook_attempt",
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("variant", sa.String, nullable=False),
        sa.Column("scheme", sa.String, nullable=False),
        sa.Column("file", sa.String, nullable=False),
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("graded_at", sa.DateTime, nullable=False),
        sa.Column("course", sa.String(64), nullable=False),
        sa.Column("policy", sa.String(64), nullable=False),
        sa.Column("judged", sa.Boolean, nullable=False),
    )
    op.create_table(
        "gradebook_result",
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("attempt", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("place", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("quantity", sa.String, nullable=False),
        sa.Column("outcome", sa.String, nullable=False),
        sa.Column("points", sa.Double, nullable=False),
        sa.Column("max_points", sa.Double, nullable=False),
        sa.ForeignKeyConstraint(
            ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
        ),
    )
    op.create_table(
        "gradebook_mark",
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("quantity", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("supersedes", sa.Integer),
        sa.Column("attempt", sa.Integer, nullable=False),
        sa.Column("credit", sa.Double),
        sa.Column("marker", sa.String, nullable=False),
        sa.Column("marked_at", sa.DateTime, nullable=False),
        sa.Column("comment", sa.String, nullable=False),
        sa.ForeignKeyConstraint(
            ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
        ),
        sa.ForeignKeyConstraint(
            ("student", "quantity", "supersedes"),
            ("gradebook_mark.student", "gradebook_mark.quantity", "gradebook_mark.number"),
        ),
    )
    op.create_table(
        "gradebook_mark_line",
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("quantity", sa.String, primary_key=True),
        sa.Column("mark", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("line", sa.String, primary_key=True),
        sa.Column("credit", sa.Double, nullable=False),
        sa.ForeignKeyConstraint(
            ("student", "quantity", "mark"),
            ("gradebook_mark.student", "gradebook_mark.quantity", "gradebook_mark.number"),
        ),
    )
