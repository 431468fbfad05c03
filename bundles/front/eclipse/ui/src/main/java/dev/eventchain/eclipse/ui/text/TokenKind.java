package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.ui.EventchainUi;
import java.util.Locale;

/** What a piece of a text is, as far as it has its own colour. */
public enum TokenKind {
  /** Text of a template that is copied as it is. */
  TEXT,
  /** Names and operators. */
  CODE,
  KEYWORD,
  /** A class of a metamodel, or a type of OCL. */
  TYPE,
  STRING,
  NUMBER,
  COMMENT,
  /** The brackets of a template's tag, with the keyword of a block or a declaration. */
  TAG;

  /** The definition of its colour in the theme; of {@code TEXT} and {@code CODE} there is none. */
  String color() {
    return EventchainUi.ID + ".text." + name().toLowerCase(Locale.ROOT);
  }
}
