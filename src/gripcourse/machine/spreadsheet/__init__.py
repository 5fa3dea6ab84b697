"""A spreadsheet of unknown origin, looked at before it is unpacked and read by its parts."""
