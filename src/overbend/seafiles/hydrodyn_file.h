/// Input file of HydroDyn, the hydrodynamics of OpenFAST: it names the WAMIT files of a hull and how they are meant.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "seafiles/hull_statements.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Statements of the file about the WAMIT files.
struct HydroDynFile {
  std::string stem;            ///< PotFile, in the folder of the file.
  HydrodynamicsSource source;  ///< That of the user, with WtrDens, WAMITULEN and the gravity of OpenFAST.
  HullStatements statements;   ///< Values about the water line, stiffness without weight.
  std::string gravity_note;    ///< Sentence on the gravity; empty if the user states it.
};

/// Reads the file. Gravity stands in another file of OpenFAST: 9.80665 m/s^2 unless the user states it. Throws
/// HullFileError.
HydroDynFile read_hydrodyn_file(const HydrodynamicsSource& source);

}  // namespace overbend
