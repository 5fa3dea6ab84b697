"""What graded each attempt and when it was handed in; regrades, publications, waivers."""

import sqlalchemy as sa
from alembic import op

revision = "3"
down_revision = "2"


def upgrade() -> None:
    """Add columns of attempts, and the tables of regrades, publications and waivers."""
    op.add_column("gradebook_attempt", sa.Column("engine", sa.String(64)))
    op.add_column("gradebook_attempt", sa.Column("regrade", sa.Integer))
    op.add_column("gradebook_attempt", sa.Column("handed_in", sa.DateTime))
    op.add_column("gradebook_attempt", sa.Column("handed_in_said", sa.Boolean))
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
    op.create_table(
        "gradebook_waiver",
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("until", sa.DateTime),
        sa.Column("withdrawn", sa.Boolean, nullable=False),
        sa.Column("person", sa.String, nullable=False),
        sa.Column("done_at", sa.DateTime, nullable=False),
        sa.Column("why", sa.String, nullable=False),
    )
