"""A template shows what it gets and cannot do anything else."""

from pathlib import Path

import pytest

from gripcourse.documents.pdf import Document, render_html
from gripcourse.errors import CourseError
from gripcourse.text.words import Words


def filled(template: str, folder: Path, **values: object) -> str:
    (folder / "one.html.j2").write_text(template, encoding="utf-8")
    return render_html(Document("one.html.j2", (), values), folder, Words("en"))


@pytest.mark.parametrize(
    "template",
    [
        "{{ cycler.__init__.__globals__.os.popen('id').read() }}",
        "{{ say.__func__.__globals__ }}",
        "{{ ''.__class__.__mro__[1].__subclasses__() }}",
        "{{ '{0.__class__}'.format(say) }}",
        "{{ say | attr('__self__') }}",
        "{{ [say] | map(attribute='__self__') | first }}",
        "{{ place.read_text() }}",
        "{{ place.unlink() }}",
        "{{ taken.append(1) }}",
        "{% for one in range(999999999) %}{% endfor %}",
        "{% include '../secret' %}",
    ],
)
def test_a_strange_template_reaches_neither_python_nor_files(template: str, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("SECRET", encoding="utf-8")
    (tmp_path / "templates").mkdir()
    with pytest.raises(CourseError):
        filled(template, tmp_path / "templates", place=tmp_path / "secret", taken=[])
    assert (tmp_path / "secret").read_text(encoding="utf-8") == "SECRET"


@pytest.mark.parametrize(
    "product",
    [
        "'x' * 99999999999",
        "9 ** 9 ** 9 ** 9",
        "'{:999999999}'.format(1)",
        "'{:{w}}'.format(1, w=999999999)",
        "('{:999999999}' | attr('format'))(1)",
        "'%0999999999d' % 1",
        "'%0999999999d' | format(1)",
        "'x' | center(999999999)",
        "'x'.ljust(999999999)",
        "'x'.zfill(999999999)",
        "lipsum(n=100000)",
    ],
)
def test_a_template_cannot_fill_the_memory(product: str, tmp_path: Path) -> None:
    with pytest.raises(CourseError):
        filled(f"{{{{ {product} }}}}", tmp_path)


def test_what_templates_need_is_allowed(tmp_path: Path) -> None:
    template = (
        "{% macro twice(one) %}{{ one }}{{ one }}{% endmacro %}{{ twice('a') }}"
        "{{ _('{n} of').format(n=2) }}{{ ', '.join(names) }}{{ 2 * 3 }}{{ names.0.split('b') }}"
    )
    assert filled(template, tmp_path, names=["abc"]).endswith("[&#39;a&#39;, &#39;c&#39;]")
