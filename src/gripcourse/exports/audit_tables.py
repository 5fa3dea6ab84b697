"""The numbers of an audit as tables for a spreadsheet program: one row for each thing looked at."""

from collections.abc import Iterator, Sequence

from gripcourse.exports.csv_text import number_cell, table_text, text_cell
from gripcourse.text.words import Words
from gripcourse.variants.audit import CheckedScheme, VariantAudit
from gripcourse.variants.overlaps import overlap_text
from gripcourse.variants.pairs import Pair

_BESIDE = ("sizes", "verdicts", "given", "followed")


def audit_tables(audit: VariantAudit, sections: Sequence[str], words: Words) -> dict[str, str]:
    """Return the tables of an audit by the name of their file.

    Args:
        audit: what was found out.
        sections: ids of the course's sections, in order.
        words: the language of the sentences; headings are the same in every language.
    """
    return {
        "variants.csv": _variants(audit, sections, words),
        "pairs.csv": _pairs(audit, sections),
        "quantities.csv": _quantities(audit),
        "sizes.csv": _sizes(audit),
        "ends.csv": _ends(audit, words),
        "verdicts.csv": _verdicts(audit),
        "slips.csv": _slips(audit),
        "alternatives.csv": _alternatives(audit),
    }


def _variants(audit: VariantAudit, sections: Sequence[str], words: Words) -> str:
    header = (
        *(
            "variant",
            "scheme",
            "options",
            "passed",
            "broken",
            "slips",
            "edges",
            "overlap",
            "above_a_limit",
        ),
        *("nearest", "share", *_headings(sections), *_BESIDE),
    )
    return table_text(header, (_variant(one, audit, len(sections), words)
                               for one in audit.variants))  # fmt: skip


def _variant(
    checked: CheckedScheme, audit: VariantAudit, sections: int, words: Words
) -> tuple[str, ...]:
    variant, pair = checked.variant, checked.nearest
    options = "; ".join(f"{name}={choice}" for name, choice in variant.options.items())
    found = (
        "; ".join(words.say(one) for one in checked.broken),
        "; ".join(f"{quantity}: {slip}" for quantity, slip in checked.slips),
        "; ".join(checked.edges),
        "" if checked.overlap is None else words.say(overlap_text(checked.overlap)),
    )
    nearest = (
        ("",) * (2 + sections + len(_BESIDE))
        if pair is None
        else (text_cell(audit.variants[pair.other].variant.id), *_shares(pair))
    )
    return (
        text_cell(variant.id),
        variant.scheme,
        options,
        _yes(checked.passed),
        *map(text_cell, found),
        _yes(checked.above),
        *nearest,
    )


def _pairs(audit: VariantAudit, sections: Sequence[str]) -> str:
    header = ("variant", "answers_of", "share", *_headings(sections), *_BESIDE, "equal")
    return table_text(header, (
        (
            text_cell(audit.variants[pair.own].variant.id),
            text_cell(audit.variants[pair.other].variant.id),
            *_shares(pair),
            "; ".join(pair.equal),
        )
        for pair in audit.pairs
    ))  # fmt: skip


def _headings(sections: Sequence[str]) -> Iterator[str]:
    yield from (f"share_{section}" for section in sections)


def _shares(pair: Pair) -> Iterator[str]:
    beside = (pair.sizes, pair.verdicts, pair.given, pair.followed)
    yield from map(number_cell, (pair.share, *pair.sections, *beside))


def _quantities(audit: VariantAudit) -> str:
    header = (
        *("scheme", "quantity", "unit", "variants", "points", "lowest", "median", "highest"),
        *("equal", "weak"),
    )
    return table_text(header, (
        (
            one.scheme,
            one.quantity,
            one.unit,
            str(one.variants),
            *map(number_cell, (one.points, one.lowest, one.median, one.highest, one.equal)),
            _yes(one.equal > audit.rules.weak_item),
        )
        for one in audit.spreads
    ))  # fmt: skip


def _sizes(audit: VariantAudit) -> str:
    header = (
        *("scheme", "quantity", "unit", "picked", "variants", "percent_5", "percent_50"),
        *("percent_95", "commonest", "share", "same"),
    )
    same = set(audit.same_sizes)
    return table_text(header, (
        (
            one.scheme,
            one.quantity,
            one.unit,
            _yes(one.is_picked),
            str(one.variants),
            *map(number_cell, (one.low, one.median, one.high, one.commonest, one.share)),
            _yes(one in same),
        )
        for one in audit.sizes
    ))  # fmt: skip


def _ends(audit: VariantAudit, words: Words) -> str:
    header = ("scheme", "quantity", "first", "second", "variants", "first_taken", "same", "because")
    same = set(audit.same_ends)
    return table_text(header, (
        (
            one.scheme,
            one.quantity,
            one.first,
            one.second,
            str(one.variants),
            number_cell(one.share),
            _yes(one in same),
            "" if one.because is None else one.because.of(words.language),
        )
        for one in audit.ends
    ))  # fmt: skip


def _verdicts(audit: VariantAudit) -> str:
    header = (
        "scheme",
        "quantity",
        "variants",
        "points",
        "yes",
        "no",
        "must_hold",
        "weak",
        "lopsided",
    )
    lopsided = set(audit.lopsided_verdicts)
    return table_text(header, (
        (
            one.scheme,
            one.quantity,
            str(one.variants),
            number_cell(one.points),
            str(one.yes),
            str(one.variants - one.yes),
            _yes(one.must_hold),
            _yes(one.quantity in audit.weak_verdicts),
            _yes(one in lopsided),
        )
        for one in audit.verdicts
    ))  # fmt: skip


def _slips(audit: VariantAudit) -> str:
    header = ("quantity", "slip", "kind", "near", "variants", "share", "refuses")
    return table_text(header, (
        (
            one.quantity,
            text_cell(one.slip),
            str(one.kind),
            str(one.near),
            str(one.variants),
            number_cell(one.share),
            _yes(one.kind in audit.rules.keep_apart and not one.only_counted),
        )
        for one in audit.slips
    ))  # fmt: skip


def _alternatives(audit: VariantAudit) -> str:
    header = ("scheme", "quantity", "alternative", "differs", "variants", "share")
    return table_text(header, (
        (
            one.scheme,
            one.quantity,
            text_cell(one.alternative),
            str(one.differs),
            str(one.variants),
            number_cell(one.share),
        )
        for one in audit.readings
    ))  # fmt: skip


def _yes(holds: bool) -> str:  # noqa: FBT001 (a cell of a table)
    return "yes" if holds else "no"
