"""What the certificate says of sizes, and of what comes out alike for nearly everybody."""

from collections.abc import Iterator, Mapping, Sequence
from statistics import median_low

from gripcourse.documents.report.columns import aligned
from gripcourse.text.amounts import amount_text, percent_text
from gripcourse.text.words import Words, message
from gripcourse.variants.audit import VariantAudit
from gripcourse.variants.monotony import SizeSpread

_FIGURES = 3


def size_rows(
    audit: VariantAudit, declared: Mapping[str, str], words: Words
) -> list[tuple[str, ...]]:
    """Return for each picked size its title, 5, 50 and 95 %, and how often the commonest comes.

    Over all schemes: the least 5 %, the median of the medians, the greatest 95 %, and the scheme in
    which one size is commonest.
    """
    found: dict[str, list[SizeSpread]] = {}
    for one in audit.sizes:
        if one.is_picked:
            found.setdefault(one.quantity, []).append(one)
    shares = aligned([percent_text(max(one.share for one in all_), words)
                      for all_ in found.values()])  # fmt: skip
    return [
        (declared.get(id_, id_), str(sum(one.variants for one in all_)), *_extent(all_, words),
         share)
        for (id_, all_), share in zip(found.items(), shares, strict=True)
    ]  # fmt: skip


def alike_rows(
    audit: VariantAudit, titles: Mapping[str, str], declared: Mapping[str, str], words: Words
) -> list[tuple[str, str, str]]:
    """Return scheme, quantity and what comes out alike: sizes, verdicts, ends of ranges."""
    return [
        (titles[scheme], declared.get(quantity, quantity), said)
        for scheme, quantity, said in _alike(audit, declared, words)
    ]


def _extent(spreads: Sequence[SizeSpread], words: Words) -> Iterator[str]:
    values = (
        min(one.low for one in spreads),
        median_low(one.median for one in spreads),
        max(one.high for one in spreads),
    )
    for one in values:
        yield amount_text(one, spreads[0].unit, words, _FIGURES)


def _alike(
    audit: VariantAudit, declared: Mapping[str, str], words: Words
) -> Iterator[tuple[str, str, str]]:
    for one in audit.same_sizes:
        value = amount_text(one.commonest, one.unit, words, _FIGURES)
        share = percent_text(one.share, words)
        yield (
            one.scheme,
            one.quantity,
            words.say(message("{value} in {share}", value=value, share=share)),
        )
    for verdict in audit.lopsided_verdicts:
        share = percent_text(1 - verdict.yes / verdict.variants, words)
        yield verdict.scheme, verdict.quantity, words.say(message("no in {share}", share=share))
    for end in audit.same_ends:
        taken = end.first if end.share > 1 / 2 else end.second
        named = "; ".join(declared.get(id_, id_) for id_ in taken.split(", "))
        yield (
            end.scheme,
            end.quantity,
            words.say(message("that of: {quantities} — in {share}", quantities=named,
                              share=percent_text(end.same, words))),
        )  # fmt: skip
    for end in audit.told_ends:
        if end.because is not None:
            taken = end.first if end.share > 1 / 2 else end.second
            named = "; ".join(declared.get(id_, id_) for id_ in taken.split(", "))
            yield (
                end.scheme,
                end.quantity,
                words.say(message("always that of: {quantities}, because {reason}",
                                  quantities=named, reason=end.because.of(words.language))),
            )  # fmt: skip
