"""Learning platforms: who is who there, who is unknown, where grades go, which were sent."""

import sqlalchemy as sa
from alembic import op

revision = "6"
down_revision = "5"


def upgrade() -> None:
    """Add the tables of learning platforms."""
    _log(
        "lti_bond",
        sa.Column("user", sa.String, nullable=False),
        sa.Column("student", sa.String, nullable=False),
        sa.Column("by", sa.String, nullable=False),
    )
    _log(
        "lti_stranger",
        sa.Column("user", sa.String, nullable=False),
        sa.Column("reason", sa.String, nullable=False),
        sa.Column("name", sa.Text, nullable=False),
        sa.Column("email", sa.Text, nullable=False),
        sa.Column("sourcedid", sa.Text, nullable=False),
    )
    _log(
        "lti_place",
        sa.Column("context", sa.String, nullable=False),
        sa.Column("link", sa.String, nullable=False),
        sa.Column("line_item", sa.Text, nullable=False),
        sa.Column("line_items", sa.Text, nullable=False),
        sa.Column("members", sa.Text, nullable=False),
    )
    _log(
        "lti_sent_score",
        sa.Column("user", sa.String, nullable=False),
        sa.Column("student", sa.String, nullable=False),
        sa.Column("line_item", sa.Text, nullable=False),
        sa.Column("points", sa.Float, nullable=False),
        sa.Column("maximum", sa.Float, nullable=False),
        sa.Column("comment", sa.Text, nullable=False),
        sa.Column("final", sa.Boolean, nullable=False),
        sa.Column("by", sa.String, nullable=False),
    )
    op.create_table(
        "lti_used_state",
        sa.Column("state", sa.String(64), primary_key=True),
        sa.Column("course", sa.String, nullable=False),
        sa.Column("at", sa.DateTime, nullable=False),
    )


def _log(name: str, *columns: sa.Column[object]) -> None:
    op.create_table(
        name,
        sa.Column("number", sa.Integer, primary_key=True),
        sa.Column("course", sa.String, nullable=False),
        sa.Column("issuer", sa.String, nullable=False),
        sa.Column("client", sa.String, nullable=False),
        *columns,
        sa.Column("at", sa.DateTime, nullable=False),
    )
