package dev.eventchain.m2t.text;

import dev.eventchain.ocl.evaluation.Invalid;

/** Substitutes of an undefined value by its use, as in Acceleo 3. */
public enum Undefined {
  /** The text of an expression. */
  TEXT("It counts as the text '" + Undefined.SHOWN + "'."),
  /** A condition of a template or a loop's item. */
  GUARD("It counts as false."),
  /** The condition, collection or variable of a block. */
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

  /** Returns the consequence, as a sentence. */
  public String consequence() {
    return consequence;
  }

  /** Returns the text of a value, undefined or not. */
  public static String textOf(Object value) {
    return value instanceof Invalid ? SHOWN : Texts.of(value);
  }
}
