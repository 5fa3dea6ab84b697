"""The machine below: files, fonts, where courses are, what is missing."""
