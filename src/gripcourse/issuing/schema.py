"""The tables of the register, in the database of the gradebook. Rows are added, never changed.

The tables are made by the revisions in `database.migrations`; a test compares both.
"""

from sqlalchemy import (
    Boolean,
    Column,
    DateTime,
    Integer,
    MetaData,
    String,
    Table,
    Text,
    UniqueConstraint,
)

metadata = MetaData()

# What somebody was issued; of several versions the last counts. Ids are counted within a course, so
# that two programs that issue at once meet in the primary key.
issued = Table(
    "register_issued",
    metadata,
    Column("course", String, primary_key=True),
    Column("id", Integer, primary_key=True, autoincrement=False),
    Column("student", String, nullable=False),
    Column("version", Integer, nullable=False),
    Column("variant", String, nullable=False),
    Column("scheme", String, nullable=False),
    Column("options", Text, nullable=False),  # JSON
    Column("given", Text, nullable=False),  # JSON
    Column("signature", String(64), nullable=False),
    Column("issued_on", String(10), nullable=False),  # ISO 8601
    Column("deadline", String(10)),  # ISO 8601
    Column("declarations", String(64)),  # fingerprint of the course; none before it was kept
    Column("issued_by", String),  # of a version after the first
    Column("why", Text),  # of a version after the first
    UniqueConstraint("course", "student", "version"),
)

# What the roster says of a person; it may be corrected, and the last row counts.
persons = Table(
    "register_person",
    metadata,
    Column("course", String, primary_key=True),
    Column("student", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("name", String, nullable=False),
    Column("study_group", String, nullable=False),
    Column("email", String, nullable=False),
    Column("language", String, nullable=False),
    Column("fixed_variant", String, nullable=False),
)

# Who left or was issued to under two ids, and who came back; of a student the last row counts.
withdrawals = Table(
    "register_withdrawal",
    metadata,
    Column("course", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("student", String, nullable=False),
    Column("same_as", String, nullable=False),  # empty for who left
    Column("undone", Boolean, nullable=False),
    Column("by", String, nullable=False),
    Column("why", Text, nullable=False),
    Column("at", DateTime, nullable=False),
)
