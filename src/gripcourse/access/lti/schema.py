"""The tables of learning platforms, in the gradebook's database. Rows are added, never changed.

The tables are made by the revisions in `machine.database.migrations`; a test compares both. Times
are UTC. Of what opens something only SHA-256 is kept.
"""

from sqlalchemy import Boolean, Column, DateTime, Float, Integer, MetaData, String, Table, Text

metadata = MetaData()


def _log(name: str, *columns: Column[object]) -> Table:
    """Declare a table whose rows are about a platform of a course, in the order they came."""
    return Table(
        name,
        metadata,
        Column("number", Integer, primary_key=True),
        Column("course", String, nullable=False),
        Column("issuer", String, nullable=False),
        Column("client", String, nullable=False),
        *columns,
        Column("at", DateTime, nullable=False),
    )


bonds = _log(
    "lti_bond",
    Column("user", String, nullable=False),
    Column("student", String, nullable=False),
    Column("by", String, nullable=False),
)
strangers = _log(
    "lti_stranger",
    Column("user", String, nullable=False),
    Column("reason", String, nullable=False),
    Column("name", Text, nullable=False),
    Column("email", Text, nullable=False),
    Column("sourcedid", Text, nullable=False),
)
places = _log(
    "lti_place",
    Column("context", String, nullable=False),
    Column("link", String, nullable=False),
    Column("line_item", Text, nullable=False),
    Column("line_items", Text, nullable=False),
    Column("members", Text, nullable=False),
)
sent_scores = _log(
    "lti_sent_score",
    Column("user", String, nullable=False),
    Column("student", String, nullable=False),
    Column("line_item", Text, nullable=False),
    Column("points", Float, nullable=False),
    Column("maximum", Float, nullable=False),
    Column("comment", Text, nullable=False),
    Column("final", Boolean, nullable=False),
    Column("by", String, nullable=False),
)
# The primary key is what makes a state good for one launch only.
used_states = Table(
    "lti_used_state",
    metadata,
    Column("state", String(64), primary_key=True),
    Column("course", String, nullable=False),
    Column("at", DateTime, nullable=False),
)
