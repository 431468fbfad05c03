package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.ui.EventchainUi;
import java.util.Locale;

/** Kinds of words that have their own colour. */
enum TokenKind {
  KEYWORD,
  /** A class of a metamodel, or a type of OCL. */
  TYPE,
  STRING,
  NUMBER,
  COMMENT,
  /** The brackets of a template tag. */
  TAG;

  /** Returns the identifier of its colour in the theme. */
  String color() {
    return EventchainUi.ID + ".text." + name().toLowerCase(Locale.ROOT);
  }
}
