package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.Rule;

/** Properties of rules about the generation of files. */
enum GenerationTrait implements Rule.Trait {
  /** A template or a Java service gave no value; the rest of the files is complete. */
  UNDEFINED
}
