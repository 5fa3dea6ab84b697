"""The register: what was issued to whom, in the database of the gradebook."""

import sqlalchemy as sa
from alembic import op

revision = "2"
down_revision = "1"


def upgrade() -> None:
    """Add the tables of the register, and let programs that do not know them refuse the file."""
    op.create_table(
        "register_issued",
        sa.Column("course", sa.String, primary_key=True),
        sa.Column("id", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("student", sa.String, nullable=False),
        sa.Column("version", sa.Integer, nullable=False),
        sa.Column("variant", sa.String, nullable=False),
        sa.Column("scheme", sa.String, nullable=False),
        sa.Column("options", sa.Text, nullable=False),
        sa.Column("given", sa.Text, nullable=False),
        sa.Column("signature", sa.String(64), nullable=False),
        sa.Column("issued_on", sa.String(10), nullable=False),
        sa.Column("deadline", sa.String(10)),
        sa.UniqueConstraint("course", "student", "version"),
    )
    op.create_table(
        "register_person",
        sa.Column("course", sa.String, primary_key=True),
        sa.Column("student", sa.String, primary_key=True),
        sa.Column("number", sa.Integer, primary_key=True, autoincrement=False),
        sa.Column("name", sa.String, nullable=False),
        sa.Column("study_group", sa.String, nullable=False),
        sa.Column("email", sa.String, nullable=False),
        sa.Column("language", sa.String, nullable=False),
        sa.Column("fixed_variant", sa.String, nullable=False),
    )
    op.execute(sa.text("UPDATE gradebook_format SET version = 2"))
