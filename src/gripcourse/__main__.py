"""`python -m gripcourse`."""

from gripcourse.cli import main

if __name__ == "__main__":
    main()
