"""Properties of proxies: the type and the default come from the class's getter, the text from its header."""

from .classes import bounds, comment, default
from .xml import documentation, element, number, numbers

# What is not in the classes: how a value is entered. `choices`: all values there are; `names`: a registry
# (vtkBRDFRegistry) at run time, with `first` before it; `low`, `high`: the range of a slider where the setter clamps
# none; `mention`: what the text lists besides, as (title, function that gives names); `enumeration`: texts for 0, 1, ...;
# `file`: "open" or "save"; `advanced`: behind ParaView's gear; `lines`: a field of several; `show_if`: (property, value).
LARGEST = 2**31 - 1  # of ParaView's integer properties
KEYS = {"choices", "names", "first", "low", "high", "enumeration", "file", "advanced", "lines", "show_if", "mention"}


def label_of(name):
    """ "ThetaI" -> "Theta I"; ParaView's own rule, but abbreviations stay whole."""
    words, previous = "", ""
    for letter in name:
        words += (" " if letter.isupper() and previous.islower() else "") + letter
        previous = letter
    return words


def hints(how):
    if "show_if" not in how:
        return []
    name, value = how["show_if"]
    decorator = element("PropertyWidgetDecorator", type="GenericDecorator", mode="visibility", property=name, value=value)
    return element("Hints", decorator)


def domain(how, value, low, high):
    count = len(value) if isinstance(value, (tuple, list)) else 1
    first = value[0] if isinstance(value, (tuple, list)) else value
    if isinstance(first, bool):
        return element("BooleanDomain", name="bool")
    if isinstance(first, (int, float)):
        if "enumeration" in how:
            entries = [element("Entry", text=text, value=k) for k, text in enumerate(how["enumeration"])]
            return element("EnumerationDomain", *entries, name="enum")
        if high is not None and high > LARGEST:
            high = None
        if low is None and high is None:
            return []
        if all(isinstance(end, (int, float)) or end is None for end in (low, high)):
            tag = "IntRangeDomain" if isinstance(first, int) else "DoubleRangeDomain"
            low, high = (None if end is None else " ".join([number(type(first)(end))] * count) for end in (low, high))
            return element(tag, name="range", min=low, max=high)
        raise ValueError(f"bounds {low}, {high}")
    if "names" in how:
        return element("BRDFNamesDomain", name="names", kind=how["names"], first=how.get("first"))
    if "choices" in how:
        return element("StringListDomain", *[element("String", value=c) for c in how["choices"]], name="list")
    if "file" in how:
        return element("FileListDomain", name="files")
    return []


def property_of(instance, name, how, text=None, command=None, value=None):
    """The property `name` of an object of ours."""
    unknown = set(how) - KEYS
    if unknown:
        raise ValueError(f"{name}: {unknown}")
    value = default(instance, name) if value is None else value
    text = text or comment(getattr(type(instance), "Set" + name))
    if not text:
        raise ValueError(f"{type(instance).__name__}::Set{name}: the header says nothing of it")
    if "mention" in how:
        title, names = how["mention"]
        text += f" {title}: {', '.join(names())}."
    low, high = bounds(instance, name)
    low, high = (how.get("low") if low is None else low), (how.get("high") if high is None else high)
    first = value[0] if isinstance(value, (tuple, list)) else value
    kind = "String" if isinstance(first, str) else "Double" if isinstance(first, float) else "Int"
    values = value if kind == "String" else numbers(value if isinstance(value, (tuple, list)) else (value,))
    common = dict(
        name=name,
        label=label_of(name),
        command=command or "Set" + name,
        number_of_elements=len(value) if isinstance(value, (tuple, list)) else 1,
        default_values=values,
        panel_visibility="advanced" if how.get("advanced") else None,
    )
    multi = element("Hints", element("Widget", type="multi_line")) if how.get("lines") else []
    return element(
        kind + "VectorProperty", domain(how, value, low, high), documentation(text), multi or hints(how), **common
    )
