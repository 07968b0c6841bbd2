"""The server-manager files: sources, readers, writers, filters and lobes."""

from .classes import brief, comment, settings
from .lobes import lobe_proxies
from .properties import property_of
from .proxies import FILTERS, READERS, SOURCES, WRITERS
from .xml import configuration, documentation, element

# Endings that registered formats read besides the one that they write.
OTHER_EXTENSIONS = [".ddt", ".sdt"]


def spectrum_directions(kind):
    """The pairs of directions of vtkBRDFSpectrum: a list of any length."""
    return element(
        "DoubleVectorProperty",
        element("DoubleRangeDomain", name="range", min="0 -360 0 -360", max="89.9 360 89.9 360"),
        documentation(comment(kind.AddDirections) + " theta_i, phi_i, theta_o, phi_o of each."),
        name="Directions",
        command="AddDirections",
        clean_command="RemoveAllDirections",
        repeat_command=1,
        number_of_elements_per_command=4,
        use_index=0,
    )


def facets(kind):
    """What the surfaces of vtkBRDFGonioreflectometer are made of: a list of any length."""
    return element(
        "StringVectorProperty",
        documentation(comment(kind.AddFacet)),
        name="Facets",
        command="AddFacet",
        clean_command="RemoveAllFacets",
        repeat_command=1,
        number_of_elements_per_command=1,
    )


EXTRA = {"spectrum_directions": spectrum_directions, "facets": facets}


def input_of(name, port, data_type, optional):
    if data_type is None or data_type.startswith("vtkBRDF"):
        domain = element("BRDFDomain", name="input_type", data_type=data_type)
    else:
        types = [element("DataType", value=one) for one in data_type.split()]
        domain = element("DataTypeDomain", *types, name="input_type")
    groups = element("ProxyGroupDomain", *[element("Group", name=g) for g in ("sources", "filters")], name="groups")
    return element(
        "InputProperty",
        groups,
        domain,
        element("Hints", element("Optional")) if optional else [],
        name=name,
        command="SetInputConnection",
        port_index=port or None,
    )


def group_of(title, names, widget):
    functions = dict(zip(names, ("Theta", "Phi"))) if widget else {}
    members = [element("Property", name=name, function=functions.get(name)) for name in names]
    return element("PropertyGroup", *members, label=title, panel_widget=widget)


def label_of(name):
    return name.replace("BRDF", "BRDF ", 1) if name.count("BRDF") == 1 else name


def words(name):
    label = ""
    for letter in label_of(name):
        label += (" " if letter.isupper() and label[-1:].islower() else "") + letter
    return label


def settings_of(proxy, kind):
    """How every setting of the class is entered: those without a place of their own come last, behind the gear."""
    strange = (set(proxy.settings) | set(proxy.left_out)) - settings(kind)
    if strange:
        raise SystemExit(f"describe/proxies.py, {proxy.name}: settings that do not exist: {strange}")
    rest = sorted(settings(kind) - set(proxy.settings) - set(proxy.left_out))
    return proxy.settings | {name: {"advanced": True} for name in rest}


def proxy_lines(proxy, module, tag="SourceProxy", hints=()):
    """A proxy. Where the class is not wrapped for Python (it needs ParaView) the text is the table's own."""
    kind = getattr(module, proxy.kind, None)
    title, text = brief(kind) if kind else (words(proxy.name), [proxy.text])
    instance = kind() if kind else None
    entered = settings_of(proxy, kind) if kind else {}
    shown = list(hints)
    if proxy.view:
        shown.append(element("View", type=proxy.view))
    return element(
        tag,
        documentation(" ".join([title + "."] + text), title),
        *[input_of(*one) for one in proxy.inputs],
        *[property_of(instance, name, how) for name, how in entered.items()],
        *[EXTRA[name](kind) for name in proxy.extra],
        *[group_of(*group) for group in proxy.groups],
        *[element("OutputPort", name=name, index=k) for k, name in enumerate(proxy.outputs)],
        element("Hints", *shown) if shown else [],
        name=proxy.name,
        label=words(proxy.name),
        **{"class": proxy.kind},
    )


def many(proxies, module, **how):
    menu = element("ShowInMenu", category="BRDF")
    there = [proxy for proxy in proxies if proxy.text or hasattr(module, proxy.kind)]
    return [line for proxy in there for line in proxy_lines(proxy, module, hints=(menu,), **how)]


def extensions_of(names):
    return " ".join(sorted({e.removeprefix(".") for e in names}))


def reader_lines(module, extensions):
    known = extensions_of(extensions + OTHER_EXTENSIONS)
    factory = element("ReaderFactory", extensions=known, file_description="BRDF")
    return [line for p in READERS for line in proxy_lines(p, module, hints=(factory,))]


def writer_lines(module, extensions):
    factory = element("WriterFactory", extensions=extensions_of(extensions), file_description="BRDF")
    return [line for p in WRITERS for line in proxy_lines(p, module, tag="WriterProxy", hints=(factory,))]


def files(module, models, names):
    """File name -> text. `module`: the package brdflab; `names(kind)`: names of a registry."""
    readers = reader_lines(module, names("extensions"))
    writers = writer_lines(module, names("extensions written"))
    return {
        "lobes.xml": configuration(("sources", lobe_proxies(models, module.vtkBRDFModelSource()))),
        "sources.xml": configuration(("sources", many(SOURCES, module) + readers), ("writers", writers)),
        "filters.xml": configuration(("filters", many(FILTERS, module))),
    }
