package dev.eventchain.documents;

import dev.eventchain.diagnostics.Rule;

/**
 * Rules of the findings about a kind of file.
 *
 * @param syntax a text that is not JSON or YAML, or uses unsupported features
 * @param duplicate a duplicate key in an object
 * @param type a value of the wrong type
 * @param missing a missing required value
 * @param unknown an unknown key
 * @param range a value of the right type that is out of range
 */
public record DocumentRules(
    Rule syntax, Rule duplicate, Rule type, Rule missing, Rule unknown, Rule range) {

  /** Returns one rule for everything. */
  public static DocumentRules all(Rule rule) {
    return new DocumentRules(rule, rule, rule, rule, rule, rule);
  }
}
