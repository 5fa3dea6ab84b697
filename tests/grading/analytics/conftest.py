"""Reports put together by hand."""

from support.reports import perfect, rejected, values, variant, with_finding, wrong
