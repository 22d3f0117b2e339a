/// Wavelengths of linear and Stokes waves, breaking height of regular waves, and peakedness of a sea.
#pragma once

namespace overbend {

/// Returns the wave number [1/m] of a linear wave: omega^2 = g k tanh(k d) to machine precision. 0 for omega = 0.
double linear_wave_number(double omega, double depth);

/// Coefficients of the Stokes wave of fifth order for one k d [fenton1985, table 1]. A_ij are given times cosh(j k d),
/// which stays finite in deep water: the part of the potential's j-th harmonic at still water level.
struct StokesCoefficients {
  double a11, a22, a31, a33, a42, a44, a51, a53, a55;
  double b22, b31, b42, b44, b53, b55;
  double c0, c2, c4;
};
StokesCoefficients stokes_coefficients(double kd);

/// Returns the wave number [1/m] of the fifth-order Stokes wave of this height and period over water without mean
/// Eulerian current [fenton1985, eq. 23]. Throws std::domain_error if there is none, or it would break.
double stokes_wave_number(double height, double period, double depth);

/// Returns the height [m] at which a regular wave of this length breaks on a level seabed: fit of the highest waves
/// computed exactly [fenton1990]; 0.142 L in deep and 0.83 d in shallow water.
double highest_wave(double length, double depth);

/// Returns H L^2 / d^3. Stokes theory applies below `kStokesUrsell`; above, cnoidal theory [fenton1990].
double ursell_number(double height, double length, double depth);
inline constexpr double kStokesUrsell = 40.0;

/// Returns the peak enhancement factor of the JONSWAP spectrum for a sea state [dnvc205]; hs [m], tp [s].
double jonswap_gamma(double hs, double tp);

/// Returns the Pierson-Moskowitz density over frequencies in peak frequencies, of unit integral, times the peak
/// enhancement of JONSWAP [dnvc205]; 0 for x <= 0.
double jonswap_shape(double x, double gamma);

}  // namespace overbend
