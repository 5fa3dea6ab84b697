"""The tables of the gradebook, in words that every database knows. Rows are added, never changed.

Each row is named by what it is about (`student`, `number`), so two graders who number the same row
meet in the primary key: the later one is refused, reads again and takes the next number.

The tables are made by the revisions in `database.migrations`; a test compares both.
"""

from sqlalchemy import (
    Boolean,
    Column,
    DateTime,
    Double,
    ForeignKey,
    ForeignKeyConstraint,
    Integer,
    MetaData,
    String,
    Table,
)

metadata = MetaData()

attempts = Table(
    "gradebook_attempt",
    metadata,
    Column("student", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("variant", String, nullable=False),
    Column("scheme", String, nullable=False),
    Column("file", String, nullable=False),
    Column("digest", String(64), nullable=False),
    Column("graded_at", DateTime, nullable=False),  # UTC
    Column("course", String(64), nullable=False),  # fingerprint
    Column("policy", String(64), nullable=False),  # fingerprint
    Column("judged", Boolean, nullable=False),
    Column("engine", String(64)),  # fingerprint; none before it was kept
    Column("regrade", Integer),  # that it belongs to; none where it was graded by itself
    Column("handed_in", DateTime),  # UTC; none where unknown
    Column("handed_in_said", Boolean),  # whether a person says so
    Column("version", Integer),  # of what was issued; none before there were versions
    Column("either_version", Boolean),  # whether several versions were tried
    Column("results_digest", String(64)),  # of its results; none before it was kept
)

results = Table(
    "gradebook_result",
    metadata,
    Column("student", String, primary_key=True),
    Column("attempt", Integer, primary_key=True, autoincrement=False),
    Column("place", Integer, primary_key=True, autoincrement=False),  # in the report
    Column("quantity", String, nullable=False),
    Column("outcome", String, nullable=False),
    Column("points", Double, nullable=False),
    Column("max_points", Double, nullable=False),
    ForeignKeyConstraint(
        ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
    ),
)

marks = Table(
    "gradebook_mark",
    metadata,
    Column("student", String, primary_key=True),
    Column("quantity", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("supersedes", Integer),  # number of the mark before, none for the first
    Column("attempt", Integer, nullable=False),
    Column("credit", Double),  # none: the marks before are withdrawn
    Column("marker", String, nullable=False),
    Column("marked_at", DateTime, nullable=False),  # UTC
    Column("comment", String, nullable=False),
    ForeignKeyConstraint(
        ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
    ),
    ForeignKeyConstraint(
        ("student", "quantity", "supersedes"),
        ("gradebook_mark.student", "gradebook_mark.quantity", "gradebook_mark.number"),
    ),
)

mark_lines = Table(
    "gradebook_mark_line",
    metadata,
    Column("student", String, primary_key=True),
    Column("quantity", String, primary_key=True),
    Column("mark", Integer, primary_key=True, autoincrement=False),
    Column("line", String, primary_key=True),
    Column("credit", Double, nullable=False),
    ForeignKeyConstraint(
        ("student", "quantity", "mark"),
        ("gradebook_mark.student", "gradebook_mark.quantity", "gradebook_mark.number"),
    ),
)

# A regrade that was applied, or one that takes an earlier one back.
regrades = Table(
    "gradebook_regrade",
    metadata,
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("undoes", Integer, ForeignKey("gradebook_regrade.number"), unique=True),
    Column("person", String, nullable=False),
    Column("done_at", DateTime, nullable=False),  # UTC
    Column("why", String, nullable=False),
)

# What students were told: from then on only a regrade changes it.
publications = Table(
    "gradebook_publication",
    metadata,
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("student", String, primary_key=True),
    Column("attempt", Integer, primary_key=True, autoincrement=False),
    Column("person", String, nullable=False),
    Column("done_at", DateTime, nullable=False),  # UTC
    Column("points", Double, nullable=False),
    Column("max_points", Double, nullable=False),
    ForeignKeyConstraint(
        ("student", "attempt"), ("gradebook_attempt.student", "gradebook_attempt.number")
    ),
)

# That somebody's lateness is not counted, at all or until a moment; the last one counts.
waivers = Table(
    "gradebook_waiver",
    metadata,
    Column("student", String, primary_key=True),
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("until", DateTime),  # UTC; none: lateness costs nothing
    Column("withdrawn", Boolean, nullable=False),
    Column("person", String, nullable=False),
    Column("done_at", DateTime, nullable=False),  # UTC
    Column("why", String, nullable=False),
)

# Whose a file is, as a person said; of the same bytes at the same end of a path the last counts.
words = Table(
    "gradebook_word",
    metadata,
    Column("number", Integer, primary_key=True, autoincrement=False),
    Column("file", String, nullable=False),
    Column("digest", String(64), nullable=False),
    Column("student", String, nullable=False),
    Column("said_at", DateTime, nullable=False),  # UTC
)
