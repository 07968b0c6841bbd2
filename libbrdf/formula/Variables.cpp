#include <brdf/formula/Variables.h>

#include <numbers>

namespace brdf::formula {
namespace {

NodeId var(Graph& g, std::string_view name) { return *makeVariable(g, name); }
NodeId sumOf(Graph& g, Input a, Input b) { return g.add(g.input(a), g.input(b)); }
NodeId square(Graph& g, NodeId a) { return g.mul(a, a); }
NodeId dot3(Graph& g, NodeId ax, NodeId ay, NodeId az, NodeId bx, NodeId by, NodeId bz) {
  return g.add(g.add(g.mul(ax, bx), g.mul(ay, by)), g.mul(az, bz));
}
NodeId hypot2(Graph& g, NodeId x, NodeId y) { return g.add(square(g, x), square(g, y)); }
NodeId theta(Graph& g, NodeId x, NodeId y, NodeId z) { return g.make(Op::Atan2, g.sqrt(hypot2(g, x, y)), z); }

#define INPUT(name) [](Graph& g) { return g.input(Input::name); }

constexpr Variable kVariables[] = {
    {"pi", "3.14159...", [](Graph& g) { return g.constant(std::numbers::pi); }},
    {"_pi", "pi, as the original BRDFLab spells it", [](Graph& g) { return g.constant(std::numbers::pi); }},
    {"ux", "x of the light direction wi", INPUT(Ux)},
    {"uy", "y of the light direction wi", INPUT(Uy)},
    {"uz", "z of the light direction wi: cosine of theta_i", INPUT(Uz)},
    {"vx", "x of the view direction wo", INPUT(Vx)},
    {"vy", "y of the view direction wo", INPUT(Vy)},
    {"vz", "z of the view direction wo: cosine of theta_o", INPUT(Vz)},
    {"random1", "first uniform random number in [0, 1), samplers only", INPUT(Random1)},
    {"random2", "second uniform random number in [0, 1), samplers only", INPUT(Random2)},
    {"cos_i", "cosine of theta_i, the same as uz", INPUT(Uz)},
    {"cos_o", "cosine of theta_o, the same as vz", INPUT(Vz)},
    {"Hx", "x of the unnormalised half vector wi + wo", [](Graph& g) { return sumOf(g, Input::Ux, Input::Vx); }},
    {"Hy", "y of the unnormalised half vector", [](Graph& g) { return sumOf(g, Input::Uy, Input::Vy); }},
    {"Hz", "z of the unnormalised half vector", [](Graph& g) { return sumOf(g, Input::Uz, Input::Vz); }},
    {"H2", "squared length of the unnormalised half vector: 4 cos^2 theta_d",
     [](Graph& g) {
       const NodeId x = var(g, "Hx"), y = var(g, "Hy"), z = var(g, "Hz");
       return dot3(g, x, y, z, x, y, z);
     }},
    {"H", "length of the unnormalised half vector", [](Graph& g) { return g.sqrt(var(g, "H2")); }},
    {"hx", "x of the half vector, unit length", [](Graph& g) { return g.div(var(g, "Hx"), var(g, "H")); }},
    {"hy", "y of the half vector, unit length", [](Graph& g) { return g.div(var(g, "Hy"), var(g, "H")); }},
    {"hz", "z of the half vector, unit length: cosine of theta_h",
     [](Graph& g) { return g.div(var(g, "Hz"), var(g, "H")); }},
    {"cos_h", "cosine of theta_h, the same as hz", [](Graph& g) { return var(g, "hz"); }},
    {"cos2_h", "squared cosine of theta_h", [](Graph& g) { return g.div(square(g, var(g, "Hz")), var(g, "H2")); }},
    {"tan2_h", "squared tangent of theta_h, from the unnormalised half vector",
     [](Graph& g) { return g.div(hypot2(g, var(g, "Hx"), var(g, "Hy")), square(g, var(g, "Hz"))); }},
    {"cos_d", "cosine of theta_d, the angle between either direction and the half vector",
     [](Graph& g) { return g.mul(g.constant(0.5), var(g, "H")); }},
    {"sin2_d", "squared sine of theta_d, from the difference of the directions",
     [](Graph& g) {
       const NodeId x = g.sub(g.input(Input::Ux), g.input(Input::Vx));
       const NodeId y = g.sub(g.input(Input::Uy), g.input(Input::Vy));
       const NodeId z = g.sub(g.input(Input::Uz), g.input(Input::Vz));
       return g.mul(g.constant(0.25), dot3(g, x, y, z, x, y, z));
     }},
    {"cos_io", "cosine of the angle between the two directions",
     [](Graph& g) {
       return dot3(g, g.input(Input::Ux), g.input(Input::Uy), g.input(Input::Uz), g.input(Input::Vx),
                   g.input(Input::Vy), g.input(Input::Vz));
     }},
    {"cos_r", "cosine of the angle between the view direction and the light's mirror direction",
     [](Graph& g) {
       return g.sub(
           g.mul(g.input(Input::Uz), g.input(Input::Vz)),
           g.add(g.mul(g.input(Input::Ux), g.input(Input::Vx)), g.mul(g.input(Input::Uy), g.input(Input::Vy))));
     }},
    {"sin2_r2", "squared sine of half the angle between the view direction and the light's mirror direction",
     [](Graph& g) {
       const NodeId x = var(g, "Hx"), y = var(g, "Hy"), z = g.sub(g.input(Input::Uz), g.input(Input::Vz));
       return g.mul(g.constant(0.25), dot3(g, x, y, z, x, y, z));
     }},
    {"sin2_i", "squared sine of theta_i", [](Graph& g) { return hypot2(g, g.input(Input::Ux), g.input(Input::Uy)); }},
    {"sin2_o", "squared sine of theta_o", [](Graph& g) { return hypot2(g, g.input(Input::Vx), g.input(Input::Vy)); }},
    {"tan2_i", "squared tangent of theta_i",
     [](Graph& g) { return g.div(var(g, "sin2_i"), square(g, g.input(Input::Uz))); }},
    {"tan2_o", "squared tangent of theta_o",
     [](Graph& g) { return g.div(var(g, "sin2_o"), square(g, g.input(Input::Vz))); }},
    {"dot_xy", "dot product of the directions' tangential parts: sin theta_i sin theta_o cos(phi_i - phi_o)",
     [](Graph& g) {
       return g.add(g.mul(g.input(Input::Ux), g.input(Input::Vx)), g.mul(g.input(Input::Uy), g.input(Input::Vy)));
     }},
    {"theta_i", "polar angle of the light, radians",
     [](Graph& g) { return theta(g, g.input(Input::Ux), g.input(Input::Uy), g.input(Input::Uz)); }},
    {"phi_i", "azimuth of the light, radians, (-pi, pi]",
     [](Graph& g) { return g.make(Op::Atan2, g.input(Input::Uy), g.input(Input::Ux)); }},
    {"theta_o", "polar angle of the viewer, radians",
     [](Graph& g) { return theta(g, g.input(Input::Vx), g.input(Input::Vy), g.input(Input::Vz)); }},
    {"phi_o", "azimuth of the viewer, radians, (-pi, pi]",
     [](Graph& g) { return g.make(Op::Atan2, g.input(Input::Vy), g.input(Input::Vx)); }},
    {"theta_h", "polar angle of the half vector, radians",
     [](Graph& g) { return theta(g, var(g, "Hx"), var(g, "Hy"), var(g, "Hz")); }},
    {"phi_h", "azimuth of the half vector, radians",
     [](Graph& g) { return g.make(Op::Atan2, var(g, "Hy"), var(g, "Hx")); }},
    {"theta_d", "angle between either direction and the half vector, radians",
     [](Graph& g) { return g.make(Op::Atan2, g.sqrt(var(g, "sin2_d")), var(g, "cos_d")); }},
};
#undef INPUT

}  // namespace

std::span<const Variable> variables() { return kVariables; }

std::optional<NodeId> makeVariable(Graph& graph, std::string_view name) {
  for (const Variable& variable : kVariables)
    if (variable.name == name) return variable.make(graph);
  return std::nullopt;
}

}  // namespace brdf::formula
