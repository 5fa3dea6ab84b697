"""What a plan comes to."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Values = Mapping[str, NDArray[np.float64]]


@dataclass(frozen=True, slots=True)
class Evaluation:
    """The values of a plan in SI, by id.

    Attributes:
        values: what counts downstream: the known value where there is one, else the computed one.
        computed: what each formula gives at these values of its direct inputs.
    """

    values: Values
    computed: Values
