"""What goes out to other programs: tables and files of platforms."""
