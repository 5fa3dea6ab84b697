"""What the audit of a table found out, and what follows from it: whoever prints it only prints."""

from dataclasses import dataclass
from typing import Final

from gripcourse.policy.model import VariantRules
from gripcourse.text.words import Message
from gripcourse.variants.apart import Apartness
from gripcourse.variants.fair import DifficultySpread, Margin, Steps, VerdictShare
from gripcourse.variants.model import Variant
from gripcourse.variants.monotony import EndShare, SizeSpread
from gripcourse.variants.other_readings import ReadingCount
from gripcourse.variants.overlaps import Overlap
from gripcourse.variants.pairs import Pair
from gripcourse.variants.slip_distance import SlipCount

FEW: Final = 4  # variants of a scheme: of fewer nothing is said to be always the same


@dataclass(frozen=True, slots=True)
class CheckedScheme:
    """One variant.

    Attributes:
        variant: as the table has it.
        broken: what does not hold.
        slips: quantity and id of the slips that give nearly the right result.
        edges: the decisions whose size lies at the edge of its step.
        overlap: the worst pair of bodies that stand in each other; None for none, or where nobody
            looked.
        nearest: what its student would get with the answers that bring most; None for one that
            shares nothing with any other.
        above: whether that is more than a limit allows, whole or in a section.
    """

    variant: Variant
    broken: tuple[Message, ...]
    slips: tuple[tuple[str, str], ...]
    edges: tuple[str, ...]
    overlap: Overlap | None
    nearest: Pair | None
    above: bool

    @property
    def passed(self) -> bool:
        """Whether there is nothing to look at."""
        return not (self.broken or self.slips or self.edges or self.overlap or self.above)


@dataclass(frozen=True, slots=True)
class Beside:
    """What one student gets with another's answers on average, 0 to 1: no limit counts these.

    Attributes:
        computed: of the points of computed quantities, for comparison.
        sizes: of the points of sizes picked from a series and of what is read from a table by them.
        verdicts: of the points of verdicts.
        given: share of the given numbers that are the same.
    """

    computed: float
    sizes: float
    verdicts: float
    given: float


@dataclass(frozen=True, slots=True)
class VariantAudit:
    """Everything that was found out about a table.

    Attributes:
        rules: what was demanded.
        variants: one by one, in the order of the table.
        slips: of all kinds, the most frequent first, counted in `slips_counted` variants.
        readings: other readings of quantities, and how often they differ beyond the tolerance.
        steps: what each scheme with its options asks for.
        ratio: answers of the longest assignment over those of the shortest.
        margins: decisions, and how often a size lies at the edge of its step.
        spreads: answers to computed quantities, scheme by scheme.
        verdicts: how often each comes out as yes, scheme by scheme.
        sizes: how they are spread, scheme by scheme.
        ends: which of two values formulas take, scheme by scheme.
        overlaps: variants with bodies that stand in each other; None where nobody looked.
        apart: how far the variants are apart.
        beside: what counts for no limit.
        pairs: those that are farthest above a limit; without any, the nearest there are.
    """

    rules: VariantRules
    variants: tuple[CheckedScheme, ...]
    slips: tuple[SlipCount, ...]
    slips_counted: int
    readings: tuple[ReadingCount, ...]
    steps: tuple[Steps, ...]
    ratio: float
    margins: tuple[Margin, ...]
    spreads: tuple[DifficultySpread, ...]
    verdicts: tuple[VerdictShare, ...]
    sizes: tuple[SizeSpread, ...]
    ends: tuple[EndShare, ...]
    overlaps: int | None
    apart: Apartness
    beside: Beside
    pairs: tuple[Pair, ...]

    @property
    def weak_items(self) -> tuple[DifficultySpread, ...]:
        """Quantities that hardly differ in a scheme, the least different first."""
        weak = (one for one in self.spreads if one.equal > self.rules.weak_item)
        return tuple(sorted(weak, key=lambda one: (-one.equal, one.scheme, one.quantity)))

    @property
    def weak_verdicts(self) -> frozenset[str]:
        """Verdicts that have one answer in all variants of the table: they tell nobody apart."""
        yes: dict[str, list[VerdictShare]] = {}
        for one in self.verdicts:
            yes.setdefault(one.quantity, []).append(one)
        return frozenset(
            quantity
            for quantity, shares in yes.items()
            if sum(one.yes for one in shares) in {0, sum(one.variants for one in shares)}
        )

    @property
    def same_sizes(self) -> tuple[SizeSpread, ...]:
        """Sizes that are picked and come out the same too often, the commonest first.

        What is read from a table by such a size is not named again.
        """
        same = {
            (one.scheme, one.quantity): one
            for one in self.sizes
            if one.is_picked and one.share > self.rules.same_size and one.variants >= FEW
        }
        roots = (
            one
            for (scheme, _), one in same.items()
            if not any((scheme, name) in same for name in one.rests_on)
        )
        return tuple(sorted(roots, key=lambda one: (-one.share, one.scheme, one.quantity)))

    @property
    def same_ends(self) -> tuple[EndShare, ...]:
        """Formulas of which the same of two values is taken too often, and nothing says why.

        With them those that are declared to take always the same, and do not.
        """
        return tuple(
            one
            for one in self.ends
            if (
                one.variants >= FEW and one.same > self.rules.same_end
                if one.because is None
                else one.same < 1
            )
        )

    @property
    def told_ends(self) -> tuple[EndShare, ...]:
        """Formulas that always take the same of two values, as is declared with the reason."""
        return tuple(one for one in self.ends if one.because is not None and one.same == 1)

    @property
    def lopsided_verdicts(self) -> tuple[VerdictShare, ...]:
        """Verdicts that may come out either way and hardly do, scheme by scheme."""
        low, high = self.rules.verdict_no
        return tuple(
            one
            for one in self.verdicts
            if not one.must_hold
            and one.variants >= FEW
            and not low <= 1 - one.yes / one.variants <= high
        )

    @property
    def alike_steps(self) -> bool:
        """Whether the longest assignment asks for no more than the rules allow."""
        return self.ratio <= self.rules.steps_ratio

    @property
    def passed(self) -> bool:
        """Whether there is nothing to look at."""
        return self.alike_steps and all(one.passed for one in self.variants)
