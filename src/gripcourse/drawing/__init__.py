"""Drawings made of a solved variant, as DXF and SVG."""
