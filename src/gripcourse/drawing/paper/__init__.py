"""The sheet that every drawing stands on: lines, letters, cells, title block, DXF and SVG."""
