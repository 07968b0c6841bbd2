#pragma once
#include <brdf/exports/Exporter.h>

#include <map>
#include <string_view>

namespace brdf {

/// `material` with samples: its own, or its values at pairs of directions that show lobes of every width. A third of
/// them about highlights: theta_h = 90 degrees t^4 with t even in (0, 1), so that each decade of angles about the
/// highlight has its share, theta_d and phi_d even; the others even in solid angle over both hemispheres.
BRDF_EXPORT BrdfPointer sampledForExport(BrdfPointer material);

/// The fit of the lobes (parseLobeRequests) to `target`, lobes without weight left out. `hold`: "Lobe.parameter" to a
/// value, as holdParameter takes it.
std::shared_ptr<const LobeSum> fitLobes(const Brdf& target, std::string_view lobes, const FitOptions& options,
                                        const std::vector<std::string>& hold = {});

/// The same where colours are parameters of a shape: all are fitted to the luminance, then those named in `colours`
/// ("Lobe.parameter"; scale factors too, unless held) to each channel, the rest held.
std::shared_ptr<const LobeSum> fitColours(const Brdf& target, std::string_view lobes, const FitOptions& options,
                                          const std::vector<std::string>& colours,
                                          const std::vector<std::string>& hold = {});

/// The nearest by the metric of `options` of those that are not null; null when all are.
std::shared_ptr<const LobeSum> nearest(const Brdf& target, const FitOptions& options,
                                       const std::vector<std::shared_ptr<const LobeSum>>& candidates);

ExportError exportError(const LobeSum& evaluated, const Brdf& material, double maximumTheta);

/// The value of a lobe's parameter, by its name, in one channel.
double parameterOf(const Lobe& lobe, std::string_view name, std::size_t channel = 0);
/// Whether all channels have the same value.
bool sameInAllChannels(const std::vector<double>& values);
/// Empty where all channels have the same value of every parameter that is not in `colours`, else the reason.
std::string differsBetweenChannels(const Lobe& lobe, const std::vector<std::string_view>& colours = {});
double largestScale(const Lobe& lobe);
/// Scale factors, or values of a parameter, as colour: three numbers, equal ones for one channel.
std::array<double, 3> colourOf(const std::vector<double>& values);
/// Three numbers with blanks or another text between them.
std::string colourText(const std::array<double, 3>& colour, std::string_view separator = " ");
/// The sum with the scale factors of the lobes called `model` held to at most `maximum`.
std::shared_ptr<const LobeSum> withScaleAtMost(const LobeSum& sum, std::string_view model, double maximum);

}  // namespace brdf
