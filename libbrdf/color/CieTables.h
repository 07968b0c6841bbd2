#pragma once
#include <brdf/brdf_export.h>

#include <span>

namespace brdf {

/// One line of the CIE tables.
struct CieSample {
  double wavelength;        ///< nanometres
  double xBar, yBar, zBar;  ///< CIE 1931 2-degree colour-matching functions
  double d65;               ///< relative spectral power of CIE standard illuminant D65, 100 at 560 nm
};

/// CIE 1931 2-degree colour-matching functions (ISO/CIE 11664-1, data set DOI 10.25039/CIE.DS.xvudnb9b) and standard
/// illuminant D65 (ISO/CIE 11664-2, data set DOI 10.25039/CIE.DS.hjfjmt59), every 5 nm from 380 to 780 nm, ascending.
BRDF_EXPORT std::span<const CieSample> cieTable();

/// The table at any wavelength (nanometres), linear between its lines; all zero outside 380..780 nm.
BRDF_EXPORT CieSample cieAt(double wavelength);

}  // namespace brdf
