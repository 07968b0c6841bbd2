#pragma once
#include <brdf/brdf_export.h>
#include <brdf/material/Brdf.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf {

/// How another program is asked for values; docs/external-programs.md is the protocol.
struct ProgramOptions {
  std::vector<std::string> command;  ///< the program (looked for along PATH) and its arguments, as they are: no shell
  /// What its columns mean; empty: learnt from the program, which is asked for one value when the BRDF is made.
  std::optional<Channels> channels;
  Symmetry symmetry = Symmetry::Anisotropic;  ///< what the caller vouches for; tables and fits use it
  bool reciprocal = false;                    ///< likewise
  bool stays = false;         ///< true: started once, and asked batch by batch; false: started for each batch
  double timeLimit = 300;     ///< seconds without a sign of the program before it is ended; 0: wait for ever
  std::size_t processes = 0;  ///< most that run at a time; 0: as many as there are threads
};

/// "[OPTION...] PROGRAM [ARGUMENT...]" as in the material "program:OPTION... PROGRAM ARGUMENT...". Words are separated
/// by blanks; '...' and "..." hold words with blanks together, and a backslash takes the next character as it is
/// (outside '...'). Nothing else is special: no variables, patterns or redirections. Options: --channels mono, rgb or
/// wavelengths in nm separated by commas; --symmetry isotropic, bilateral or anisotropic; --reciprocal; --stay;
/// --time-limit SECONDS; --processes N; -- ends
/// them. Throws Error::Kind::Value.
BRDF_EXPORT ProgramOptions parseProgram(std::string_view text);
/// The text that parseProgram reads as `options`.
BRDF_EXPORT std::string programText(const ProgramOptions& options);

/// The BRDF that a program computes: each batch of directions is handed to it, and nothing is kept. Evaluating it
/// throws Error::Kind::Value, in one line with what the program wrote to its standard error, when the program fails,
/// falls silent, or prints what is no value. Evaluated by several threads at a time, it runs in several processes.
///
/// Throws Error::Kind::Value for options that cannot be, and Error::Kind::File for a program that is not there.
BRDF_EXPORT BrdfPointer programBrdf(ProgramOptions options);

}  // namespace brdf
