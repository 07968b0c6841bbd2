#ifndef vtkBRDFChannelAlgorithm_h
#define vtkBRDFChannelAlgorithm_h
#include "vtkBRDFAlgorithm.h"
#include "vtkBRDFFiltersModule.h" // For export macro

#include <string> // For std::string

namespace brdf
{
struct ChannelChoice;
struct ColourSettings;
}

/**
 * @class vtkBRDFChannelAlgorithm
 * @brief Base of filters that show some channels of a BRDF, spectra as colours if asked
 */
class VTKBRDFFILTERS_EXPORT vtkBRDFChannelAlgorithm : public vtkBRDFAlgorithm
{
public:
  vtkTypeMacro(vtkBRDFChannelAlgorithm, vtkBRDFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** "luminance" (default), "rgb" (linear sRGB), "all" (the BRDF's own channels), a channel number from 0, or a
   * wavelength such as "550nm". */
  vtkSetMacro(Channel, std::string);
  vtkGetMacro(Channel, std::string);
  ///@}

  ///@{
  /** The light under which spectral data are seen: a CIE name such as "A" or "F11", or the path of a spectrum. Empty
   * (default): D65, and equal energy for luminance. */
  vtkSetMacro(Illuminant, std::string);
  vtkGetMacro(Illuminant, std::string);
  ///@}

  ///@{
  /** Whose eye sees spectral data: "2" (default) or "10", the degrees of CIE 1931 and CIE 1964. */
  vtkSetMacro(Observer, std::string);
  vtkGetMacro(Observer, std::string);
  ///@}

  ///@{
  /** Whether a white stays white under another light than D65: "bradford" (default) or "none". */
  vtkSetMacro(Adaptation, std::string);
  vtkGetMacro(Adaptation, std::string);
  ///@}

  /** Takes the channel and the colours of another. */
  void CopyChannelSettings(vtkBRDFChannelAlgorithm* other);

  /** The channels of the last execution in words, e.g. "luminance", "550 nm". */
  std::string GetChannelLabel() const { return this->ChannelLabel; }

protected:
  vtkBRDFChannelAlgorithm() = default;
  ~vtkBRDFChannelAlgorithm() override = default;

  /** The BRDF of an input through the channels asked for, which give the label. Throws brdf::Error. */
  brdf::ChannelChoice ChosenChannels(vtkInformationVector** inputs, int port = 0);
  /** Illuminant, observer and adaptation. Throws brdf::Error. */
  brdf::ColourSettings ChosenColours() const;

  std::string Channel = "luminance";

private:
  vtkBRDFChannelAlgorithm(const vtkBRDFChannelAlgorithm&) = delete;
  void operator=(const vtkBRDFChannelAlgorithm&) = delete;

  std::string Illuminant;
  std::string Observer = "2";
  std::string Adaptation = "bradford";
  std::string ChannelLabel;
};
#endif
