"""Writes server-manager XML."""

from xml.sax.saxutils import escape, quoteattr


def number(value):
    """The shortest text that reads back to the same number."""
    return repr(float(value)).removesuffix(".0") if isinstance(value, float) else str(int(value))


def numbers(values):
    return " ".join(number(v) for v in values)


def attributes(**named):
    return "".join(f" {name}={quoteattr(str(value))}" for name, value in named.items() if value is not None)


def element(tag, *children, **named):
    """A tag with children (lists of lines) as a list of lines."""
    lines = [line for child in children for line in child]
    if not lines:
        return [f"<{tag}{attributes(**named)}/>"]
    return [f"<{tag}{attributes(**named)}>", *("  " + line for line in lines), f"</{tag}>"]


def documentation(text, short=None):
    return [f"<Documentation{attributes(short_help=short)}>{escape(text)}</Documentation>"] if text else []


def configuration(*groups):
    """A whole file from (name of the proxy group, lines) pairs."""
    body = [element("ProxyGroup", lines, name=name) for name, lines in groups]
    note = ["<!-- Generated from the C++ classes and the records of the lobes by paraview/describe.py. -->"]
    return "\n".join(note + element("ServerManagerConfiguration", *body)) + "\n"
