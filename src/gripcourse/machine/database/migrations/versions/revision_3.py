"""Regrades: what graded each attempt, regrades with their reasons, and what was published."""

import sqlalchemy as sa
from alembic import op

revision = "3"
down_revision = "2"


def upgrade() -> None:
    """Add columns of attempts, and the tables of regrades and publications."""
    op.add_column("gradebook_attempt", sa.Column("engine", sa.String(64)))
    op.add_column("gradebook_attempt", sa.Column("regrade", sa.Integer))
    op.create_table(
        "gradebook_regrade",
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("undoes", sa.Integer, sa.ForeignKey("gradebook_regrade.number"), unique=True),
        sa.Column("person", sa.String, nullable=False),
        sa.Column("done_at", sa.DateTime, nullable=False),
        sa.Column("why", sa.String, nullable=False),
    )
    op.create_table(
        "gradebook_publication",
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("attempt", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("person", sa.String, nullable=False),
        sa.Column("done_at", sa.DateTime, nullable=False),
        sa.Column("points", sa.Double, nullable=False),
        sa.Column("max_points", sa.Double, nullable=False),
        sa.ForeignKeyConstraint(
            ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
        ),
    )
