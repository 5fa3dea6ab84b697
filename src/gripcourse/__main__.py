"""`python -m gripcourse`."""

from gripcourse.cli.main import main

if __name__ == "__main__":
    main()
