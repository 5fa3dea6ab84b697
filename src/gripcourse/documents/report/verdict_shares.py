"""How verdicts come out in a table of variants: the rows of the certificate."""

from collections.abc import Mapping, Sequence

from gripcourse.documents.report.columns import aligned
from gripcourse.text.amounts import percent_text
from gripcourse.text.words import Words, message
from gripcourse.variants.audit import VariantAudit
from gripcourse.variants.fair import VerdictShare


def verdict_rows(
    audit: VariantAudit, declared: Mapping[str, str], words: Words
) -> list[tuple[str, ...]]:
    """Return title, number of variants, shares of yes and no and a remark, verdict by verdict.

    Args:
        audit: what was found out.
        declared: titles by quantity.
        words: the language of the certificate.
    """
    found: dict[str, list[VerdictShare]] = {}
    for one in audit.verdicts:
        found.setdefault(one.quantity, []).append(one)
    counts = [(sum(one.variants for one in all_), sum(one.yes for one in all_))
              for all_ in found.values()]  # fmt: skip
    yes = aligned([percent_text(part / whole, words) for whole, part in counts])
    no = aligned([percent_text(1 - part / whole, words) for whole, part in counts])
    return [
        (declared.get(id_, id_), str(whole), said_yes, said_no, _remark(shares, part, words))
        for (id_, shares), (whole, part), said_yes, said_no in zip(
            found.items(), counts, yes, no, strict=True
        )
    ]


def _remark(shares: Sequence[VerdictShare], yes: int, words: Words) -> str:
    variants = sum(one.variants for one in shares)
    if 0 < yes < variants:
        return ""
    if yes and all(one.must_hold for one in shares):
        return words.say(message("always yes: the course demands it"))
    return words.say(message("always yes") if yes else message("always no"))
