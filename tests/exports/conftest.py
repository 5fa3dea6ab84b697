"""One solved variant, and reports put together by hand."""

from support.reports import (
    blank,
    embedded_fonts,
    graded_on,
    long_name,
    pages_of,
    perfect,
    read,
    rejected,
    text_of,
    values,
    variant,
    with_finding,
    wrong,
)
