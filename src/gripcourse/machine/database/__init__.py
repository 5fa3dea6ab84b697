"""The course's database: where it is, how it is opened, and its tables from version to version."""
