"""What each command does, one module per command, without a word about terminals."""
