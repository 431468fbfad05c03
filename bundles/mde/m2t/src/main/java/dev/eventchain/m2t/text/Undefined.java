package dev.eventchain.m2t.text;

import dev.eventchain.ocl.evaluation.Invalid;

/** What an undefined value counts as, where it is asked for: the same as in Acceleo 3. */
public enum Undefined {
  /** The text of an expression. */
  TEXT("It counts as the text '" + Undefined.SHOWN + "'."),
  /** A condition of a template or a loop's item. */
  GUARD("It counts as false."),
  /** What a block goes by: its condition, collection or variable. */
  BLOCK("Its block is left out."),
  /** The name, mode or charset of a file. */
  FILE("The file is left out."),
  /** The id of a protected area. */
  AREA("The protected area is left out.");

  private static final String SHOWN = "invalid";

  private final String consequence;

  Undefined(String consequence) {
    this.consequence = consequence;
  }

  /** What becomes of it, as a sentence. */
  public String consequence() {
    return consequence;
  }

  /** The text of a value, undefined or not. */
  public static String textOf(Object value) {
    return value instanceof Invalid ? SHOWN : Texts.of(value);
  }
}
