package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;

/**
 * Words of a requirement that a criterion judges.
 *
 * @param criterion the location of the criterion
 * @param requirement the requirement's id
 * @param words as the scenario quotes them
 * @param location of the words
 */
public record JudgedWords(
    SourceLocation criterion, String requirement, String words, SourceLocation location) {

  /** Returns whether a text has these words, however its lines are broken. */
  public boolean areIn(String text) {
    return plain(text).contains(plain(words));
  }

  private static String plain(String text) {
    return text.strip().replaceAll("\\s+", " ");
  }
}
