#pragma once
#include <brdf/exports/Exporter.h>

#include <map>
#include <string_view>

namespace brdf {

/// Pairs of directions that show lobes of every width: theta_h = 90 degrees t^4 with t even in (0, 1), so that each
/// decade of angles about the highlight has its share, theta_d and phi_d even, phi_h turned by the golden angle.
/// `material`'s values there are the samples.
BRDF_EXPORT BrdfPointer sampledForExport(BrdfPointer material);

/// A sum of linear sRGB lobes equal to a spectral one: its scale factors seen as colours, where they do not become
/// negative and no parameter differs between the wavelengths; else null.
std::shared_ptr<const LobeSum> spectralAsRgb(const LobeSum& material);

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
/// Whether all channels have the same value of the parameter / of the scale factor.
bool sameInAllChannels(const std::vector<double>& values);
/// The largest and the mean scale factor over the channels.
double largestScale(const Lobe& lobe);
double meanScale(const Lobe& lobe);

}  // namespace brdf
