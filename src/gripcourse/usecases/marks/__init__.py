"""What persons and the gradebook add to grades: marks, regrades, waivers, whose a file is."""
