"""Parts of the measurements of whole batches."""
