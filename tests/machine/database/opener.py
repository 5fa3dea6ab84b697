"""A program of its own that opens a gradebook and says which revision it found then."""

import sys

from gripcourse.machine.database.migrate import revision_of
from gripcourse.machine.database.opening import open_engine

if __name__ == "__main__":
    with open_engine(sys.argv[1]).connect() as opened:
        sys.stdout.write(str(revision_of(opened)))
