"""One source for each lobe, from the records of its parameters (`brdf models --json`)."""

from .classes import comment
from .properties import property_of
from .xml import documentation, element, number


def proxy_name(model):
    return "BRDF" + model.removeprefix("BRDF")


def parameter_property(parameter):
    scale = " Logarithmic." if parameter["scale"] == "logarithmic" else ""
    follows = parameter.get("follows")
    text = (
        f"{parameter['label'].capitalize()}: {parameter['description']} Symbol {parameter['symbol']}, unit {parameter['unit']}; from {parameter['min']:g} "
        f"to {parameter['max']:g}, usually {parameter['soft_min']:g} to {parameter['soft_max']:g}.{scale}"
    )
    decorator = element(
        "PropertyWidgetDecorator", type="GenericDecorator", mode="visibility", property="Tied", value="0"
    )
    # The slider spans the range of real materials; the class refuses what is out of the hard bounds.
    slider = element(
        "DoubleRangeDomain", name="range", min=number(parameter["soft_min"]), max=number(parameter["soft_max"])
    )
    return element(
        "DoubleVectorProperty",
        slider,
        documentation(text + (f" Follows {follows} where tied." if follows else "")),
        element("Hints", decorator) if follows else [],
        name=parameter["name"],
        label=parameter["name"],  # ParaView's Python takes its names from labels
        command="SetParameter",
        initial_string=parameter["name"],
        number_of_elements=1,
        default_values=number(parameter["default"]),
    )


def lobe_proxy(model, source):
    """The source "GGX" is of class vtkBRDFModelSource with the model set."""
    parameters = model["parameters"]
    names = [p["name"] for p in parameters]
    chosen = element(
        "StringVectorProperty",
        documentation(comment(type(source).SetModel)),
        name="Model",
        command="SetModel",
        number_of_elements=1,
        default_values=model["name"],
        panel_visibility="never",
    )
    properties = [chosen, property_of(source, "Scale", {"low": 0.0})]
    if any("follows" in p for p in parameters):
        properties.append(property_of(source, "Tied", {}))
    properties += [parameter_property(p) for p in parameters]
    group = element("PropertyGroup", *[element("Property", name=n) for n in names], label="Parameters") if names else []
    return element(
        "SourceProxy",
        documentation(f"{model['title']}. Source: {model['reference']}.", model["title"]),
        *properties,
        group,
        element("Hints", element("ShowInMenu", category="BRDF Lobes")),
        name=proxy_name(model["name"]),
        label=proxy_name(model["name"]).replace("BRDF", "BRDF ", 1),
        **{"class": "vtkBRDFModelSource"},
    )


def lobe_proxies(models, source):
    return [line for model in models for line in lobe_proxy(model, source)]
