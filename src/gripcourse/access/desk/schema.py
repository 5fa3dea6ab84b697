"""The tables of the desk, in the database of the gradebook. Rows are added, never changed.

The tables are made by the revisions in `machine.database.migrations`; a test compares both. Times
are UTC. Of tokens only SHA-256 is kept: who reads the database can sign in with none of them.
"""

from sqlalchemy import Boolean, Column, DateTime, Integer, MetaData, String, Table, Text

metadata = MetaData()


def _of_student(name: str, *columns: Column[object]) -> Table:
    """Declare a table whose rows are counted within a student of a course."""
    return Table(
        name,
        metadata,
        Column("course", String, primary_key=True),
        Column("student", String, primary_key=True),
        Column("number", Integer, primary_key=True, autoincrement=False),
        *columns,
        Column("at", DateTime, nullable=False),
    )


hand_ins = _of_student(
    "desk_hand_in",
    Column("digest", String(64), nullable=False),
    Column("size", Integer, nullable=False),
    Column("name", Text, nullable=False),
)
checks = _of_student(
    "desk_check",
    Column("digest", String(64), nullable=False),
    Column("told", Boolean, nullable=False),
    Column("left", Integer),
)
requests = _of_student(
    "desk_request",
    Column("item", String, nullable=False),
    Column("sentence", Text, nullable=False),
)
revocations = _of_student("desk_revocation", Column("by", String, nullable=False))

publications = Table(
    "desk_publication",
    metadata,
    Column("course", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("published", Boolean, nullable=False),
    Column("by", String, nullable=False),
    Column("why", Text, nullable=False),
    Column("at", DateTime, nullable=False),
)
# Its time is that of the attempts which it added to the gradebook.
batches = Table(
    "desk_batch",
    metadata,
    Column("course", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("files", Integer, nullable=False),
    Column("by", String, nullable=False),
    Column("why", Text, nullable=False),
    Column("at", DateTime, nullable=False),
)
sign_ins = Table(
    "desk_sign_in",
    metadata,
    Column("token", String(64), primary_key=True),
    Column("course", String, nullable=False),
    Column("name", String, nullable=False),
    Column("expires", DateTime, nullable=False),
)
# The primary key is what makes a sign-in good for one session only.
sessions = Table(
    "desk_session",
    metadata,
    Column("sign_in", String(64), primary_key=True),
    Column("token", String(64), nullable=False, unique=True),
    Column("expires", DateTime, nullable=False),
)
sign_outs = Table(
    "desk_sign_out",
    metadata,
    Column("session", String(64), primary_key=True),
    Column("at", DateTime, nullable=False),
)
