// Kinds of files, recognised by their content.
export const isYaml = (name: string): boolean => /\.ya?ml$/i.test(name);

/** A text data file of OrcaFlex: its groups at the beginning of a line, and not the first key of our models. */
export const isOrcaFlex = (text: string): boolean => !/^overbend:/m.test(text) && /^(General|Environment|VesselTypes|LineTypes|Lines|(- )?includefile|BaseFile):/m.test(text);
