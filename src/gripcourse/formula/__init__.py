"""The formula language: text to tree, and the tree to numbers, print and spreadsheets."""
