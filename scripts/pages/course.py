"""docs/course.md: what a BRDF is, in ten pictures."""

TITLE = "What a BRDF is, in ten pictures"
INTRODUCTION = """The **bidirectional reflectance distribution function** of a surface, f_r(wi, wo), says how much of the light that
arrives from a direction wi leaves towards a direction wo: radiance out over irradiance in, per steradian (1/sr). Each
picture is made by the command under it; change a number and make it again. Words are explained in
[concepts](concepts.md)."""

SMALL = "--size 450x350"
MATERIALS = []

SECTIONS = [
    (
        "1. The same towards everyone",
        "Light comes from 45 degrees (the arrow). In every direction of view a point is drawn as far from the centre as "
        "f_r is large. A Lambertian surface, near enough chalk or paper, sends the same radiance everywhere: the lobe is "
        "a half ball of radius albedo/pi.",
        [("lambertian", "", f'lobe "0.8*Lambertian" {SMALL}')],
    ),
    (
        "2. Towards the mirror direction",
        "A glossy surface prefers the direction in which a mirror would reflect. The base of the lobe is the diffuse "
        "part, light that has been inside the material and has its colour; the bump is the specular part, reflected at "
        "the interface.",
        [("glossy", "", f'lobe "0.5*Lambertian + GGX(alpha=0.25, ior=1.5)" {SMALL}')],
    ),
    (
        "3. Rougher is broader, and lower",
        "Three degrees of roughness. The reflected light is about the same in all, so that the narrow lobe is the tall "
        "one: its peak grows as 1/alpha^2. The cube root of f_r is drawn, or the broad ones would not be seen.",
        [
            (
                "roughness",
                "",
                'lobe "GGX(alpha=0.1, ior=1.5)" "GGX(alpha=0.2, ior=1.5)" "GGX(alpha=0.4, ior=1.5)" '
                f"--transform cuberoot {SMALL}",
            )
        ],
    ),
    (
        "4. Everything shines at grazing angles",
        "The same surface in light from 75 degrees. An interface reflects more at grazing incidence (Fresnel), and the "
        "peak moves beyond the mirror direction, because the brightest facets are not the average ones.",
        [("grazing", "", f'lobe "0.5*Lambertian + GGX(alpha=0.25, ior=1.5)" --theta-i 75 --transform cuberoot {SMALL}')],
    ),
    (
        "5. Some look back",
        "In the plane of incidence, as a goniometer draws it. Rough diffuse surfaces (the full moon, brick) send more "
        "light back to where it came from than Lambert's law says: Oren and Nayar's model beside it.",
        [
            (
                "retro",
                "",
                f'slice "0.8*Lambertian" "0.8*OrenNayar(sigma=0.6)" --kind polar --theta-i 60 {SMALL}',
            )
        ],
    ),
    (
        "6. Brushed metal has a direction",
        "Where the surface is brushed, the lobe is wide across the scratches and narrow along them, and turning the "
        "surface changes what is seen: the material is anisotropic, and needs a fourth angle.",
        [("brushed", "", f'lobe "GGX(alpha=0.1, alpha_y=0.4, ior=1.5)" --theta-i 40 --phi-i 30 --transform cuberoot {SMALL}')],
    ),
    (
        "7. Coordinates in which materials are simple",
        "The half vector lies midway between light and view; theta_h is its angle from the normal, theta_d that from the "
        "half vector to the light. In these angles (Rusinkiewicz 1998) the highlight stands at the left edge, grazing "
        "reflection at the top, and what is looked for in a measured material has its place in the picture.",
        [
            (
                "half-difference",
                "",
                'slice "(0.3,0.1,0.05)*Lambertian + 0.5*GGX(alpha=0.2, ior=1.5)" --kind image --channel rgb '
                f"--warp 2 {SMALL}",
            )
        ],
    ),
    (
        "8. No more out than in",
        "All the light that leaves, for light from each angle: the directional albedo. It must not exceed 1. A model of "
        "one reflection at each facet of a rough metal loses what a second facet would have sent on; with that light "
        "given back the white surface is white.",
        [
            (
                "albedo",
                "",
                'slice "GGXConductor(alpha=1, eta=0.001, k=100)" '
                '"GGXConductor(alpha=1, eta=0.001, k=100) + GGXMultiscatter(alpha=1, F0=1)" "0.8*Lambertian" '
                f"--kind albedo {SMALL}",
            )
        ],
    ),
    (
        "9. A model is fitted, and misses",
        "A published fit of a measured metallic paint stands for the measurement here; a sum of two simple lobes is "
        "fitted to it. The map shows how far the fit is off for each pair of polar angles, and the marks where most.",
        [
            (
                "error",
                "",
                'error "(0.01295,0.00539,0)*Lambertian + (0.3579,0.2552,0.1257)*GGX(alpha=0.2127, ior=4.898)" '
                f"preset:bagher-sgd-gold-metallic-paint --measure cuberoot {SMALL}",
            )
        ],
    ),
    (
        "10. What it is for",
        "Light arrives from everywhere, and at each point of an object the BRDF weighs it: L_o(wo) is the integral of "
        "f_r(wi, wo) L_i(wi) cos(theta_i) over all wi. A ball of the paint of picture 9 under a sunset.",
        [
            (
                "render",
                "",
                "render preset:bagher-sgd-gold-metallic-paint --light env:datasets/environments/sunset.exr --exposure 1 "
                "--size 350x350",
            )
        ],
    ),
]
