"""`python -m gripcourse`, and the command `gripcourse`."""


def main() -> None:
    """Run the command line."""
    from gripcourse.machine.process_wide import calculate_in_one_thread  # noqa: PLC0415

    calculate_in_one_thread()
    # A worker runs the script that started it once more, as a module: it needs no command line.
    from gripcourse.cli.main import main as run  # noqa: PLC0415
    from gripcourse.machine.process_wide import leave_to_the_end  # noqa: PLC0415

    try:
        run()
    finally:
        leave_to_the_end()


if __name__ == "__main__":
    main()
