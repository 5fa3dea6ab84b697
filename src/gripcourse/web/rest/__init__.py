"""The same for programs: JSON below `/api/v1`, described by its own declarations (OpenAPI)."""
