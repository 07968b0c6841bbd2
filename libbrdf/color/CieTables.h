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

struct ObserverSample {
  double wavelength;        ///< nanometres
  double xBar, yBar, zBar;  ///< CIE 1964 10-degree colour-matching functions
};

/// CIE 1964 10-degree colour-matching functions (ISO/CIE 11664-1, data set DOI 10.25039/CIE.DS.sqksu2n5), every 5 nm
/// from 380 to 780 nm, ascending.
BRDF_EXPORT std::span<const ObserverSample> cie1964Table();

struct DaylightSample {
  double wavelength;  ///< nanometres
  double s0, s1, s2;  ///< the mean and the first two components of daylight spectra
};

/// Components of daylight (CIE 15:2004, table T.2), every 10 nm from 380 to 780 nm; between them they are linear.
BRDF_EXPORT std::span<const DaylightSample> daylightTable();

struct FluorescentSample {
  double wavelength;   ///< nanometres
  double f2, f7, f11;  ///< relative spectral power of FL 2, FL 7 and FL 11
};

/// Fluorescent lamps of CIE 15:2004 (illuminants FL 1 to FL 12; colours of table T.8), every 5 nm from 380 to 780 nm,
/// each value with what mercury lines fall into its 5 nm.
BRDF_EXPORT std::span<const FluorescentSample> fluorescentTable();

}  // namespace brdf
