"""What the classes say of their properties: names and defaults of getters, bounds of clamped setters, the comments of the
headers (VTK's Python wrapping has them as docstrings)."""

import inspect
import re


def comment(documented):
    """The text of a comment of a C++ header, without the signatures that the wrapping puts before it."""
    paragraphs = re.split(r"\n\s*\n", inspect.getdoc(documented) or "")
    texts = []
    for paragraph in paragraphs:
        text = " ".join(paragraph.split())
        if text and "C++:" not in text:
            texts.append(text)
    return " ".join(texts)


def brief(kind):
    """What a class is, in one line, and the paragraphs after it."""
    paragraphs = [" ".join(p.split()) for p in re.split(r"\n\s*\n", inspect.getdoc(kind) or "")]
    title = paragraphs[0].partition(" - ")[2]
    return title, [p for p in paragraphs[1:] if p and not p.startswith("Superclass:")]


def settings(kind):
    """Names X of all properties with SetX and GetX of our own classes."""
    names = set()
    for base in kind.__mro__:
        if base.__name__.startswith("vtkBRDF"):
            own = vars(base)
            names |= {n[3:] for n in own if n.startswith("Set") and "Get" + n[3:] in own}
    return names


def default(instance, name):
    return getattr(instance, "Get" + name)()


def bounds(instance, name):
    """What a clamped setter clamps to, or (None, None)."""
    low, high = (getattr(instance, f"Get{name}{end}Value", None) for end in ("Min", "Max"))
    return (low() if low else None, high() if high else None)
