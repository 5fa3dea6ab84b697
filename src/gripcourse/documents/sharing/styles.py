"""Styles of elements: computed once for all elements that stand alike under the same style sheets.

An element stands alike where its parent does, the same rules hold for it and it says the same of
itself. What is computed for such elements is kept in a model; the style that a document gets holds
values of its own, taken from the model when they are first asked for. So whatever a document does
to its styles, none but that document sees it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import inf
from typing import Any, Final, TypeAlias

from weasyprint.css import (
    ComputedStyle,
    InitialStyle,
    StyleFor,
    declaration_precedence,
    find_style_attributes,
    preprocess_declarations,
)

from gripcourse.documents.sharing.bounded import Bounded

_MOST_SETS: Final = 8  # of style sheets
_MOST_PLACES: Final = 3000  # under one set; reports have a thousand, of 10 kB

_Element: TypeAlias = Any
_Cascaded: TypeAlias = dict[str, tuple[Any, Any]]
_Declared: TypeAlias = tuple[Any, str | None, tuple[Any, ...]]
_Sheet: TypeAlias = tuple[Any, str, Any]


class _PageSizes(dict[str, tuple[float, float]]):
    """Stands for the size of the page in a model, which has none: notes that it was asked."""

    was_asked = False

    def __getitem__(self, _which: str) -> tuple[float, float]:
        self.was_asked = True
        return (0.0, 0.0)


@dataclass(slots=True)
class _StylePlace:
    """Where elements stand alike.

    Attributes:
        model: their style.
        cascaded: the declarations that hold there, by pseudo-element, `None` for the element.
        pseudo: models of the pseudo-elements that were asked for.
        below: the places of children, by what is said of them.
    """

    model: Any
    cascaded: dict[str | None, _Cascaded]
    pseudo: dict[str, Any] = field(default_factory=dict)
    below: dict[Any, "_StylePlace"] = field(default_factory=dict)

    @property
    def anchored(self) -> list[str]:
        return [one for one, rules in self.cascaded.items() if one and "anchor" in rules]


@dataclass(slots=True)
class _StylePlaces:
    """All places under one set of style sheets."""

    sizes: _PageSizes = field(default_factory=_PageSizes)
    roots: dict[Any, _StylePlace] = field(default_factory=dict)
    number: int = 0


class _Style(ComputedStyle):  # type: ignore[misc]
    """A style of one document, with values that were computed for all."""

    def __init__(self, model: Any, parent: Any, root: Any, page_sizes: Any) -> None:  # noqa: ANN401
        self.model = model
        self.specified = model.specified
        self.parent_style = parent
        self.cascaded = model.cascaded
        self.is_root_element = parent is None
        self.pseudo_type = model.pseudo_type
        self.root_style = root
        self.base_url = model.base_url
        self.font_config = model.font_config
        self.initial_page_sizes = page_sizes
        self.cache = model.cache

    def __missing__(self, key: str) -> Any:  # noqa: ANN401
        sizes = self.model.initial_page_sizes
        if not sizes.was_asked:
            value = self.model[key]
            if not sizes.was_asked:
                self[key] = value
                return value
        return super().__missing__(key)


class SharedStyles:
    """The places of a process, and what gives a document its styles from them."""

    def __init__(self, fonts: object) -> None:
        self._fonts = fonts
        self._places: Bounded[Any, _StylePlaces] = Bounded(_MOST_SETS)

    def style_for(
        self,
        html: Any,  # noqa: ANN401
        sheets: list[_Sheet],
        presentational_hints: bool,  # noqa: FBT001
        font_config: object,
        target_collector: Any,  # noqa: ANN401
    ) -> StyleFor:
        """Give a document the styles of its elements, in place of the class of WeasyPrint."""
        asked = (html, sheets, presentational_hints, font_config, target_collector)
        if font_config is not self._fonts or presentational_hints:
            return StyleFor(*asked)
        key = (tuple(sheets), html.base_url)
        places = self._places.get(key)
        if places is None or places.number > _MOST_PLACES or places.sizes.was_asked:
            places = _StylePlaces()
            self._places.put(key, places)
        return _StylesOfDocument(html, sheets, font_config, target_collector, places)


class _StylesOfDocument(StyleFor):  # type: ignore[misc]
    """The styles of one document."""

    def __init__(
        self,
        html: Any,  # noqa: ANN401
        sheets: list[_Sheet],
        fonts: Any,  # noqa: ANN401
        collector: Any,  # noqa: ANN401
        places: _StylePlaces,
    ) -> None:
        self._cascaded_styles: dict[Any, Any] = {}  # of pages, later
        self._computed_styles: dict[Any, Any] = {}
        self.initial_page_sizes = {"box": None, "area": None}
        self._sheets = sheets
        self.font_config = fonts
        self._root = html.etree_element
        self._base_url = html.base_url
        self._places = places
        self._place_of: dict[_Element, _StylePlace] = {}
        self._set_all(html, collector)

    def __call__(self, element: _Element, pseudo_type: str | None = None) -> Any:  # noqa: ANN401
        """Return a style; that of a pseudo-element is made when it is asked for: few ever are."""
        if pseudo_type and (element, pseudo_type) not in self._computed_styles:
            place = self._place_of.get(element)
            if place is not None and pseudo_type in place.cascaded:
                self._set_pseudo(element, pseudo_type, place)
        return super().__call__(element, pseudo_type)

    def _set_all(self, html: Any, collector: Any) -> None:  # noqa: ANN401
        """Give each element its style, in the order of the tree, and collect the anchors."""
        said_of = _said_of_themselves(html)
        shared: dict[tuple[int, int], _Style] = {}
        for wrapper in html.wrapper_element.iter_subtree():
            element = wrapper.etree_element
            parent = wrapper.parent.etree_element if wrapper.parent else None
            said = said_of.get(element, ())
            place = self._find_place(wrapper, parent, said)
            self._place_of[element] = place
            parent_style = self._computed_styles.get((parent, None))
            key = (id(parent_style), id(place))
            style = None if said else shared.get(key)
            if style is None:
                style = self._styled(place.model, parent_style)
                if collector and style["anchor"]:
                    collector.collect_anchor(style["anchor"])
                if not said:
                    shared[key] = style
            self._computed_styles[element, None] = style
        for element, place in self._place_of.items():
            for pseudo_type in place.anchored:
                anchor = self(element, pseudo_type)["anchor"]
                if collector and anchor:
                    collector.collect_anchor(anchor)

    def _find_place(
        self,
        wrapper: Any,  # noqa: ANN401
        parent: _Element,
        said: Iterable[_Declared],
    ) -> _StylePlace:
        matches = [sheet[0].matcher.match(wrapper) for sheet in self._sheets]
        # A rule is known by the sheet and its order in it.
        rules = tuple([tuple([rule[:2] for rule in matched]) for matched in matches])
        words = tuple([(weight, _text(declared)) for weight, _, declared in said])
        above = self._place_of.get(parent)
        beside = self._places.roots if above is None else above.below
        place = beside.get((rules, words))
        if place is None:
            cascaded = _cascaded(self._sheets, matches, said)
            place = _StylePlace(self._model(cascaded[None], above), cascaded)
            beside[rules, words] = place
            self._places.number += 1
        return place

    def _model(
        self, cascaded: _Cascaded, above: _StylePlace | None, pseudo_type: str | None = None
    ) -> ComputedStyle:
        if above is None:
            parent, root = None, InitialStyle(self.font_config)
        else:
            parent, root = above.model, self._place_of[self._root].model
        sizes = self._places.sizes
        return ComputedStyle(
            parent, cascaded, pseudo_type, root, self._base_url, self.font_config, sizes
        )

    def _set_pseudo(self, element: _Element, pseudo_type: str, place: _StylePlace) -> None:
        model = place.pseudo.get(pseudo_type)
        if model is None:
            model = self._model(place.cascaded[pseudo_type], place, pseudo_type)
            place.pseudo[pseudo_type] = model
        style = self._styled(model, self._computed_styles[element, None])
        self._computed_styles[element, pseudo_type] = style

    def _styled(self, model: Any, parent_style: Any) -> _Style:  # noqa: ANN401
        root = model.root_style if parent_style is None else self._computed_styles[self._root, None]
        return _Style(model, parent_style, root, self.initial_page_sizes)


def _said_of_themselves(html: Any) -> Mapping[_Element, list[_Declared]]:  # noqa: ANN401
    """Return what elements say of themselves: style, language, anchor."""
    found: dict[_Element, list[_Declared]] = {}
    for weight, element, declared, base_url in find_style_attributes(
        html.etree_element, presentational_hints=False, base_url=html.base_url
    ):
        found.setdefault(element, []).append((weight, base_url, tuple(declared)))
    return found


def _text(declared: Iterable[Any]) -> str:
    return "".join([one.serialize() for one in declared])


def _cascaded(
    sheets: Iterable[_Sheet], matches: Iterable[Iterable[Any]], said: Iterable[_Declared]
) -> dict[str | None, _Cascaded]:
    """Let the declarations for an element compete: of each property the weightiest holds."""
    cascaded: dict[str | None, _Cascaded] = {None: {}}
    for specificity, base_url, declared in said:
        ready = preprocess_declarations(base_url, declared)
        _compete(cascaded[None], ready, "author", inf, specificity)
    for (sheet, origin, sheet_specificity), matched in zip(sheets, matches, strict=True):
        for specificity, _order, pseudo_type, (declared, layer) in matched:
            layer_order = inf if layer is None else sheet.layers.index(layer)
            style = cascaded.setdefault(pseudo_type, {})
            _compete(style, declared, origin, layer_order, sheet_specificity or specificity)
    return cascaded


def _compete(
    style: _Cascaded,
    declared: Iterable[Any],
    origin: str,
    layer_order: float,
    specificity: tuple[int, ...],
) -> None:
    for name, value, importance in declared:
        weight = (declaration_precedence(origin, importance), layer_order, specificity)
        _, held = style.get(name, (None, None))
        if held is None or held <= weight:
            style[name] = value, weight
