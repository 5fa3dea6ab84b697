"""The desk: what students hand in by their links, what is published, who signed in."""

import sqlalchemy as sa
from alembic import op

revision = "4"
down_revision = "3"

_TIME = sa.DateTime


def upgrade() -> None:
    """Add the tables of the desk."""
    _of_student(
        "desk_hand_in",
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("size", sa.Integer, nullable=False),
        sa.Column("name", sa.Text, nullable=False),
    )
    _of_student(
        "desk_check",
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("told", sa.Boolean, nullable=False),
        sa.Column("left", sa.Integer),
    )
    _of_student(
        "desk_request",
        sa.Column("item", sa.String, nullable=False),
        sa.Column("sentence", sa.Text, nullable=False),
    )
    _of_student("desk_revocation", sa.Column("by", sa.String, nullable=False))
    op.create_table(
        "desk_publication",
        sa.Column("course", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("published", sa.Boolean, nullable=False),
        sa.Column("by", sa.String, nullable=False),
        sa.Column("why", sa.Text, nullable=False),
        sa.Column("at", _TIME, nullable=False),
    )
    op.create_table(
        "desk_sign_in",
        sa.Column("token", sa.String(64), primary_key=True),
        sa.Column("course", sa.String, nullable=False),
        sa.Column("name", sa.String, nullable=False),
        sa.Column("expires", _TIME, nullable=False),
    )
    op.create_table(
        "desk_session",
        sa.Column("sign_in", sa.String(64), primary_key=True),
        sa.Column("token", sa.String(64), nullable=False, unique=True),
        sa.Column("expires", _TIME, nullable=False),
    )
    op.create_table(
        "desk_sign_out",
        sa.Column("session", sa.String(64), primary_key=True),
        sa.Column("at", _TIME, nullable=False),
    )


def _of_student(name: str, *columns: sa.Column[object]) -> None:
    op.create_table(
        name,
        sa.Column("course", sa.String, primary_key=True),
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        *columns,
        sa.Column("at", _TIME, nullable=False),
    )
