"""What authors of a course do: begin one, have it judged, and print what it consists of."""
