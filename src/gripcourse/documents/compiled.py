"""Templates compiled once: while they are judged, and not again when a document is filled."""

import marshal
from collections.abc import Mapping
from io import StringIO
from types import CodeType
from typing import TypeAlias

from jinja2 import Environment, nodes
from jinja2.bccache import Bucket, BytecodeCache
from jinja2.compiler import CodeGenerator, Frame

CompiledTemplates: TypeAlias = Mapping[tuple[str, str], bytes]
"""Code by key and checksum of a template's text: that of another text is not found."""


class CompiledBefore(BytecodeCache):
    """What an environment has been told of; the library wants a subclass to ask for it."""

    def __init__(self) -> None:
        """Begin with nothing."""
        self._code: dict[tuple[str, str], CodeType] = {}

    def load_bytecode(self, bucket: Bucket) -> None:
        """Give the code of a template where it is known."""
        bucket.code = self._code.get((bucket.key, bucket.checksum))

    def dump_bytecode(self, bucket: Bucket) -> None:
        """Keep what the environment compiled itself to itself: it has a memory of its own."""

    def add(self, name: str, file: str, source: str, code: CodeType) -> None:
        """Remember the code of a template."""
        self._code[self.get_cache_key(name, file), self.get_source_checksum(source)] = code

    def told(self) -> CompiledTemplates:
        """Return all code, to be kept for another process of the same interpreter."""
        return {key: marshal.dumps(code) for key, code in self._code.items()}

    def tell(self, compiled: CompiledTemplates) -> None:
        """Remember what `told` returned for the same program and the same environment."""
        self._code |= {key: marshal.loads(code) for key, code in compiled.items()}  # noqa: S302


class _Asking(CodeGenerator):
    """Notes which names a template takes from outside, as `jinja2.meta` does, while compiling."""

    def __init__(self, environment: Environment, name: str, file: str, stream: StringIO) -> None:
        super().__init__(environment, name, file, stream, optimized=environment.optimized)
        self.asked: set[str] = set()

    def enter_frame(self, frame: Frame) -> None:
        """Note the names that are looked up from outside."""
        super().enter_frame(frame)
        resolved = (name for action, name in frame.symbols.loads.values() if action == "resolve")
        self.asked.update(one for one in resolved if one and one not in self.environment.globals)


def compiled_for(environment: Environment) -> CompiledTemplates:
    """Return what was compiled for an environment, to be kept for another process."""
    cache = environment.bytecode_cache
    return cache.told() if isinstance(cache, CompiledBefore) else {}


def tell_compiled(environment: Environment, compiled: CompiledTemplates) -> None:
    """Give an environment what `compiled_for` returned for it with the same program."""
    if isinstance(environment.bytecode_cache, CompiledBefore):
        environment.bytecode_cache.tell(compiled)


def compile_template(
    environment: Environment, tree: nodes.Template, source: str, name: str, file: str
) -> set[str]:
    """Compile a template for an environment; return the names that it takes from outside.

    Args:
        environment: of `documents.pdf`, which is to fill it.
        tree: the parsed template.
        source: its text.
        name: in its folder.
        file: where it is.

    Raises:
        TemplateSyntaxError: what is written makes no template, two blocks of one name for example.
    """
    written = StringIO()
    generator = _Asking(environment, name, file, written)
    generator.visit(tree)
    if isinstance(environment.bytecode_cache, CompiledBefore):
        code = compile(written.getvalue(), file, "exec")
        environment.bytecode_cache.add(name, file, source, code)
    return generator.asked
