"""The keys of all files of a course, for editors (JSON Schema) and for readers (a page)."""

import json
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final

from gripcourse.course.errata import ERRATA
from gripcourse.course.keys import (
    ATLAS,
    COURSE,
    DIAGRAM,
    EXAMPLE,
    OPTION,
    PART,
    PUBLISHED_CASES,
    SCHEME,
    SHARED_DIAGRAM,
)
from gripcourse.course.view_keys import SHARED_VIEW, VIEW
from gripcourse.exports.json_schema import json_schema
from gripcourse.exports.key_page import FileKind, key_page
from gripcourse.machine.files import write_bytes
from gripcourse.policy.keys import POLICY, RUBRIC, SLIPS
from gripcourse.proofs.equilibrium.keys import EQUILIBRIUM
from gripcourse.proofs.keys import PROOFS
from gripcourse.simulation.keys import MIX
from gripcourse.variants.keys import SPACE

FILE_KINDS: Final = (
    FileKind("course", ("variants/course.toml",), "The course", COURSE),
    FileKind("part", ("variants/sections/*.toml",), "A part that schemes share", PART),
    FileKind("scheme", ("variants/schemes/*/scheme.toml",), "A scheme", SCHEME),
    FileKind("option", ("variants/options/*.toml",), "An option that schemes share", OPTION),
    FileKind(
        "example", ("variants/schemes/*/worked_example.toml",), "The example of a scheme", EXAMPLE
    ),
    FileKind("space", ("variants/spaces/*.toml",), "What variants are drawn from", SPACE),
    FileKind("diagram", ("variants/schemes/*/diagram.toml",), "A kinematic diagram", DIAGRAM),
    FileKind(
        "shared_diagram",
        ("variants/diagram/*.toml",),
        "Elements that diagrams share",
        SHARED_DIAGRAM,
    ),
    FileKind("drawing", ("variants/schemes/*/drawing.toml",), "A general view", VIEW),
    FileKind(
        "shared_drawing", ("variants/drawing/*.toml",), "Parts that views share", SHARED_VIEW
    ),
    FileKind("errata", ("variants/errata.toml",), "Errata of the sources", ERRATA),
    FileKind("published_cases", ("variants/published_cases.toml",), "Published cases",
             PUBLISHED_CASES),
    FileKind("proofs", ("variants/proofs.toml",), "Proofs that a course declares", PROOFS),
    FileKind("equilibrium", ("variants/equilibrium/*.toml",), "Free bodies in equilibrium",
             EQUILIBRIUM),
    FileKind("atlas", ("variants/atlas/*.toml",), "An atlas of published figures", ATLAS),
    FileKind("policy", ("grader/policy.toml",), "The policy", POLICY),
    FileKind("slips", ("grader/slips.toml",), "Wrong methods", SLIPS),
    FileKind("rubric", ("grader/rubric/*.toml",), "A rubric", RUBRIC),
    FileKind("virtual", ("grader/virtual.toml",), "Virtual students", MIX),
)  # fmt: skip
"""Every kind of TOML file that an author writes."""


def write_schemas(
    folder: Path, results: Mapping[str, Mapping[str, Any]] = MappingProxyType({})
) -> tuple[Path, ...]:
    """Write the schema of each kind of file, and the page of all keys; return the files.

    Args:
        folder: to write to.
        results: schemas of results by their names, `gripcourse/report/1`; they are written to
            `results/report.schema.json` below it.
    """
    files = {f"{one.name}.schema.json": json_schema(one.title, one.shape) for one in FILE_KINDS}
    of_results = {f"results/{name.split('/')[1]}.schema.json": one for name, one in results.items()}
    contents = {
        name: json.dumps(one, ensure_ascii=False, indent=1)
        for name, one in (files | of_results).items()
    }
    contents["keys.md"] = key_page(FILE_KINDS)
    for name, text in contents.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        write_bytes(folder / name, text.encode())
    return tuple(folder / name for name in contents)
