"""docs/gallery.md: every kind of picture."""

TITLE = "Gallery"
INTRODUCTION = """Every kind of picture, each with the command that drew it. `scripts/draw_pages.py` draws all of them anew.

They begin with a table in the layout of the MERL database, computed from a published fit, a fit to it, and a simulation:"""

GOLD = "preset:bagher-sgd-gold-metallic-paint"
SMALL = "--size 450x350"

# What the commands read, made first: a table in the layout of the MERL database, its fit, scattered samples with noise.
MATERIALS = [
    f"convert {GOLD} gold.binary",
    'fit gold.binary --lobes "Lambertian + GGX" --metric cuberoot --out fit.vtkhdf',
    'simulate "brushed(coverage=3)" --facet "conductor(eta=0.2 0.9 1.1, k=3.9 2.4 2.2)" --theta-i 45 --phi-i 0,45,90 '
    '--resolution 3 --tolerance 0.02 --out brushed.vtkhdf',
]

SECTIONS = [
    (
        "Lobes",
        "Values over all view directions for one direction of light: [views](views.md).",
        [
            ("lobe", "A table and its fit for light at 45 degrees, radius the cube root of f_r.",
             f"lobe gold.binary fit.vtkhdf --transform cuberoot {SMALL}"),
            ("lobe-colour", "The true colour of a fit, one lobe beside the other.",
             f'lobe {GOLD} "(0.6,0.1,0.05)*Lambertian + 0.05*GGX(alpha=0.3, ior=1.5)" --channel rgb --transform cuberoot '
             f"--layout side {SMALL}"),
            ("lobe-anisotropic", "Brushed metal, log of f_r over a floor of 0.01 per steradian, coloured by value.",
             f'lobe "GGX(alpha=0.1, alpha_y=0.4, ior=1.5)" --theta-i 40 --phi-i 30 --transform logfloor --floor 0.01 --colour value {SMALL}'),
            ("lobe-difference", "A fit less its table, as dents and bumps of a hemisphere.",
             f"lobe fit.vtkhdf gold.binary --difference displaced --transform cuberoot {SMALL}"),
        ],
    ),
    (
        "Slices and curves",
        "Sections through a BRDF as images, goniometer diagrams, curves and albedos: [slices](slices.md).",
        [
            ("slice-image", "theta_h and theta_d of three materials, as the slices of the MERL database are shown.",
             f'slice gold.binary fit.vtkhdf "0.3*Lambertian + SheenCharlie(r=0.4)" --kind image --channel rgb --warp 2 '
             f"--size 900x350"),
            ("slice-polar", "In the plane of incidence.",
             f'slice gold.binary fit.vtkhdf --kind polar --theta-i 45 --scale cuberoot {SMALL}'),
            ("slice-cartesian", "Over the half angle, on a log scale.",
             f"slice gold.binary fit.vtkhdf --kind cartesian --over theta_h --scale log {SMALL}"),
            ("slice-albedo", "Light reflected in all, by the direction it comes from.",
             f"slice gold.binary fit.vtkhdf --kind albedo {SMALL}"),
            ("slice-holes", "Which cells of a table are measured, filled, or below the horizon.",
             f"slice gold.binary --kind holes {SMALL}"),
            ("slice-volume", "A table in its three half/difference coordinates.",
             f"slice gold.binary --kind volume {SMALL}"),
        ],
    ),
    (
        "Errors",
        "Where two materials differ, by any metric of a fit: [views](views.md).",
        [
            ("error", "Over the two polar angles; the worst directions are marked.",
             f"error fit.vtkhdf gold.binary --measure cuberoot {SMALL}"),
            ("error-half", "Over half and difference angle.",
             f"error fit.vtkhdf gold.binary --measure log --axes theta_h,theta_d {SMALL}"),
            ("error-hemisphere", "Over all view directions for one direction of light.",
             f"error fit.vtkhdf gold.binary --measure cuberoot --axes hemisphere --theta-i 60 {SMALL}"),
        ],
    ),
    (
        "Simulated",
        "Light traced through surfaces too small to be seen: [simulation](simulation.md), "
        "[microsurfaces](microsurfaces.md).",
        [
            ("surface", "Scratched metal, heights in micrometres.", f'surface "brushed(coverage=3)" {SMALL}'),
            ("simulated", "Its reflection for light along the scratches, gold.",
             f"lobe brushed.vtkhdf --theta-i 45 --phi-i 90 --channel rgb --transform cuberoot {SMALL}"),
        ],
    ),
    (
        "Rendering",
        "The same materials under light, by shaders or by path tracing: [rendering](rendering.md), [scenes](scenes.md).",
        [
            ("render-fit", "A fit under an environment, filtered importance sampling in a shader.",
             "render fit.vtkhdf --light env:datasets/environments/venice.exr --exposure 1.5 --size 300x300"),
            ("render-table", "The table itself, by its importance tables.",
             "render gold.binary --light env:datasets/environments/venice.exr --exposure 1.5 --size 300x300"),
            ("render-converged", "The same without filtering, until the standard error is 1 percent.",
             "render fit.vtkhdf --light env:datasets/environments/venice.exr --exposure 1.5 --converge --tolerance 0.01 "
             "--size 300x300"),
            ("render-reference", "The same by the CPU's path tracer.",
             "render fit.vtkhdf --light env:datasets/environments/venice.exr --exposure 1.5 --reference --samples 256 "
             "--size 300x300"),
            ("render-brushed", "An anisotropic material on a ground plane, with shadows.",
             'render "0.9*Ward(ax=0.08, ay=0.35) + 0.05*Lambertian" --object torus --ground "0.4*Lambertian" '
             "--camera three-quarter --light env:datasets/environments/sunset.exr --size 300x300"),
            ("render-preview", "A preview object in a studio, light between its parts included.",
             'render "(0.5,0.1,0.05)*Lambertian + 0.3*GGX(alpha=0.15, ior=1.5)" --object preview --ground '
             '"0.4*Lambertian" --camera three-quarter --light env:datasets/environments/studio.exr --exposure -2.5 --reference --bounces 3 --samples 128 --size 300x300'),
            ("render-scene", "A scene file with three materials, light between the objects included.",
             "render --scene docs/examples/three-spheres.json --reference --bounces 4 --samples 256 --size 450x300"),
        ],
    ),
    (
        "Audits",
        "Whether a model keeps its digits, its energy and its reciprocity: [checks](checks.md).",
        [
            ("check", "The audit of a lobe.", "check \"GGX(alpha=0.1)\" --size 1000x1000"),
        ],
    ),
]
